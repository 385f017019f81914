// A GLFW window with an OpenGL 4.5 core context.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <utility>
#include <vector>

#include "engine/window/input_queue.h"

struct GLFWwindow;

namespace macula::window {

/// One window; its context is current on the thread that made it.
class Window {
 public:
  struct Settings {
    int width = 1280;  ///< client area, screen coordinates
    int height = 720;
    std::string title = "Macula";
    bool debug = false;  ///< debug context
    bool vsync = true;
    int leastWidth = 1;  ///< what the user can shrink the window to, screen coordinates
    int leastHeight = 1;
  };
  /// Takes the paths of files that were dropped on the window.
  using DropHandler = std::function<void(std::vector<std::string>)>;
  /// @throws InputError where there is no display or it offers no OpenGL 4.5
  explicit Window(const Settings& settings);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  [[nodiscard]] GLFWwindow* handle() const { return window_; }
  [[nodiscard]] bool shouldClose() const;
  void requestClose();
  void pollEvents();
  /// Waits for an event, but no longer than this; then as pollEvents().
  void waitEvents(double seconds);
  void setTitle(const std::string& title);
  /// What the user did until the last pollEvents() or waitEvents().
  [[nodiscard]] InputQueue& input() { return input_; }
  [[nodiscard]] const InputQueue& input() const { return input_; }
  /// Called from pollEvents() and waitEvents().
  void onDrop(DropHandler handler) { drop_ = std::move(handler); }
  void hide();
  void setClipboard(const std::string& text);
  void swap();
  [[nodiscard]] glm::ivec2 framebufferSize() const;  ///< pixels
  /// Pointer position, 0..1 of the client area from the top left; outside it beyond 0..1.
  [[nodiscard]] glm::vec2 pointer() const;
  /// Where a display and the inside of the window lie, in screen coordinates.
  struct Placement {
    glm::dvec2 monitorOrigin{0.0};
    glm::dvec2 monitorSize{0.0};
    glm::dvec2 clientOrigin{0.0};
    glm::dvec2 clientSize{0.0};
    double pixelsPerUnit = 1.0;  ///< device pixels to one screen coordinate
  };
  /// @param monitor 0: the one that holds the window's middle; n: the n-th, or the last where there
  ///   are fewer. Where the window system tells no positions (Wayland), the window counts as at the
  ///   origin.
  [[nodiscard]] Placement placement(int monitor) const;

 private:
  void listen();

  GLFWwindow* window_ = nullptr;
  DropHandler drop_;
  InputQueue input_;
};

/// Whether a display can be opened (X11 or Wayland).
[[nodiscard]] bool displayAvailable();

}  // namespace macula::window
