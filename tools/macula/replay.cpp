// macula replay: a deterministic run, its images and its report.
#include "replay.h"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <set>
#include <span>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/core/interrupt.h"
#include "engine/core/output_folder.h"
#include "engine/core/sha256.h"
#include "engine/measure/flicker.h"
#include "engine/measure/hazards.h"
#include "frame_record.h"
#include "recorded_controls.h"
#include "replay_input.h"

namespace macula::tools {
namespace {

using Clock = std::chrono::steady_clock;
using recording::Frame;
using recording::Reset;

/// The same method with ordering, to count a racy one's hazards against.
passes::RenderSettings orderedOf(const passes::RenderSettings& settings) {
  passes::RenderSettings other = settings;
  other.oit.method = "kb-fixed";
  other.oit.sync = "auto";
  other.tonemap.linearOut = false;
  return other;
}

/// Draws the frames of an input in their order, whatever they are from.
class Replay {
 public:
  Replay(ReplayOptions& options, ReplayInput& input, OutputFolder& output, Clock::time_point begin);
  void run();
  /// Writes the report. @throws Interrupted where not all frames were drawn @throws Difference
  void finish();

 private:
  void warmUp();
  void draw(const Frame& frame);
  /// What is drawn beside a racy method; null beside others.
  Painter* ordered(const Frame& frame);
  /// Does what was done before the frame: settings, scene, size, resets, controls.
  void follow(const Frame& frame);
  void apply(const recording::Settings& settings);
  /// @param frame the first that is drawn with it
  void loadScene(const recording::SceneSource& source, const Frame& frame);
  passes::FrameResult render(const Frame& frame);
  template <typename Function>
  void forEachPainter(const Function& function) {
    function(*painter_);
    if (reference_) function(*reference_);
    if (ordered_) function(*ordered_);
  }

