#include "walk/session.h"

#define GLFW_INCLUDE_NONE  // OpenGL is declared by the loader
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common.h"
#include "engine/gl/blocking.h"
#include "engine/image/image.h"
#include "engine/recording/writer.h"
#include "walk/report.h"

namespace macula::tools {
namespace {

constexpr float kRadiansPerHeight = 1.6F;  ///< turn for a drag over the window's height
constexpr float kRadiansPerSecond = 1.2F;  ///< turn by the arrow keys
/// A minimised window looks for its return this often.
constexpr double kMinimisedWaitSeconds = 0.1;
/// Between two frames of a window that only says what it loads.
constexpr double kLoadingWaitSeconds = 1.0 / 60.0;
constexpr glm::vec3 kLoadingColor{0.05F, 0.055F, 0.07F};

float secondsBetween(std::chrono::steady_clock::time_point a,
                     std::chrono::steady_clock::time_point b) {
  return std::chrono::duration<float>(b - a).count();
}

std::vector<glm::vec2> parseProbes(const std::vector<std::string>& texts) {
  std::vector<glm::vec2> probes;
  for (const std::string& text : texts) probes.push_back(parsePlace("--probe", text));
  return probes;
}

}  // namespace

WalkSession::WalkSession(WalkOptions& options, window::Window& window, GazeSources gazeSources)
    : options_(options),
      window_(window),
      probes_(parseProbes(options.probes)),
      script_(options.script.empty() ? Script() : readScript(options.script)),
      ui_(window.handle(), static_cast<float>(options.uiScale)),
      gaze_(std::move(gazeSources), options.gazeSettings),
      panels_(options.registry, !options.hidePanels, options.panel) {
  gaze_.cursorShown = !options.hidePanels;
  if (!options.camera.empty() && options.camera != "auto" && options.camera != "scene") {
    (void)readCamera(options.camera);  // an error in it is reported at once
  }
  gaze_.choose(options.gaze);
  window.onDrop([this](const std::vector<std::string>& paths) {
    for (const std::string& path : paths) requests_.push_back({Action::Drop, path});
  });
  loadScene(options.scene);
}

bool WalkSession::done() const {
  return window_.shouldClose() || (options_.frames > 0 && frames_ >= options_.frames);
}

bool WalkSession::busy() const {
  return loader_.busy() || !gaze_.opening().empty() || errors_.busy() || picture_.busy() ||
         !requests_.empty() || !window_.input().empty();
}

void WalkSession::run() {
  while (!done()) {
    if (scene_.gpu) {
      window_.pollEvents();
    } else {
      window_.waitEvents(kLoadingWaitSeconds);
    }
    const glm::ivec2 size = window_.framebufferSize();
    if (size.x <= 0 || size.y <= 0) {
      window_.waitEvents(kMinimisedWaitSeconds);
      rate_.restart();
      continue;
    }
    size_ = size;
    pollJobs();
    // Before any change is granted: the session's settings are those that the scene was loaded
    // with.
    if (scene_.gpu && !options_.record.empty() && events_.index == 0) beginRecording();
    takeInput();
    if (scene_.gpu) {
      frame();
    } else {
      loadingFrame();
    }
  }
  // A thread that still reads is waited for, but not in sight.
  window_.hide();
  sumUpRecordings();
}

void WalkSession::loadingFrame() {
  screen_.clear(kLoadingColor);
  if (loader_.busy()) panels_.drawLoading(loader_, false, requests_);
  ui_.endFrame();
  window_.swap();
  ++loadingFrames_;
  // The panel is on the screen by now (its first frame only finds its size), so that a pause for
  // compiling programs is no empty window.
  constexpr int kFramesUntilSeen = 2;
  if (!device_ && loadingFrames_ >= kFramesUntilSeen) {
    device_ = std::make_unique<passes::DeviceContext>();
    firstImage_ = std::make_unique<FirstImage>(screen_, [this] { window_.swap(); });
    renderer_ = std::make_unique<passes::FrameRenderer>(options_.settings, *device_);
    second_ = std::make_unique<SecondView>(options_.settings, *device_);
    control_ = std::make_unique<FrameControl>(options_.control, options_.settings, device_->time);
  }
}

void WalkSession::frame() {
  script_.due(frames_, requests_);
  grantRequests();
  cpuBegin_ = threadMs();
  const std::uint64_t blockedBefore = gl::blockingCount().total();
  prepareEvents(Clock::now());
  draw();
  if (!firstFrameMs_) firstFrameMs_ = 1e3 * secondsBetween(begin_, Clock::now());
  if (recorder_) record();
  compose();
  takeStills();
  drawOverlays();
  if (loader_.busy()) ++loadingFrames_;
  // A frame that waits for a thread, or whose requests wait for their turn, does not count, so that
  // scripts and --frames mean the same on any machine.
  if (!busy()) ++frames_;
  ui_.endFrame();
  measureTimes();
  blockingCalls_ = gl::blockingCount().total() - blockedBefore;
  // A window that is closed has drawn its last frame as well.
  if (done()) finish();
  window_.swap();
  rate_.presented(std::chrono::duration<double>(Clock::now() - begin_).count());
  events_.changed.clear();
  events_.sceneChanged = false;
  ++events_.index;
}

void WalkSession::prepareEvents(Clock::time_point now) {
  events_.timeSeconds = std::chrono::duration<double>(now - begin_).count();
  events_.deltaSeconds = secondsBetween(last_, now);
  last_ = now;
  noteTimes();
  events_.windowSize = size_;
  events_.pictureSize = second_->pictureSize(size_);
  events_.resized = events_.pictureSize != pictureSize_;
  pictureSize_ = events_.pictureSize;
  steer(events_.deltaSeconds);
  followPointer();
  placeGaze();
  events_.gaze = gaze_.at(events_.timeSeconds);
  events_.camera = camera_.camera();
  events_.cut = camera_.takeCut();
  events_.scene = scene_.name;
}

void WalkSession::measureTimes() {
  // Only what this thread works is the CPU's time: while it waits for the GPU or the display, no
  // time of it passes. With glFinish as the clock, what it does while it draws is in the times of
  // the passes.
  const bool finishes = result_.timed && device_->time.source == gl::TimeSource::Finish;
  const double cpuMs = threadMs() - cpuBegin_ - (finishes ? drawMs_ : 0.0);
  cpuHistory_.add({.frame = renderer_->steps().frames - 1,
                   .cpuMs = std::max(cpuMs, 0.0),
                   .othersMs = second_->shown() ? second_->result().totalMs : 0.0});
  drawnOnce_ = true;
}

void WalkSession::noteTimes() {
  if (!drawnOnce_) return;
  // A frame lasts until the next begins.
  cpuHistory_.end(renderer_->steps().frames - 1, 1e3 * static_cast<double>(events_.deltaSeconds));
  if (!resultNew_) return;
  if (const auto times = cpuHistory_.find(result_.frame)) {
    control_->note(result_, times->cpuMs, times->intervalMs - times->othersMs);
  }
}

void WalkSession::steer(float seconds) {
  FlyCamera::Motion motion;
  const double height = window_.placement(0).clientSize.y;
  if (height > 0.0) {
    motion.turn = kRadiansPerHeight * glm::vec2(looked_ / height) * glm::vec2(1.0F, -1.0F);
  }
  looked_ = {0.0, 0.0};
  const auto axis = [&](int positive, int negative) {
    return static_cast<float>(keys_.held(positive)) - static_cast<float>(keys_.held(negative));
  };
  motion.move = {axis(GLFW_KEY_D, GLFW_KEY_A), axis(GLFW_KEY_E, GLFW_KEY_Q),
                 axis(GLFW_KEY_W, GLFW_KEY_S)};
  motion.turn += kRadiansPerSecond * std::min(seconds, FlyCamera::kLongestStep) *
                 glm::vec2(axis(GLFW_KEY_RIGHT, GLFW_KEY_LEFT), axis(GLFW_KEY_UP, GLFW_KEY_DOWN));
  motion.fast = keys_.held(GLFW_KEY_LEFT_SHIFT) || keys_.held(GLFW_KEY_RIGHT_SHIFT);
  keys_.nextFrame();
  camera_.advance(motion, seconds);
}

void WalkSession::followPointer() {
  // Over a panel the viewer reads the panel: what was looked at before stays in view beside it.
  if (looking_ || ui_.wantsPointer()) return;
  glm::vec2 pointer = window_.pointer();
  const bool inside = glm::all(glm::greaterThanEqual(pointer, glm::vec2(0.0F))) &&
                      glm::all(glm::lessThanEqual(pointer, glm::vec2(1.0F)));
  // Until the pointer has been in the window, its place means nothing.
  pointerSeen_ = pointerSeen_ || inside;
  // Side by side, either half is a whole picture.
  if (inside && second_->mode() == ViewMode::SideBySide) {
    pointer.x = std::min(2.0F * pointer.x - (pointer.x >= 0.5F ? 1.0F : 0.0F), 1.0F);
  }
  if (pointerSeen_) gaze_.movePointer(pointer, events_.timeSeconds);
}

void WalkSession::finish() {
  if (!options_.screenshot.empty()) image::writePng(options_.screenshot, readScreen(size_));
  if (options_.json.empty()) return;
  // The report is of the last frame, all of whose numbers are asked for now.
  result_ = renderer_->waitForResult();
  second_->waitForResult();
  WalkReport report{
      .renderer = *renderer_,
      .result = result_,
      .settings = options_.settings,
      .events = events_,
      .second = *second_,
      .errors = errors_,
      .gazeSource = gaze_.spec(),
      .gazeWarnings = gaze_.recording() ? gaze_.recording()->warnings : std::vector<std::string>{},
      .tab = panels_.shown() ? panels_.tab() : std::string(),
      .searchHits = panels_.settings().hits(),
      .message = lastMessage_,
      .commandLine = commandLine(),
      .frames = frames_,
      .loadingFrames = loadingFrames_,
      .firstImageMs = firstImageMs_,
      .firstFrameMs = firstFrameMs_,
      .playing = camera_.playing(),
      .control = *control_,
      .framesPerSecond = rate_.perSecond(),
      .blockingCalls = blockingCalls_,
  };
  writeJson(options_.json, describeWalk(report, probes_));
}

void WalkSession::placeGaze() {
  const window::Window::Placement p = window_.placement(options_.gazeSettings.monitor);
  gaze_.place({.monitorOrigin = p.monitorOrigin,
               .monitorSize = p.monitorSize,
               .clientOrigin = p.clientOrigin,
               .clientSize = p.clientSize,
               .pixelsPerUnit = p.pixelsPerUnit});
}

void walk(WalkOptions& options) {
  // Panels need this much; a smaller window that was asked for is left as it is.
  constexpr int kLeastWidth = 640;
  constexpr int kLeastHeight = 480;
  const glm::ivec2 size = parseSize(options.size);
  if (!options.record.empty()) recording::makeRecordingFolder(options.record);
  window::Window window({.width = size.x,
                         .height = size.y,
                         .title = fmt::format("Macula: loading {}", oneLine(options.scene)),
                         .leastWidth = std::min(size.x, kLeastWidth),
                         .leastHeight = std::min(size.y, kLeastHeight)});
  WalkSession(options, window, allGazeSources()).run();
}

}  // namespace macula::tools
