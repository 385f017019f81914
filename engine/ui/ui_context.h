// Dear ImGui on a GLFW window with OpenGL.
#pragma once

struct GLFWwindow;

namespace macula::ui {

/// The one Dear ImGui context of the program; input of the window reaches it through GLFW
/// callbacks. Writes no file: panels stand where the program puts them.
class UiContext {
 public:
  /// @param window its OpenGL context is current; it must outlive this object
  /// @param scale of text and distances; 0: the content scale of the window's monitor
  explicit UiContext(GLFWwindow* window, float scale = 0.0F);
  ~UiContext();
  UiContext(const UiContext&) = delete;
  UiContext& operator=(const UiContext&) = delete;

  /// After the window's events; panels follow.
  void beginFrame();
  /// Draws the panels into the default framebuffer.
  void endFrame();

  /// Whether the pointer is over a panel or drags one of its widgets.
  [[nodiscard]] bool wantsPointer() const;
  /// Whether what is typed goes into a text field.
  [[nodiscard]] bool wantsKeyboard() const;
  /// Takes the keyboard from the field that has it; what was typed stays. Between beginFrame() and
  /// endFrame().
  void leaveField();
};

}  // namespace macula::ui