  ReplayOptions& options_;
  ReplayInput& input_;
  OutputFolder& output_;
  Clock::time_point begin_;
  passes::RenderSettings referenceSettings_;
  passes::RenderSettings orderedSettings_;
  measure::RunRecord run_;
  window::HeadlessContext context_;
  passes::DeviceContext device_;
  std::unique_ptr<scene::GpuScene> gpu_;
  std::optional<Painter> painter_;
  std::optional<Painter> reference_;
  std::optional<Painter> ordered_;  ///< beside a racy method
  measure::FlickerMeter flicker_;
  std::set<std::string> unknown_;  ///< settings that were left out
};

Replay::Replay(ReplayOptions& options, ReplayInput& input, OutputFolder& output,
               Clock::time_point begin)
    : options_(options),
      input_(input),
      output_(output),
      begin_(begin),
      context_(platformOf(options.platform)) {
  device_.programs.onProgress(compileProgress());
  options.settings.tonemap.linearOut = options.reference || options.images == "exr";
  apply(input.settings());
  loadScene(input.scene(), input.frames().first());
}

void Replay::apply(const recording::Settings& settings) {
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
  orderedSettings_ = orderedOf(options_.settings);
}

void Replay::loadScene(const recording::SceneSource& source, const Frame& frame) {
  const LoadedScene loaded = input_.load(source);
  printWarnings(loaded.scene, frame.camera, aspectOf(frame.size));
  run_.loadMs += loaded.loadMs;
  auto gpu = std::make_unique<scene::GpuScene>(loaded.scene,
                                               loaded.environment ? &*loaded.environment : nullptr);
  if (painter_) forEachPainter([&](Painter& painter) { painter.setScene(*gpu); });
  gpu_ = std::move(gpu);
}

void Replay::follow(const Frame& frame) {
  if (!frame.settings.empty()) apply(frame.settings);
  if (!frame.scene.name.empty()) loadScene(frame.scene, frame);
  if (!painter_) {
    painter_.emplace(options_.settings, device_, *gpu_, frame.size);
    if (options_.reference) {
      reference_.emplace(referenceSettings_, device_, *gpu_, frame.size);
      reference_->wantImagesAlone();
    }
  }
  // The reference is drawn at full rate.
  painter_->setControls(replayedControls(frame, options_.settings.lod.resize, options_.scene));
  if (frame.reset == Reset::None) return;
  const glm::ivec2 before = painter_->renderer().outputSize();
  forEachPainter([&](Painter& painter) {
    if (frame.reset == Reset::Scene) painter.setScene(*gpu_);
    if (frame.reset == Reset::Restart) painter.restart();
    painter.resize(frame.size);
  });
  if (frame.size != before) flicker_ = {};
}

passes::FrameResult Replay::render(const Frame& frame) {
  const passes::FrameResult result = painter_->draw(frame);
  if (run_.firstFrameMs == 0.0) {
    run_.firstFrameMs = std::chrono::duration<double, std::milli>(Clock::now() - begin_).count();
  }
  return result;
}

Painter* Replay::ordered(const Frame& frame) {
  if (!passes::methodById(options_.settings.oit.method).isRacy()) return nullptr;
  if (!ordered_) {
    ordered_.emplace(orderedSettings_, device_, *gpu_, frame.size);
    ordered_->wantImagesAlone();
  }
  return &*ordered_;
}

void Replay::warmUp() {
  const Frame& first = input_.frames().first();
  for (int i = 0; i < input_.warmup(); ++i) {
    follow(first);
    (void)render(first);
    if (reference_) reference_->draw(first);
    if (Painter* painter = ordered(first)) painter->draw(first);
    endIfInterrupted();
  }
}

void Replay::draw(const Frame& frame) {
  follow(frame);
  const passes::FrameResult result = render(frame);
  measure::FrameRecord record = recordOf(painter_->renderer(), result);
  setGaze(record, frame.gaze);
  painter_->readBack();
  const std::string sha256 = sha256Hex(std::as_bytes(std::span(painter_->display().pixels)));
  record.set("index", frame.index);
  record.set("time_s", frame.timeSeconds);
  record.set("image_sha256", sha256);
  input_.judge({frame, result, painter_->renderer(), sha256}, record);
  const auto write = [&](const Painter& painter, std::string_view stem) {
    if (options_.images.empty()) return;
    painter.write(output_, stem, static_cast<int>(frame.index), options_.images);
  };
  write(*painter_, "frame");
  if (Painter* painter = ordered(frame)) {
    painter->draw(frame);
    painter->readBack();
    record.set("hazards", measure::countUnlikePixels(painter->display(), painter_->display()));
  }
  if (reference_) {
    reference_->draw(frame);
    reference_->readBack();
    compareWithReference(record, *reference_, *painter_, options_, flicker_);
    write(*reference_, "reference");
  }
  run_.frames.push_back(std::move(record));
}

void Replay::run() {
  warmUp();
  endIfInterrupted();
  ProgressBar progress("replay", static_cast<int>(input_.frames().count()));
  playFrames(input_.frames(), progress, [this](const Frame& frame) { draw(frame); });
}

void Replay::finish() {
  const std::size_t asked = input_.frames().count();
  run_.interrupted = run_.frames.size() < asked;
  describeRun(run_, input_.scene().name, options_, device_, painter_->renderer(),
              painter_->renderer().outputSize());
  input_.describe(run_);
  const nlohmann::ordered_json report = measure::toJson(run_);
  const std::filesystem::path file = output_.file("report.json");
  writeFileAtomically(file, report.dump(2) + "\n");
  writeJson(options_.json, report);
  if (options_.json != "-") {
    fmt::print("{}\nreport: {}\n", input_.summary(report), file.string());
  }
  if (run_.interrupted) {
    throw Interrupted(fmt::format("interrupted after {} of {} frames; they are in {}",
                                  run_.frames.size(), asked, file.string()));
  }
  input_.finish();
}

}  // namespace

std::string medianText(const nlohmann::ordered_json& summary) {
  const auto& median = summary["ms"]["median"];
  return median.is_null() ? "not timed" : fmt::format("median {:.2f} ms", median.get<double>());
}

void replay(ReplayOptions& options) {
  const Clock::time_point begin = Clock::now();
  const InterruptGuard guard;
  std::error_code error;
  std::optional<recording::Recording> recorded;
  if (std::filesystem::is_directory(options.scene, error)) recorded = readForReplay(options);
  const glm::ivec2 size = recorded ? glm::ivec2(0) : parseSize(options.size);
  OutputFolder output(options.out, "replay", options.force);
  const std::unique_ptr<ReplayInput> input =
      recorded ? openRecording(options, std::move(*recorded)) : openPath(options, size);
  Replay run(options, *input, output, begin);
  run.run();
  run.finish();
}

}  // namespace macula::tools
