// WalkSession: what is recorded of the walk, and the recorded camera path.
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <optional>

#include "engine/core/error.h"
#include "engine/recording/scene_source.h"
#include "engine/ui/widgets.h"
#include "walk/command_text.h"
#include "walk/file_names.h"
#include "walk/session.h"

namespace macula::tools {

void WalkSession::beginRecording() {
  recorder_.emplace(recordStartOf(options_, window_), options_.registry, *device_, *renderer_);
  gaze_.onSample([this](const gaze::GazeSample& sample) { recorder_->raw(sample); });
}

void WalkSession::record() {
  // A scene that was loaded again may differ: by its settings, or because its file has changed.
  std::optional<recording::SceneSource> scene;
  try {
    if (events_.sceneChanged && recorder_->frames() > 0) {
      scene = recording::sourceOf(events_.scene);
    }
    recorder_->frame({.timeSeconds = events_.timeSeconds,
                      .scene = scene ? &*scene : nullptr,
                      .r = result_.resizeFactor},
                     *renderer_);
  } catch (const InputError& error) {
    // A full disk or a vanished file ends the recording, not the walk.
    say(fmt::format("the recording has ended: {}", error.what()), true);
    endRecording(error.what());
  }
}

void WalkSession::endRecording(const std::string& reason) {
  if (!recorder_) return;
  gaze_.onSample({});
  const std::string folder = std::filesystem::path(options_.record).lexically_normal().string();
  summary_ = fmt::format("recorded: {}: {}\n", folder, recorder_->facts());
  if (!reason.empty()) summary_ += fmt::format("ended early: {}\n", oneLine(reason));
  if (recorder_->frames() > 0) {
    std::filesystem::path out =
        folder.ends_with('/') ? folder.substr(0, folder.size() - 1) : folder;
    out += "_replay";
    summary_ += fmt::format("replay: macula replay {} --out {}\n", asArgument(folder),
                            asArgument(out.string()));
  }
  recorder_.reset();
}

void WalkSession::sumUpRecordings() {
  endRecording({});
  // Standard output may be the report's.
  std::FILE* out = options_.json == "-" ? stderr : stdout;
  fmt::print(out, "{}", summary_);
  if (!camera_.recording() || camera_.recordedKeys() == 0) return;
  const std::filesystem::path file = nextFreeName("camera", "csv");
  camera_.finishRecording(file);
  fmt::print(out, "camera path: {}: {:.1f} s, {}\n", file.string(), camera_.recordedSeconds(),
             ui::numberOf(camera_.recordedKeys(), "key"));
}

}  // namespace macula::tools
