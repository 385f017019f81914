#include "walk/recorder.h"

#define GLFW_INCLUDE_NONE  // OpenGL is declared by the loader
#include <GLFW/glfw3.h>
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <span>

#include "engine/core/sha256.h"
#include "engine/recording/scene_source.h"
#include "engine/ui/widgets.h"
#include "macula_version.h"
#include "recorded_controls.h"

namespace macula::tools {
namespace {

/// A setting's value; a path as one that holds in every folder.
settings::Value recordedValue(const settings::Entry& entry) {
  settings::Value value = entry.get();
  if (entry.type() != settings::Type::Path) return value;
  auto& path = std::get<std::string>(value);
  if (!path.empty()) path = std::filesystem::absolute(path).lexically_normal().string();
  return value;
}

recording::Session sessionOf(const RecordStart& start, const settings::Registry& registry,
                             const passes::DeviceContext& device) {
  recording::Session session;
  session.commit = MACULA_COMMIT;
  session.started = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  session.scene = start.scene;
  session.renderer = device.capabilities.renderer;
  session.version = device.capabilities.version;
  session.contentScale = start.contentScale;
  session.options = start.options;
  for (const settings::Entry& entry : registry.entries()) {
    session.settings.emplace_back(entry.key(), recordedValue(entry));
  }
  const settings::Entry* environment = registry.find("scene.environment");
  if (environment != nullptr && !environment->isDefault()) {
    session.environmentSha256 = fileSha256(std::get<std::string>(environment->get()));
  }
  return session;
}

}  // namespace

RecordStart recordStartOf(const WalkOptions& options, const window::Window& window) {
  RecordStart start;
  start.folder = options.record;
  start.hashes = options.recordHashes;
  start.scene = recording::sourceOf(options.scene);
  glfwGetWindowContentScale(window.handle(), &start.contentScale.x, &start.contentScale.y);
  start.options = {{"scene", options.scene},
                   {"size", options.size},
                   {"gaze", options.gaze},
                   {"frames", std::to_string(options.frames)}};
  return start;
}

WalkRecorder::WalkRecorder(const RecordStart& start, const settings::Registry& registry,
                           const passes::DeviceContext& device, passes::FrameRenderer& renderer)
    : registry_(registry),
      hashes_(start.hashes),
      writer_(start.folder, sessionOf(start, registry, device)),
      steps_(renderer.steps()) {
  for (const settings::Entry& entry : registry.entries()) values_.push_back(entry.get());
  renderer.restart();
}

void WalkRecorder::noteSettings() {
  frame_.settings.clear();
  auto before = values_.begin();
  for (const settings::Entry& entry : registry_.entries()) {
    settings::Value now = entry.get();
    if (now != *before) {
      frame_.settings.emplace_back(entry.key(), recordedValue(entry));
      *before = std::move(now);
    }
    ++before;
  }
}

void WalkRecorder::noteSteps(const passes::RendererSteps& steps) {
  using recording::Reset;
  frame_.reset = steps.restarts != steps_.restarts ? Reset::Restart
                 : steps.scenes != steps_.scenes   ? Reset::Scene
                 : steps.resets != steps_.resets   ? Reset::History
                                                   : Reset::None;
  frame_.unrecorded = steps.frames - steps_.frames - 1;
  steps_ = steps;
}

void WalkRecorder::frame(const RecordedFrame& events, const passes::FrameRenderer& renderer) {
  if (renderer.steps().frames == steps_.frames) return;  // nothing was drawn
  noteSettings();
  noteSteps(renderer.steps());
  if (frame_.index == 0) firstSeconds_ = events.timeSeconds;
  frame_.timeSeconds = events.timeSeconds;
  frame_.size = renderer.outputSize();
  frame_.cut = renderer.wasCut();
  frame_.scene = events.scene != nullptr ? *events.scene : recording::SceneSource{};
  frame_.camera = renderer.inputs().view.camera;
  frame_.gaze = renderer.inputs().gaze;
  frame_.r = events.r;
  frame_.controls = recordedControls(renderer.inputs().controls);
  if (hashes_) {
    renderer.readDisplay(pixels_);
    frame_.imageSha256 = sha256Hex(std::as_bytes(std::span(pixels_)));
  }
  writer_.frame(frame_);
  ++frame_.index;
}

std::string WalkRecorder::facts() const {
  return fmt::format("{}, {:.1f} s, {}", ui::numberOf(frame_.index, "frame"),
                     frame_.timeSeconds - firstSeconds_, ui::numberOf(samples_, "gaze sample"));
}

}  // namespace macula::tools
