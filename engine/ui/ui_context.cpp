#include "engine/ui/ui_context.h"

#define GLFW_INCLUDE_NONE  // OpenGL is declared by the loader
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <iterator>

#include "engine/gl/gl.h"

namespace macula::ui {
namespace {

void applyStyle(float scale) {
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 4.0F;
  style.FrameRounding = 3.0F;
  style.WindowBorderSize = 0.0F;
  style.ItemSpacing = {6.0F, 4.0F};
  // Text stays readable over a bright image, and the image can be guessed behind it.
  style.Colors[ImGuiCol_WindowBg] = {0.07F, 0.08F, 0.10F, 0.90F};
  // The panels stand where they are; none is in front.
  style.Colors[ImGuiCol_TitleBgActive] = style.Colors[ImGuiCol_TitleBg];
  style.Colors[ImGuiCol_TitleBgCollapsed] = style.Colors[ImGuiCol_WindowBg];
  style.Colors[ImGuiCol_PlotLines] = {0.45F, 0.78F, 0.95F, 1.0F};
  style.Colors[ImGuiCol_PlotHistogram] = {0.28F, 0.55F, 0.80F, 1.0F};
  style.ScaleAllSizes(scale);
}

/// The built-in font is a bitmap of 13 pixels: it stays sharp at whole multiples.
void addFont(float scale) {
  constexpr float kFontPixels = 13.0F;
  ImFontConfig config;
  config.SizePixels = kFontPixels * std::max(1.0F, std::round(scale));
  ImGui::GetIO().Fonts->AddFontDefault(&config);
}

/// Pixels of the framebuffer for each screen coordinate of the window.
float pixelsPerCoordinate(GLFWwindow* window) {
  int coordinates = 0;
  int pixels = 0;
  glfwGetWindowSize(window, &coordinates, nullptr);
  glfwGetFramebufferSize(window, &pixels, nullptr);
  if (coordinates <= 0 || pixels <= 0) return 1.0F;
  return static_cast<float>(pixels) / static_cast<float>(coordinates);
}

}  // namespace

UiContext::UiContext(GLFWwindow* window, float scale) : window_(window) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  ImGui::GetIO().LogFilename = nullptr;
  if (scale <= 0.0F) {
    float scaleY = 1.0F;
    glfwGetWindowContentScale(window, &scale, &scaleY);
  }
  // Where a screen coordinate is several pixels wide, the UI counts in those coordinates, and only
  // the font's bitmap needs the pixels.
  const float pixels = pixelsPerCoordinate(window);
  applyStyle(scale / pixels);
  addFont(scale);
  ImGui::GetIO().FontGlobalScale = 1.0F / pixels;
  // Events come through beginFrame(): the backend's own callbacks would keep only the last state.
  ImGui_ImplGlfw_InitForOpenGL(window, false);
  ImGui_ImplOpenGL3_Init("#version 450 core");
}

UiContext::~UiContext() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

void UiContext::feed(const window::InputEvent& event) {
  using Kind = window::InputEvent::Kind;
  ImGuiIO& io = ImGui::GetIO();
  switch (event.kind) {
    case Kind::Key:
      ImGui_ImplGlfw_KeyCallback(window_, event.code, event.scancode,
                                 event.down ? GLFW_PRESS : GLFW_RELEASE, event.modifiers);
      break;
    case Kind::Text:
      break;
    case Kind::Button:
      if (event.code >= 0 && static_cast<std::size_t>(event.code) < kButtons) {
        buttons_[static_cast<std::size_t>(event.code)] = event.down;
      }
      break;
    case Kind::Pointer:
      pointer_ = event.place;
      break;
    case Kind::Wheel:
      ImGui_ImplGlfw_ScrollCallback(window_, event.place.x, event.place.y);
      break;
    case Kind::Enter:
      ImGui_ImplGlfw_CursorEnterCallback(window_, event.down ? GLFW_TRUE : GLFW_FALSE);
      if (!event.down) pointer_.reset();
      break;
    case Kind::Focus:
      ImGui_ImplGlfw_WindowFocusCallback(window_, event.down ? GLFW_TRUE : GLFW_FALSE);
      break;
  }
  for (const char32_t character : event.text) io.AddInputCharacter(character);
}

void UiContext::beginFrame(const window::InputEvent* event) {
  if (event != nullptr) feed(*event);
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGuiIO& io = ImGui::GetIO();
  // The backend has asked for the pointer as it is now; the event's place and buttons are those of
  // its own time.
  static_assert(sizeof(io.MouseDown) == sizeof(buttons_));
  std::copy(buttons_.begin(), buttons_.end(), std::begin(io.MouseDown));
  const bool known = io.MousePos.x > -FLT_MAX;
  if (known && pointer_) {
    io.MousePos = {static_cast<float>(pointer_->x), static_cast<float>(pointer_->y)};
  }
  // Dear ImGui asserts that time has passed, which a coarse clock does not show.
  constexpr float kLeastSeconds = 1e-6F;
  io.DeltaTime = std::max(io.DeltaTime, kLeastSeconds);
  ImGui::NewFrame();
}

void UiContext::skipFrame() {
  ImGui::EndFrame();
}

void UiContext::endFrame() {
  ImGui::Render();
  // Colours of the style are display values already.
  glDisable(GL_FRAMEBUFFER_SRGB);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

bool UiContext::wantsPointer() const {
  return ImGui::GetIO().WantCaptureMouse;
}
bool UiContext::wantsKeyboard() const {
  return ImGui::GetIO().WantTextInput;
}
void UiContext::dropText() {
  ImGui::GetIO().ClearInputCharacters();
}
void UiContext::leaveField() {
  ImGui::ClearActiveID();
}

}  // namespace macula::ui
