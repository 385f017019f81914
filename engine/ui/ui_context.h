// Dear ImGui on a GLFW window with OpenGL.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>

#include "engine/window/input_queue.h"

struct GLFWwindow;

namespace macula::ui {

/// The one Dear ImGui context of the program. Takes input event by event, because it compares the
/// states of keys and buttons from frame to frame: what comes and goes between two would be lost.
/// Writes no file: panels stand where the program puts them.
class UiContext {
 public:
  /// @param window its OpenGL context is current; it must outlive this object
  /// @param scale of text and distances; 0: the content scale of the window's monitor
  explicit UiContext(GLFWwindow* window, float scale = 0.0F);
  ~UiContext();
  UiContext(const UiContext&) = delete;
  UiContext& operator=(const UiContext&) = delete;

  /// Panels follow.
  /// @param event what the user did before this frame; null: nothing
  void beginFrame(const window::InputEvent* event = nullptr);
  /// Draws the panels into the default framebuffer.
  void endFrame();
  /// In place of endFrame(): another event comes before the next picture. The panels have taken
  /// this one in, and are not drawn.
  void skipFrame();

  /// Whether the pointer is over a panel or drags one of its widgets.
  [[nodiscard]] bool wantsPointer() const;
  /// Whether what is typed goes into a text field.
  [[nodiscard]] bool wantsKeyboard() const;
  /// What was typed with this frame's event is for no field: the key was a command.
  void dropText();
  /// Takes the keyboard from the field that has it; what was typed stays. Between beginFrame() and
  /// endFrame().
  void leaveField();

 private:
  static constexpr std::size_t kButtons = 5;  ///< that Dear ImGui tells apart
  void feed(const window::InputEvent& event);

  GLFWwindow* window_;
  std::array<bool, kButtons> buttons_{};
  std::optional<glm::dvec2> pointer_;  ///< where the last event put it, inside the window
};

}  // namespace macula::ui
