// Keys, text and the pointer in the order in which they came, however long a frame lasts.
#pragma once

#include <deque>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <utility>

namespace macula::window {

/// One thing that the user did. Codes of keys, buttons and modifiers are those of GLFW.
struct InputEvent {
  enum class Kind { Key, Text, Button, Pointer, Wheel, Enter, Focus };
  Kind kind = Kind::Text;
  int code = 0;  ///< key or button
  int scancode = 0;
  int modifiers = 0;      ///< held with a key or a button
  bool down = false;      ///< pressed; pointer entered; window has the keyboard
  glm::dvec2 place{0.0};  ///< of the pointer, screen coordinates of the window; steps of the wheel
  std::u32string text{};  ///< typed, by this key press or without one that is known
};

/// First in, first out. Moves of the pointer and turns of the wheel without anything in between
/// become one, so that a slow frame finds no more events than it has to tell apart.
class InputQueue {
 public:
  void push(InputEvent event) {
    if (!events_.empty() && events_.back().kind == event.kind) {
      if (event.kind == InputEvent::Kind::Pointer) {
        events_.back().place = event.place;
        return;
      }
      if (event.kind == InputEvent::Kind::Wheel) {
        events_.back().place += event.place;
        return;
      }
    }
    events_.push_back(std::move(event));
  }

  /// A character: part of the key press that came just before, as the window system sends them.
  void type(char32_t character) {
    const bool follows =
        !events_.empty() && (events_.back().kind == InputEvent::Kind::Text ||
                             (events_.back().kind == InputEvent::Kind::Key && events_.back().down));
    if (!follows) events_.push_back({.kind = InputEvent::Kind::Text});
    events_.back().text += character;
  }

  /// The oldest event; none where there is none.
  [[nodiscard]] std::optional<InputEvent> take() {
    if (events_.empty()) return {};
    InputEvent event = std::move(events_.front());
    events_.pop_front();
    return event;
  }
  [[nodiscard]] bool empty() const { return events_.empty(); }

 private:
  std::deque<InputEvent> events_;
};

}  // namespace macula::window
