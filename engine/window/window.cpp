#include "engine/window/window.h"

#include <GLFW/glfw3.h>

#include <cstdlib>

#include "engine/core/error.h"

namespace macula::window {
namespace {

std::string glfwReason() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text == nullptr ? "no reason given" : text;
}

}  // namespace

Window::Window(const Settings& settings) {
  if (glfwInit() != GLFW_TRUE) {
    failInput(
        "no display to open a window on ({}); set DISPLAY, or use 'macula replay' without one",
        glfwReason());
  }
  glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_API);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, settings.debug ? GLFW_TRUE : GLFW_FALSE);
  // The frame has its own depth; the window needs only colour.
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  window_ =
      glfwCreateWindow(settings.width, settings.height, settings.title.c_str(), nullptr, nullptr);
  if (window_ == nullptr) {
    const std::string reason = glfwReason();
    glfwTerminate();
    failInput(
        "no window with OpenGL 4.5 core ({}); use a newer driver, or 'macula replay' without "
        "a window",
        reason);
  }
  glfwSetWindowSizeLimits(window_, settings.leastWidth, settings.leastHeight, GLFW_DONT_CARE,
                          GLFW_DONT_CARE);
  glfwSetWindowUserPointer(window_, this);
  listen();
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(settings.vsync ? 1 : 0);
}

void Window::listen() {
  using Kind = InputEvent::Kind;
  static constexpr auto inputOf = [](GLFWwindow* handle) -> InputQueue& {
    return static_cast<Window*>(glfwGetWindowUserPointer(handle))->input_;
  };
  glfwSetDropCallback(window_, [](GLFWwindow* handle, int count, const char** paths) {
    const auto* self = static_cast<const Window*>(glfwGetWindowUserPointer(handle));
    if (self->drop_) self->drop_({paths, paths + count});
  });
  glfwSetKeyCallback(window_, [](GLFWwindow* handle, int key, int code, int action, int modifiers) {
    if (action == GLFW_REPEAT) return;  // of interest for text alone, which comes by itself
    inputOf(handle).push({.kind = Kind::Key,
                          .code = key,
                          .scancode = code,
                          .modifiers = modifiers,
                          .down = action == GLFW_PRESS});
  });
  glfwSetCharCallback(
      window_, [](GLFWwindow* handle, unsigned int character) { inputOf(handle).type(character); });
  glfwSetMouseButtonCallback(window_,
                             [](GLFWwindow* handle, int button, int action, int modifiers) {
                               inputOf(handle).push({.kind = Kind::Button,
                                                     .code = button,
                                                     .modifiers = modifiers,
                                                     .down = action == GLFW_PRESS});
                             });
  glfwSetCursorPosCallback(window_, [](GLFWwindow* handle, double x, double y) {
    inputOf(handle).push({.kind = Kind::Pointer, .place = {x, y}});
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* handle, double x, double y) {
    inputOf(handle).push({.kind = Kind::Wheel, .place = {x, y}});
  });
  glfwSetCursorEnterCallback(window_, [](GLFWwindow* handle, int entered) {
    inputOf(handle).push({.kind = Kind::Enter, .down = entered == GLFW_TRUE});
  });
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* handle, int focused) {
    inputOf(handle).push({.kind = Kind::Focus, .down = focused == GLFW_TRUE});
  });
}

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

bool Window::shouldClose() const {
  return glfwWindowShouldClose(window_) == GLFW_TRUE;
}
void Window::requestClose() {
  glfwSetWindowShouldClose(window_, GLFW_TRUE);
}
void Window::pollEvents() {
  glfwPollEvents();
}
void Window::waitEvents(double seconds) {
  glfwWaitEventsTimeout(seconds);
}
void Window::setTitle(const std::string& title) {
  glfwSetWindowTitle(window_, title.c_str());
}
void Window::hide() {
  glfwHideWindow(window_);
}
void Window::setClipboard(const std::string& text) {
  glfwSetClipboardString(window_, text.c_str());
}
void Window::swap() {
  glfwSwapBuffers(window_);
}

glm::ivec2 Window::framebufferSize() const {
  glm::ivec2 size{0};
  glfwGetFramebufferSize(window_, &size.x, &size.y);
  return size;
}

glm::vec2 Window::pointer() const {
  double x = 0.0;
  double y = 0.0;
  int width = 1;
  int height = 1;
  glfwGetCursorPos(window_, &x, &y);
  glfwGetWindowSize(window_, &width, &height);
  // Screen coordinates on both sides, so the content scale cancels.
  return {static_cast<float>(x / width), static_cast<float>(y / height)};
}

Window::Placement Window::placement(int monitor) const {
  Placement placement;
  glm::ivec2 origin{0};
  glm::ivec2 size{0};
  glfwGetWindowPos(window_, &origin.x, &origin.y);
  glfwGetWindowSize(window_, &size.x, &size.y);
  placement.clientOrigin = origin;
  placement.clientSize = size;
  if (size.x > 0) placement.pixelsPerUnit = static_cast<double>(framebufferSize().x) / size.x;
  const glm::dvec2 middle = placement.clientOrigin + 0.5 * placement.clientSize;

  int count = 0;
  GLFWmonitor** monitors = glfwGetMonitors(&count);
  for (int i = 0; i < count; ++i) {
    const GLFWvidmode* mode = glfwGetVideoMode(monitors[i]);
    if (mode == nullptr) continue;
    glm::ivec2 place{0};
    glfwGetMonitorPos(monitors[i], &place.x, &place.y);
    const glm::dvec2 low = place;
    const glm::dvec2 extent{mode->width, mode->height};
    const bool holds = glm::all(glm::greaterThanEqual(middle, low)) &&
                       glm::all(glm::lessThan(middle, low + extent));
    const bool first = placement.monitorSize.x <= 0.0;
    if (monitor > 0 ? i < monitor : holds || first) {
      placement.monitorOrigin = low;
      placement.monitorSize = extent;
      if (monitor == 0 && holds) break;
    }
  }
  return placement;
}

bool displayAvailable() {
  const char* x11 = std::getenv("DISPLAY");
  const char* wayland = std::getenv("WAYLAND_DISPLAY");
  return (x11 != nullptr && *x11 != '\0') || (wayland != nullptr && *wayland != '\0');
}

}  // namespace macula::window
