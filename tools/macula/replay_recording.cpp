#include "replay_recording.h"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <optional>
#include <set>
#include <span>

#include "common.h"
#include "engine/control/law.h"
#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/core/interrupt.h"
#include "engine/core/output_folder.h"
#include "engine/core/plural.h"
#include "engine/core/sha256.h"
#include "engine/recording/reader.h"
#include "engine/recording/scene_source.h"
#include "frame_record.h"
#include "provenance.h"
#include "recorded_levers.h"
#include "replay_painter.h"

namespace macula::tools {
namespace {

using Clock = std::chrono::steady_clock;
using recording::Reset;

double millisecondsSince(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// Draws the frames of a recording in their order.
class Session {
 public:
  Session(ReplayOptions& options, const recording::Recording& recording, OutputFolder& output);

  void draw(const recording::Frame& frame);
  /// Writes the report.
  /// @throws Interrupted where not all frames were drawn @throws Difference where images differ
  void finish();

 private:
  void apply(const recording::Settings& settings);
  [[nodiscard]] nlohmann::ordered_json provenanceJson() const;
  /// @param frame the first that is drawn with it
  void loadScene(const recording::SceneSource& source, const recording::Frame& frame);
  void follow(const recording::Frame& frame);
  [[nodiscard]] std::string placeOf(const recording::Frame& frame) const;
  void compareHash(const recording::Frame& frame, const passes::FrameResult& result,
                   const std::string& sha256);
  template <typename Function>
  void forEachPainter(const Function& function) {
    function(*painter_);
    if (reference_) function(*reference_);
  }

  ReplayOptions& options_;
  OutputFolder& output_;
  const recording::Recording& recording_;
  Clock::time_point begin_ = Clock::now();
  passes::RenderSettings referenceSettings_;
  measure::RunRecord run_;
  window::HeadlessContext context_;
  passes::Machine machine_;
  std::unique_ptr<scene::GpuScene> gpu_;
  std::optional<Painter> painter_;
  std::optional<Painter> reference_;
  std::optional<measure::FlickerMeter> flicker_;
  measure::RecordingNumbers numbers_;
  std::set<std::string> unknown_;  ///< settings that were left out
};

Session::Session(ReplayOptions& options, const recording::Recording& recording,
                 OutputFolder& output)
    : options_(options),
      output_(output),
      recording_(recording),
      context_(platformOf(options.platform)) {
  options.settings.tonemap.linearOut = options.reference || options.images == "exr";
  apply(recording.session.settings);
  if (!recording.session.environmentSha256.empty()) {
    recording::checkFile(options.settings.environment, recording.session.environmentSha256);
  }
  loadScene(recording.session.scene, recording.frames.front());
}

void Session::apply(const recording::Settings& settings) {
  const auto where = fmt::format("{}: the recording", options_.scene);
  for (const auto& [key, value] : settings) {
    if (settings::Entry* entry = options_.registry.find(key)) {
      entry->set(value, where);
    } else if (key.starts_with("control.")) {
      // What a controller did is recorded; a replay repeats that, and never controls.
    } else if (unknown_.insert(key).second) {
      // A walk may have settings of its own, such as those of a tracker, that no image depends on.
      fmt::print(stderr, "warning: {}: the setting '{}' is not known to replay and left out\n",
                 options_.scene, oneLine(key));
    }
  }
  referenceSettings_ = passes::referenceOf(options_.settings);
}

void Session::loadScene(const recording::SceneSource& source, const recording::Frame& frame) {
  const LoadedScene loaded = loadForRendering(recording::checkedScene(source), options_.settings);
  printWarnings(loaded.scene, frame.camera, aspectOf(frame.size));
  run_.loadMs += loaded.loadMs;
  auto gpu = std::make_unique<scene::GpuScene>(loaded.scene,
                                               loaded.environment ? &*loaded.environment : nullptr);
  if (painter_) forEachPainter([&](Painter& painter) { painter.setScene(*gpu); });
  gpu_ = std::move(gpu);
}

void Session::follow(const recording::Frame& frame) {
  apply(frame.settings);
  if (!frame.scene.name.empty()) loadScene(frame.scene, frame);
  if (!painter_) {
    painter_.emplace(options_.settings, machine_, *gpu_, frame.size);
    if (options_.reference) reference_.emplace(referenceSettings_, machine_, *gpu_, frame.size);
  }
  // The reference is drawn at full rate.
  painter_->setLevers(replayedLevers(frame, options_.settings.lod.resize, placeOf(frame)));
  if (frame.reset == Reset::None) return;
  const glm::ivec2 before = painter_->renderer().outputSize();
  forEachPainter([&](Painter& painter) {
    if (frame.reset == Reset::Scene) painter.setScene(*gpu_);
    if (frame.reset == Reset::Restart) painter.restart();
    painter.resize(frame.size);
  });
  if (frame.size != before || !flicker_) flicker_.emplace();
}

std::string Session::placeOf(const recording::Frame& frame) const {
  return fmt::format("{}: line {}",
                     (std::filesystem::path(options_.scene) / recording::kFramesFile).string(),
                     frame.index + 1);
}

void Session::draw(const recording::Frame& frame) {
  follow(frame);
  numbers_.unrecordedFrames += frame.unrecorded;
  const passes::FrameResult result = painter_->draw(frame.camera, frame.gaze, frame.cut);
  if (run_.firstFrameMs == 0.0) run_.firstFrameMs = millisecondsSince(begin_);
  measure::FrameRecord record = recordOf(painter_->renderer(), result);
  setGaze(record, frame.gaze);
  painter_->readBack();
  const std::string sha256 = sha256Hex(std::as_bytes(std::span(painter_->display().pixels)));
  record.set("index", frame.index);
  record.set("time_s", frame.timeSeconds);
  record.set("image_sha256", sha256);
  compareHash(frame, result, sha256);
  const int index = static_cast<int>(frame.index);
  if (!options_.images.empty()) {
    painter_->write(output_, "frame", index, options_.images);
  }
  if (reference_) {
    reference_->draw(frame.camera, frame.gaze, frame.cut);
    reference_->readBack();
    compareWithReference(record, *reference_, *painter_, options_, *flicker_);
    if (!options_.images.empty()) {
      reference_->write(output_, "reference", index, options_.images);
    }
  }
  run_.frames.push_back(std::move(record));
}

void Session::compareHash(const recording::Frame& frame, const passes::FrameResult& result,
                          const std::string& sha256) {
  const bool overflowed =
      painter_->renderer().plan().method->grows() && result.fragments && result.fragments->lost > 0;
  // These differ from run to run, and say so.
  if (frame.imageSha256.empty() || painter_->renderer().isRacy() || overflowed) return;
  ++numbers_.hashesCompared;
  if (sha256 == frame.imageSha256) {
    ++numbers_.hashesEqual;
  } else if (!numbers_.firstDifference) {
    numbers_.firstDifference = frame.index;
  }
}

/// Gaze and camera are those of the recording, and so are its times: there is no frame rate.
nlohmann::ordered_json Session::provenanceJson() const {
  const recording::SceneSource& scene = recording_.session.scene;
  const nlohmann::ordered_json recorded = measure::toJson(cameraInput(options_.scene));
  measure::Provenance provenance = provenanceOfRun(options_.registry);
  provenance.inputs.update(
      {{"scene", measure::toJson(sceneInput(scene.file.empty() ? scene.name : scene.file))},
       {"gaze", recorded},
       {"camera", recorded},
       {"fps", nullptr},
       {"seed", options_.settings.seed}});
  return measure::toJson(provenance);
}

void Session::finish() {
  const recording::Session& session = recording_.session;
  describeRun(run_, session.scene.name, options_, machine_, painter_->renderer(),
              painter_->renderer().outputSize());
  run_.interrupted = run_.frames.size() < recording_.frames.size();
  run_.provenance = provenanceJson();
  run_.gazeErrorBasis = "none: a recording holds the point of interest, not where the eye was";
  numbers_.frames = recording_.frames.size();
  numbers_.truncatedLines = recording_.truncatedLines;
  run_.recording = numbers_;
  const nlohmann::ordered_json report = measure::toJson(run_);
  const std::filesystem::path file = output_.file("report.json");
  writeFileAtomically(file, report.dump(2) + "\n");
  writeJson(options_.json, report);
  if (options_.json != "-") {
    fmt::print("{} of {} as recorded: median {:.2f} ms; {} of {} equal\n",
               counted(run_.frames.size(), "frame"), oneLine(session.scene.name),
               report["summary"]["ms"]["median"].get<double>(), numbers_.hashesEqual,
               counted(numbers_.hashesCompared, "image hash", "image hashes"));
    fmt::print("report: {}\n", file.string());
  }
  if (run_.interrupted) {
    throw Interrupted(fmt::format("interrupted after {} of {} frames; they are in {}",
                                  run_.frames.size(), recording_.frames.size(), file.string()));
  }
  if (!numbers_.firstDifference) return;
  throw Difference(fmt::format(
      "{}: frame {} is the first of {} whose image is not the recorded one (recorded by {} on {}, "
      "{}{})",
      options_.scene, *numbers_.firstDifference, numbers_.hashesCompared - numbers_.hashesEqual,
      session.commit, session.renderer, session.version,
      numbers_.unrecordedFrames > 0
          ? fmt::format("; {} drawn unrecorded",
                        counted(numbers_.unrecordedFrames, "frame was", "frames were"))
          : ""));
}

/// Refuses levers that no frame could be drawn with, before anything is drawn or written.
void checkLevers(const recording::Recording& recording, const std::string& folder) {
  const std::string file = (std::filesystem::path(folder) / recording::kFramesFile).string();
  for (const recording::Frame& frame : recording.frames) {
    (void)replayedLevers(frame, control::kLeastResize,
                         fmt::format("{}: line {}", file, frame.index + 1));
  }
}

}  // namespace

void replayRecording(ReplayOptions& options) {
  if (!recording::isRecording(options.scene)) {
    failInput("{}: is a folder without {}; name a scene, or a folder that walk --record made",
              options.scene, recording::kSessionFile);
  }
  if (!options.answeredByRecording.empty()) {
    failInput("{}: a recording brings its own {}; leave it out, or name a scene", options.scene,
              options.answeredByRecording.front());
  }
  const recording::Recording recording = recording::readRecording(options.scene);
  if (recording.frames.empty()) {
    failInput("{}: no frame was recorded; record again",
              (std::filesystem::path(options.scene) / recording::kFramesFile).string());
  }
  checkLevers(recording, options.scene);
  OutputFolder output(options.out, "replay", options.force);
  Session session(options, recording, output);
  endIfInterrupted();
  ProgressBar progress("replay", static_cast<int>(recording.frames.size()));
  for (const recording::Frame& frame : recording.frames) {
    session.draw(frame);
    progress.advance();
    if (interruptAsked()) break;
  }
  progress.end();
  session.finish();
}

}  // namespace macula::tools
