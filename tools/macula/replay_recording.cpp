// The frames of `macula replay FOLDER`: a walk as it was recorded.
#include <fmt/format.h>

#include <optional>

#include "engine/control/quality_controls.h"
#include "engine/core/error.h"
#include "engine/core/plural.h"
#include "engine/recording/reader.h"
#include "engine/recording/scene_source.h"
#include "provenance.h"
#include "recorded_controls.h"
#include "replay_input.h"

namespace macula::tools {
namespace {

using recording::Recording;

std::string framesFileOf(const std::string& folder) {
  return (std::filesystem::path(folder) / recording::kFramesFile).string();
}

class RecordedInput final : public ReplayInput {
 public:
  RecordedInput(const ReplayOptions& options, Recording recording)
      : options_(options),
        numbers_{.frames = recording.frames.size(), .truncatedLines = recording.truncatedLines},
        frames_(std::move(recording.frames)),
        session_(std::move(recording.session)) {}

  recording::FrameSource& frames() override { return frames_; }
  int warmup() const override { return 0; }
  recording::Settings settings() const override { return session_.settings; }
  recording::SceneSource scene() const override { return session_.scene; }

  LoadedScene load(const recording::SceneSource& source) override {
    if (!loaded_ && !session_.environmentSha256.empty()) {
      recording::checkFile(options_.settings.environment, session_.environmentSha256);
    }
    loaded_ = true;
    return loadForRendering(recording::checkedScene(source), options_.settings);
  }

  void judge(const DrawnFrame& drawn, measure::FrameRecord& /*record*/) override {
    const recording::Frame& frame = drawn.source;
    numbers_.unrecordedFrames += frame.unrecorded;
    const bool overflowed = drawn.renderer.plan().method->grows() && drawn.result.fragments &&
                            drawn.result.fragments->lost > 0;
    // These differ from run to run, and say so.
    if (frame.imageSha256.empty() || drawn.renderer.isRacy() || overflowed) return;
    ++numbers_.hashesCompared;
    if (drawn.imageSha256 == frame.imageSha256) {
      ++numbers_.hashesEqual;
    } else if (!numbers_.firstDifference) {
      numbers_.firstDifference = frame.index;
    }
  }

  /// Gaze and camera are those of the recording, and so are its times: there is no frame rate.
  void describe(measure::RunRecord& run) override {
    const recording::SceneSource& scene = session_.scene;
    const nlohmann::ordered_json recorded = measure::toJson(cameraInput(options_.scene));
    measure::Provenance provenance = provenanceOfRun(options_.registry);
    provenance.inputs.update(
        {{"scene", measure::toJson(sceneInput(scene.file.empty() ? scene.name : scene.file))},
         {"gaze", recorded},
         {"camera", recorded},
         {"fps", nullptr},
         {"seed", options_.settings.seed}});
    run.provenance = measure::toJson(provenance);
    run.gazeErrorBasis = "none: a recording holds the point of interest, not where the eye was";
    run.recording = numbers_;
  }

  std::string summary(const nlohmann::ordered_json& report) const override {
    return fmt::format("{} of {} as recorded: {}; {} of {} equal",
                       counted(report["frames"].size(), "frame"), oneLine(session_.scene.name),
                       medianText(report["summary"]), numbers_.hashesEqual,
                       counted(numbers_.hashesCompared, "image hash", "image hashes"));
  }

  void finish() const override {
    if (!numbers_.firstDifference) return;
    throw Difference(fmt::format(
        "{}: frame {} is the first of {} whose image is not the recorded one (recorded by {} on "
        "{}, {}{})",
        options_.scene, *numbers_.firstDifference, numbers_.hashesCompared - numbers_.hashesEqual,
        session_.commit, session_.renderer, session_.version,
        numbers_.unrecordedFrames > 0
            ? fmt::format("; {} drawn unrecorded",
                          counted(numbers_.unrecordedFrames, "frame was", "frames were"))
            : ""));
  }

 private:
  const ReplayOptions& options_;
  measure::RecordingNumbers numbers_;
  recording::ListedFrames frames_;
  recording::Session session_;
  bool loaded_ = false;  ///< the first scene
};

}  // namespace

Recording readForReplay(const ReplayOptions& options) {
  if (!recording::isRecording(options.scene)) {
    failInput("{}: is a folder without {}; name a scene, or a folder that walk --record made",
              options.scene, recording::kSessionFile);
  }
  if (!options.answeredByRecording.empty()) {
    failInput("{}: a recording brings its own {}; leave it out, or name a scene", options.scene,
              options.answeredByRecording.front());
  }
  Recording recording = recording::readRecording(options.scene);
  const std::string file = framesFileOf(options.scene);
  if (recording.frames.empty()) failInput("{}: no frame was recorded; record again", file);
  for (const recording::Frame& frame : recording.frames) {
    (void)replayedControls(frame, control::kLeastResize,
                           fmt::format("{}: line {}", file, frame.index + 1));
  }
  return recording;
}

std::unique_ptr<ReplayInput> openRecording(const ReplayOptions& options, Recording recording) {
  return std::make_unique<RecordedInput>(options, std::move(recording));
}

}  // namespace macula::tools
