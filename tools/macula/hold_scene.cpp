// macula hold SCENE: the frames of a path under control, each drawn once more with a fixed r.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/core/page.h"
#include "engine/gaze/source.h"
#include "engine/measure/statistics.h"
#include "frame_control.h"
#include "hold.h"
#include "hold_record.h"
#include "passes/frame_renderer.h"
#include "passes/machine.h"
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
  passes::Machine machine;
  scene::GpuScene gpu;
  scene::CameraPath path;
  std::unique_ptr<gaze::GazeSource> gaze;

  Stage(LoadedScene&& loaded, scene::CameraPath&& camera, std::unique_ptr<gaze::GazeSource> source)
      : gpu(loaded.scene, loaded.environment ? &*loaded.environment : nullptr),
        path(std::move(camera)),
        gaze(std::move(source)) {}
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
  renderer.setLevers({.resize = static_cast<float>(resize)});
  std::vector<control::HeldFrame> drawn;
  const gaze::PointOfInterest point = stage.gaze->at(0.0);
  for (int i = -kUnmeasured; i < frames; ++i) {
    const passes::FrameResult result = renderer.render(stage.path.at(0.0), point);
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
    load.model = control::modelOf(half, record.targetMs, most);
    // Without resizing, nothing has to be reconstructed.
    if (load.fullRateMs <= record.targetMs) load.model.idealResize = control::kLeastResize;
    load.leastMs = std::min(load.fullRateMs, load.model.workMs / (most * most) + load.model.restMs);
    record.loads.push_back(load);
  }
}

/// The mean of the ideals over the frames: too slow after a step up, and too coarse before it, as
/// any fixed r is.
double meanIdeal(const HoldRecord& record, int frames) {
  double sum = 0.0;
  for (int i = 0; i < frames; ++i) {
    const int times = loadAt(record.steps, static_cast<std::size_t>(i));
    sum += std::ranges::find(record.loads, times, &LoadTimes::times)->model.idealResize;
  }
  return sum / frames;
}

void drawFrames(HoldRecord& record, const HoldOptions& options, const Stage& stage,
                passes::FrameRenderer& held, passes::FrameRenderer& fixed) {
  FrameControl control(options.control, options.settings, stage.machine.time);
  control.resized(record.size);
  const frame::Levers fixedLevers{.resize = static_cast<float>(record.fixedResize)};
  ProgressBar progress("hold", options.frames);
  double previous = 0.0;
  for (int i = 0; i < options.frames; ++i) {
    const double time = i / options.fps;
    const gaze::PointOfInterest point = stage.gaze->at(time);
    const scene::Camera camera = stage.path.at(time);
    const bool cut = i > 0 && stage.path.cutAt(previous, time);
    const int times = loadAt(record.steps, static_cast<std::size_t>(i));
    held.setShadingLoad(times);
    control.steer(held);
    const passes::FrameResult result = held.render(camera, point, cut);
    control.note(result);
    control::HeldFrame frame = heldFrame(result);
    HoldFrameRecord more{time, times, held.inputs().levers, {}};
    for (const frame::PassTime& pass : result.passes) more.passMs.emplace_back(pass.name, pass.ms);
    fixed.setShadingLoad(times);
    fixed.setLevers(fixedLevers);
    frame.fixedMs = fixed.render(camera, point, cut).totalMs;
    record.held.push_back(frame);
    record.frames.push_back(std::move(more));
    const std::string notice = control.controller().notice();
    if (notice != (record.notices.empty() ? "" : record.notices.back().text)) {
      record.notices.push_back({static_cast<std::size_t>(i), notice});
    }
    previous = time;
    progress.advance();
  }
}

void writeFiles(const HoldRecord& record, const HoldOptions& options) {
  const std::filesystem::path folder(options.out);
  const std::string page =
      reportPageOf(dataFolder("assets"), "hold", pageData(record, options).dump());
  writeFileAtomically(folder / "results.json", toJson(record, options).dump(1) + "\n");
  writeFileAtomically(folder / "results.csv", toCsv(record));
  writeFileAtomically(folder / "report.html", page);
}

}  // namespace

void holdScene(HoldOptions& options) {
  HoldRecord record;
  record.size = parseSize(options.size);
  record.steps = parseLoads(options.loads, options.frames);
  auto gazeSource = gaze::parseGazeSpec(options.gaze, options.gazeSettings);
  LoadedScene loaded = loadForRendering(options.scene, options.settings);
  for (const std::string& warning : loaded.scene.warnings) {
    fmt::print(stderr, "warning: {}\n", oneLine(warning));
  }
  scene::CameraPath path = parseCameraSpec(options.camera, loaded.scene);
  if (!options.out.empty()) makeOutputFolder(options.out);
  record.provenance = provenanceOfFrames(options);

  const window::HeadlessContext context(platformOf(options.platform));
  Stage stage(std::move(loaded), std::move(path), std::move(gazeSource));
  record.clockFault = clockFaultOf(stage.machine.time);
  record.timeSource = gl::nameOf(stage.machine.time.source);
  record.glRenderer = stage.machine.capabilities.renderer;
  record.glVersion = stage.machine.capabilities.version;
  if (!record.clockFault.empty()) fmt::print(stderr, "warning: {}\n", record.clockFault);

  passes::FrameRenderer held(options.settings, stage.machine);
  passes::FrameRenderer fixed(options.settings, stage.machine);
  for (passes::FrameRenderer* renderer : {&held, &fixed}) {
    renderer->resize(record.size);
    renderer->setScene(stage.gpu);
  }
  measureLoads(record, options, stage, held);
  options.control.targetMs = record.targetMs;
  record.fixedResize = meanIdeal(record, options.frames);
  // The other renderer compiles and grows, too, before its times count.
  drawStill(fixed, stage, loadAt(record.steps, 0), record.fixedResize, 0);
  drawFrames(record, options, stage, held, fixed);

  control::HoldRun run{record.targetMs, options.control.mostResize, record.held, {}};
  for (const LoadStep& step : record.steps) {
    if (step.frame > 0) run.steps.push_back(step.frame);
  }
  record.measures = control::measureHold(run);
  writeJson(options.json, toJson(record, options));
  if (!options.out.empty()) writeFiles(record, options);
  if (options.json == "-") return;
  fmt::print("{}", summaryOf(record, options));
  if (!options.out.empty()) {
    fmt::print("report: {}\n", (std::filesystem::path(options.out) / "report.html").string());
  }
}

}  // namespace macula::tools
