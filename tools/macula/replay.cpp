// macula replay: a deterministic run, its images and its report.
#include "replay.h"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <span>

#include "common.h"
#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/core/interrupt.h"
#include "engine/core/output_folder.h"
#include "engine/core/plural.h"
#include "engine/core/sha256.h"
#include "engine/gaze/point_error.h"
#include "engine/gaze/source.h"
#include "engine/image/image.h"
#include "engine/measure/flicker.h"
#include "engine/measure/hazards.h"
#include "engine/measure/run_record.h"
#include "frame_record.h"
#include "gaze_report.h"
#include "passes/frame_renderer.h"
#include "provenance.h"
#include "replay_painter.h"
#include "replay_recording.h"

namespace macula::tools {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// The same method with turns, to count a racy one's hazards against.
passes::RenderSettings withTurns(const passes::RenderSettings& settings) {
  passes::RenderSettings other = settings;
  other.oit.method = "kb-fixed";
  other.oit.sync = "auto";
  other.tonemap.linearOut = false;
  return other;
}

void printSummary(const ReplayOptions& options, const nlohmann::ordered_json& report) {
  const auto& summary = report["summary"];
  const auto frames = counted(report["frames"].size(), "frame");
  fmt::print("{} of {} by {}: median {:.2f} ms", frames, options.scene, options.settings.oit.method,
             summary["ms"]["median"].get<double>());
  if (options.reference) fmt::print(", rmse {:.5f}", summary["error"]["rmse"].get<double>());
  fmt::print("\nreport: {}\n", (std::filesystem::path(options.out) / "report.json").string());
}

}  // namespace

void replay(ReplayOptions& options) {
  std::error_code error;
  const InterruptGuard guard;
  if (std::filesystem::is_directory(options.scene, error)) return replayRecording(options);
  const auto begin = Clock::now();
  const glm::ivec2 size = parseSize(options.size);
  OutputFolder output(options.out, "replay", options.force);
  const auto gazeSource = gaze::parseGazeSpec(options.gaze, options.gazeSettings);
  const auto trueGaze = gaze::parseGazeSpec(options.gaze, gaze::undelayed(options.gazeSettings));
  LoadedScene loaded = loadForRendering(options.scene, options.settings);
  const FollowedGaze followed(*gazeSource, options.gazeSettings);
  followed.printWarnings();
  const scene::CameraPath path = parseCameraSpec(options.camera, loaded.scene);
  printWarnings(loaded.scene, path.at(0.0), aspectOf(size));
  const nlohmann::ordered_json provenance = provenanceOfFrames(options);

  passes::RenderSettings settings = options.settings;
  settings.tonemap.linearOut = options.reference || options.images == "exr";
  const passes::RenderSettings referenceSettings = passes::referenceOf(settings);
  const passes::RenderSettings turnsSettings = withTurns(settings);

  const window::HeadlessContext context(platformOf(options.platform));
  passes::Machine machine;
  const scene::GpuScene gpu(loaded.scene, loaded.environment ? &*loaded.environment : nullptr);
  loaded.scene = {};  // it is in GPU memory now
  loaded.environment.reset();
  Painter painter(settings, machine, gpu, size);
  std::optional<Painter> reference;
  if (options.reference) reference.emplace(referenceSettings, machine, gpu, size);

  std::optional<Painter> turns;
  if (passes::methodById(settings.oit.method).isRacy()) {
    turns.emplace(turnsSettings, machine, gpu, size);
  }

  measure::RunRecord run;
  run.provenance = provenance;
  run.loadMs = loaded.loadMs;
  const auto noteFirstFrame = [&] {
    if (run.firstFrameMs == 0.0) run.firstFrameMs = millisecondsSince(begin);
  };
  const gaze::PointOfInterest first = gazeSource->at(0.0);
  for (int i = 0; i < options.warmup; ++i) {
    painter.draw(path.at(0.0), first, false);
    if (reference) reference->draw(path.at(0.0), first, false);
    if (turns) turns->draw(path.at(0.0), first, false);
    noteFirstFrame();
    endIfInterrupted();
  }
  endIfInterrupted();

  measure::FlickerMeter flicker;
  ProgressBar progress("replay", options.frames);
  double previous = 0.0;
  for (int i = 0; i < options.frames; ++i) {
    const double time = i / options.fps;
    const gaze::PointOfInterest point = gazeSource->at(time);
    const bool cut = i > 0 && path.cutAt(previous, time);
    const scene::Camera camera = path.at(time);
    const passes::FrameResult result = painter.draw(camera, point, cut);
    measure::FrameRecord record = recordOf(painter.renderer(), result);
    setGaze(record, point);
    if (followed.hasDegrees()) {
      record.set("fovea.error_deg",
                 gaze::pointError(point, trueGaze->at(time), followed.display()));
    }
    noteFirstFrame();
    painter.readBack();
    record.set("index", static_cast<std::uint64_t>(i));
    record.set("time_s", time);
    record.set("image_sha256", sha256Hex(std::as_bytes(std::span(painter.display().pixels))));
    if (!options.images.empty()) painter.write(output, "frame", i, options.images);
    if (turns) {
      turns->draw(camera, point, cut);
      turns->readBack();
      record.set("hazards", measure::countUnlikePixels(turns->display(), painter.display()));
    }
    if (reference) {
      reference->draw(camera, point, cut);
      reference->readBack();
      compareWithReference(record, *reference, painter, options, flicker);
      if (!options.images.empty()) reference->write(output, "reference", i, options.images);
    }
    run.frames.push_back(std::move(record));
    previous = time;
    progress.advance();
    if (interruptAsked()) break;
  }
  progress.end();
  run.interrupted = run.frames.size() < static_cast<std::size_t>(options.frames);

  describeRun(run, options.scene, options, machine, painter.renderer(), size);
  run.gazeLog = followed.toJson();
  run.gazeErrorBasis = followed.errorBasis();
  const nlohmann::ordered_json report = measure::toJson(run);
  const std::filesystem::path file = output.file("report.json");
  writeFileAtomically(file, report.dump(2) + "\n");
  writeJson(options.json, report);
  followed.printEnd(options.fps, options.frames);
  if (options.json != "-") printSummary(options, report);
  if (run.interrupted) {
    throw Interrupted(fmt::format("interrupted after {} of {} frames; they are in {}",
                                  run.frames.size(), options.frames, file.string()));
  }
}

}  // namespace macula::tools
