#include "walk_session.h"

#define GLFW_INCLUDE_NONE  // OpenGL is declared by the loader
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "common.h"
#include "engine/core/error.h"
#include "walk_report.h"

namespace macula::tools {
namespace {

constexpr float kRadiansPerHeight = 1.6F;  ///< turn for a drag over the window's height
constexpr float kRadiansPerSecond = 1.2F;  ///< turn by the arrow keys
constexpr float kWheelStep = 1.2F;         ///< factor of the speed for a notch of the wheel
/// A minimised window looks for its return this often.
constexpr double kMinimisedWaitSeconds = 0.1;

float secondsBetween(std::chrono::steady_clock::time_point a,
                     std::chrono::steady_clock::time_point b) {
  return std::chrono::duration<float>(b - a).count();
}

}  // namespace

WalkSession::WalkSession(WalkOptions& options, window::Window& window, const scene::GpuScene& gpu,
                         const scene::Camera& start, std::vector<glm::vec2> probes)
    : options_(options),
      window_(window),
      probes_(std::move(probes)),
      ui_(window.handle()),
      renderer_(options.settings, machine_),
      camera_(start, gpu.bounds().radius()),
      panels_(options.registry, options.settings, options.scene),
      panelsShown_(!options.hidePanels) {
  renderer_.setScene(gpu);
  if (!options.record.empty()) {
    recorder_.emplace(recordStartOf(options, window), options.registry, machine_, renderer_);
  }
}

void WalkSession::run() {
  while (!window_.shouldClose() && (options_.frames == 0 || frames_ < options_.frames)) {
    window_.pollEvents();
    const glm::ivec2 size = window_.framebufferSize();
    if (size.x <= 0 || size.y <= 0) {
      glfwWaitEventsTimeout(kMinimisedWaitSeconds);
      continue;
    }
    if (size != size_) renderer_.resize(size);
    size_ = size;
    frame();
  }
}

void WalkSession::frame() {
  const Clock::time_point now = Clock::now();
  ui_.beginFrame();
  readKeys();
  steer(secondsBetween(last_, now));
  followPointer();
  last_ = now;
  frameSeconds_ = std::chrono::duration<double>(now - begin_).count();
  point_ = gaze_.at(frameSeconds_);
  draw();
  ++frames_;
  screen_.show(renderer_.resources().texture(frame::Resource::DisplayColor));
  showPanels();
  // A window that is closed has drawn its last frame as well.
  if (frames_ == options_.frames || window_.shouldClose()) finish();
  window_.swap();
}

void WalkSession::readKeys() {
  if (ui_.wantsKeyboard()) return;
  const auto pressed = [](int key) { return ImGui::IsKeyPressed(key, false); };
  if (pressed(GLFW_KEY_F1)) panelsShown_ = !panelsShown_;
  if (pressed(GLFW_KEY_M)) panels_.settings().chooseNext("oit.method");
  if (pressed(GLFW_KEY_H)) panels_.settings().chooseNext("view.heatmap");
  if (pressed(GLFW_KEY_R)) {
    camera_.reset();
    cut_ = true;
  }
}

void WalkSession::lookAround(bool wanted) {
  if (wanted == looking_) return;
  looking_ = wanted;
  // Hidden and free of the window's edges while it turns the camera; back in its place afterwards.
  glfwSetInputMode(window_.handle(), GLFW_CURSOR,
                   wanted ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
  lastPointer_ = window_.pointer();
}

void WalkSession::steer(float seconds) {
  const bool rightButton = window_.mouseDown(GLFW_MOUSE_BUTTON_RIGHT);
  // A press that began on a panel belongs to the panel.
  lookAround(rightButton && (looking_ || !ui_.wantsPointer()));
  FlyCamera::Motion motion;
  if (looking_) {
    const glm::vec2 pointer = window_.pointer();
    const glm::vec2 moved = pointer - lastPointer_;
    const float aspect = static_cast<float>(size_.x) / static_cast<float>(size_.y);
    motion.turn = kRadiansPerHeight * glm::vec2(moved.x * aspect, -moved.y);
    lastPointer_ = pointer;
  }
  if (!ui_.wantsPointer()) {
    const float wheel = ImGui::GetIO().MouseWheel;
    if (wheel != 0.0F) camera_.scaleSpeed(std::pow(kWheelStep, wheel));
  }
  if (!ui_.wantsKeyboard()) {
    const auto axis = [&](int positive, int negative) {
      return static_cast<float>(window_.keyDown(positive)) -
             static_cast<float>(window_.keyDown(negative));
    };
    motion.move = {axis(GLFW_KEY_D, GLFW_KEY_A), axis(GLFW_KEY_E, GLFW_KEY_Q),
                   axis(GLFW_KEY_W, GLFW_KEY_S)};
    motion.turn += kRadiansPerSecond * seconds *
                   glm::vec2(axis(GLFW_KEY_RIGHT, GLFW_KEY_LEFT), axis(GLFW_KEY_UP, GLFW_KEY_DOWN));
    motion.fast = window_.keyDown(GLFW_KEY_LEFT_SHIFT) || window_.keyDown(GLFW_KEY_RIGHT_SHIFT);
  }
  camera_.advance(motion, seconds);
}

void WalkSession::followPointer() {
  // Over a panel the viewer reads the panel: what was looked at before stays in view beside it.
  if (looking_ || ui_.wantsPointer()) return;
  const glm::vec2 pointer = window_.pointer();
  const bool inside = glm::all(glm::greaterThanEqual(pointer, glm::vec2(0.0F))) &&
                      glm::all(glm::lessThanEqual(pointer, glm::vec2(1.0F)));
  // Until the pointer has been in the window, nobody can have meant anything by it.
  pointerSeen_ = pointerSeen_ || inside;
  if (!pointerSeen_) return;
  gaze_.move(pointer);
  if (recorder_) {
    recorder_->pointer(std::chrono::duration<double>(Clock::now() - begin_).count(), pointer);
  }
}

void WalkSession::draw() {
  if (auto change = panels_.settings().takeChange()) change_ = std::move(change);
  try {
    // resize() also checks what the settings make of the size.
    if (change_) renderer_.resize(size_);
    result_ = renderer_.render(camera_.camera(), point_, cut_);
  } catch (const InputError& error) {
    if (!change_) throw;
    change_->undo();
    panels_.settings().setRefusal(error.what());
    renderer_.resize(size_);
    result_ = renderer_.render(camera_.camera(), point_, true);
  }
  if (recorder_) recorder_->frame({.timeSeconds = frameSeconds_}, renderer_);
  change_.reset();
  cut_ = false;
  panels_.add(result_);
}

void WalkSession::showPanels() {
  if (panelsShown_) panels_.draw(renderer_, result_, point_.position);
  ui_.endFrame();
}

void WalkSession::finish() {
  if (!options_.screenshot.empty()) writeScreenshot(options_.screenshot, size_);
  if (options_.json.empty()) return;
  writeJson(options_.json,
            describeWalk(renderer_, options_.settings, result_, point_, probes_, frames_));
}

void walk(WalkOptions& options) {
  const glm::ivec2 size = parseSize(options.size);
  if (!options.record.empty()) recording::makeRecordingFolder(options.record);
  std::vector<glm::vec2> probes;
  for (const std::string& probe : options.probes) probes.push_back(parsePlace("--probe", probe));
  window::Window window({.width = size.x,
                         .height = size.y,
                         .title = fmt::format("Macula: loading {}", oneLine(options.scene))});
  LoadedScene loaded = loadForRendering(options.scene, options.settings);
  for (const std::string& warning : loaded.scene.warnings) {
    fmt::print(stderr, "warning: {}\n", oneLine(warning));
  }
  const scene::Camera start = loaded.scene.cameras.empty() ? scene::autoOrbit(loaded.scene).at(0.0)
                                                           : loaded.scene.cameras.front();
  const scene::GpuScene gpu(loaded.scene, loaded.environment ? &*loaded.environment : nullptr);
  loaded = {};  // it is in GPU memory now
  glfwSetWindowTitle(window.handle(), fmt::format("Macula: {}", oneLine(options.scene)).c_str());
  WalkSession(options, window, gpu, start, std::move(probes)).run();
}

}  // namespace macula::tools
