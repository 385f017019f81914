#include "engine/ui/ui_context.h"

#define GLFW_INCLUDE_NONE  // OpenGL is declared by the loader
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

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

UiContext::UiContext(GLFWwindow* window, float scale) {
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
  ImGui_ImplGlfw_InitForOpenGL(window, true);
  ImGui_ImplOpenGL3_Init("#version 450 core");
}

UiContext::~UiContext() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

void UiContext::beginFrame() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
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
void UiContext::leaveField() {
  ImGui::ClearActiveID();
}

}  // namespace macula::ui
