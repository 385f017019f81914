// macula hold SCENE: the frames of a path under control, each drawn once more with a fixed r.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/core/interrupt.h"
#include "engine/core/output_folder.h"
#include "engine/core/page.h"
#include "engine/gaze/source.h"
#include "engine/measure/statistics.h"
#include "frame_control.h"
#include "frame_record.h"
#include "gaze_report.h"
#include "hold.h"
#include "hold_record.h"
#include "passes/device_context.h"
#include "passes/frame_renderer.h"
#include "provenance.h"

namespace macula::tools {
namespace {

/// Drawn before a load is measured: programs are compiled, pools grow.
constexpr int kUnmeasured = 2;
/// r by which K and C are told apart in the warm-up; it also holds the costs of reconstruction.
constexpr double kWarmupResize = 2.0;

control::HeldFrame heldFrame(const passes::FrameResult& result) {
  return {.ms = result.totalMs,
          .resizableMs = result.resizableMs,
          .resize = result.resizeFactor,
          .fixedMs = result.totalMs};
}

/// What is the same for all frames.
struct Stage {
  passes::DeviceContext device;
  scene::GpuScene gpu;
  recording::FrameSource& frames;

  Stage(const LoadedScene& loaded, recording::FrameSource& source)
      : gpu(loaded.scene, loaded.environment ? &*loaded.environment : nullptr), frames(source) {
    device.programs.onProgress(compileProgress());
  }
};

int loadAt(const std::vector<LoadStep>& steps, std::size_t frame) {
  int times = 1;
  for (const LoadStep& step : steps) times = step.frame <= frame ? step.times : times;
  return times;
}

/// Frames of the path's first view, without the unmeasured ones.
std::vector<control::HeldFrame> drawStill(passes::FrameRenderer& renderer, const Stage& stage,
                                          int times, double resize, int frames) {
  renderer.setShadingLoad(times);
  renderer.setControls({.resize = static_cast<float>(resize)});
  std::vector<control::HeldFrame> drawn;
  const recording::Frame& first = stage.frames.first();
  for (int i = -kUnmeasured; i < frames; ++i) {
    endIfInterrupted();
    const passes::FrameResult result = renderer.render(first.camera, first.gaze);
    if (i >= 0) drawn.push_back(heldFrame(result));
  }
  return drawn;
}

/// Measures each load; the target may follow from the first.
void measureLoads(HoldRecord& record, const HoldOptions& options, const Stage& stage,
                  passes::FrameRenderer& renderer) {
  std::vector<int> different{loadAt(record.steps, 0)};
  for (const LoadStep& step : record.steps) {
    if (std::ranges::find(different, step.times) == different.end()) {
      different.push_back(step.times);
    }
  }
  for (const int times : different) {
    std::vector<double> fullRate;
    const auto full = drawStill(renderer, stage, times, control::kLeastResize, options.warmup);
    for (const control::HeldFrame& frame : full) fullRate.push_back(frame.ms);
    const auto half = drawStill(renderer, stage, times, kWarmupResize, options.warmup);
    LoadTimes load;
    load.times = times;
    load.fullRateMs = *measure::median(fullRate);
    if (record.loads.empty()) {
      record.targetMs =
          options.targetShare ? *options.targetShare * load.fullRateMs : options.control.targetMs;
    }
    const double most = options.control.mostResize;
    // Without resizing, nothing has to be reconstructed.
    load.firstResize = load.fullRateMs <= record.targetMs
                           ? control::kLeastResize
                           : control::modelOf(half, record.targetMs, most).idealResize;
    record.loads.push_back(load);
  }
}

/// The mean over the frames of what the first view asks for: too slow after a step up, and too
/// coarse before it, as any fixed r is.
double meanResize(const HoldRecord& record, int frames) {
  double sum = 0.0;
  for (int i = 0; i < frames; ++i) {
    const int times = loadAt(record.steps, static_cast<std::size_t>(i));
    sum += std::ranges::find(record.loads, times, &LoadTimes::times)->firstResize;
  }
  return sum / frames;
}

void drawFrames(HoldRecord& record, const HoldOptions& options, const Stage& stage,
                passes::FrameRenderer& held, passes::FrameRenderer& fixed) {
  FrameControl control(options.control, options.settings, stage.device.time);
  control.resized(record.size);
  const frame::QualityControls fixedControls{.resize = static_cast<float>(record.fixedResize)};
  ProgressBar progress("hold", options.frames);
  playFrames(stage.frames, progress, [&](const recording::Frame& source) {
    const int times = loadAt(record.steps, source.index);
    held.setShadingLoad(times);
    control.steer(held);
    const passes::FrameResult result = held.render(source.camera, source.gaze, source.cut);
    control.drawn(held);
    control.note(result);
    control::HeldFrame frame = heldFrame(result);
    const frame::QualityControls controls = held.inputs().controls;
    frame.load = times;
    frame.othersAtRest = controls.foveaSlope == 1.0F && controls.layerShare == 1.0F;
    record.frames.push_back({source.timeSeconds, controls});
    record.records.push_back(recordOf(held, result));
    fixed.setShadingLoad(times);
    fixed.setControls(fixedControls);
    frame.fixedMs = fixed.render(source.camera, source.gaze, source.cut).totalMs;
    record.held.push_back(frame);
    const std::string notice = control.controller().notice();
    if (notice != (record.notices.empty() ? "" : record.notices.back().text)) {
      record.notices.push_back({source.index, notice});
    }
  });
  if (record.held.size() == static_cast<std::size_t>(options.frames)) return;
  record.interrupted =
      fmt::format("{} of {} frames were drawn", record.held.size(), options.frames);
  // The steps that were not reached change nothing.
  std::erase_if(record.steps,
                [&](const LoadStep& step) { return step.frame >= record.held.size(); });
}

void writeFiles(const HoldRecord& record, const HoldOptions& options, OutputFolder& output) {
  const std::string page =
      reportPageOf(dataFolder("assets"), "hold", pageData(record, options).dump(),
                   {{"interrupted", interruptedBanner(record.interrupted)}});
  writeFileAtomically(output.file("results.json"), toJson(record, options).dump(1) + "\n");
  writeFileAtomically(output.file("results.csv"), toCsv(record));
  writeFileAtomically(output.file("report.html"), page);
}

}  // namespace

void holdScene(HoldOptions& options) {
  const InterruptGuard guard;
  HoldRecord record;
  record.size = parseSize(options.size);
  record.steps = parseLoads(options.loads, options.frames);
  if (!options.settings.timing) failInput("hold needs the times of frames; leave frame.timing on");
  const auto gazeSource = gaze::parseGazeSpec(options.gaze, options.gazeSettings);
  std::optional<LoadedScene> loaded = loadForRendering(options.scene, options.settings);
  const FollowedGaze followed(*gazeSource, options.gazeSettings);
  followed.printWarnings();
  record.gazeLog = followed.toJson();
  recording::PathFrames frames(parseCameraSpec(options.camera, loaded->scene), *gazeSource,
                               options.fps, static_cast<std::size_t>(options.frames), record.size);
  printWarnings(loaded->scene, frames.first().camera, aspectOf(record.size));
  std::optional<OutputFolder> output;
  if (!options.out.empty()) output.emplace(options.out, "hold", options.force);
  record.provenance = provenanceOfFrames(options);

  const window::HeadlessContext context(platformOf(options.platform));
  Stage stage(*loaded, frames);
  loaded.reset();  // it is in GPU memory now
  record.clockFault = clockFaultOf(stage.device.time);
  record.timeSource = gl::nameOf(stage.device.time.source);
  record.glRenderer = stage.device.capabilities.renderer;
  record.glVersion = stage.device.capabilities.version;
  if (!record.clockFault.empty()) fmt::print(stderr, "warning: {}\n", record.clockFault);

  passes::FrameRenderer held(options.settings, stage.device);
  passes::FrameRenderer fixed(options.settings, stage.device);
  fixed.want({.times = true, .statistics = false});
  for (passes::FrameRenderer* renderer : {&held, &fixed}) {
    renderer->resize(record.size);
    renderer->setScene(stage.gpu);
  }
  measureLoads(record, options, stage, held);
  options.control.targetMs = record.targetMs;
  record.fixedResize = meanResize(record, options.frames);
  // The other renderer compiles and grows, too, before its times count.
  drawStill(fixed, stage, loadAt(record.steps, 0), record.fixedResize, 0);
  drawFrames(record, options, stage, held, fixed);
  followed.printEnd(options.fps, options.frames);

  control::HoldRun run{record.targetMs, options.control.mostResize, record.held, {}};
  for (const LoadStep& step : record.steps) {
    if (step.frame > 0) run.steps.push_back(step.frame);
  }
  record.measures = control::measureHold(run);
  writeJson(options.json, toJson(record, options));
  if (output) writeFiles(record, options, *output);
  if (options.json != "-") {
    fmt::print("{}", summaryOf(record, options));
    if (output) fmt::print("report: {}\n", (output->path() / "report.html").string());
  }
  if (!record.interrupted.empty()) {
    throw Interrupted(fmt::format("interrupted: {}{}", record.interrupted,
                                  output ? "; they are in " + options.out : ""));
  }
}

}  // namespace macula::tools
