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
#include "engine/core/sha256.h"
#include "engine/gaze/point_error.h"
#include "engine/gaze/source.h"
#include "engine/image/image.h"
#include "engine/measure/flicker.h"
#include "engine/measure/hazards.h"
#include "engine/measure/image_error.h"
#include "engine/measure/run_record.h"
#include "macula_version.h"
#include "passes/frame_renderer.h"

namespace macula::tools {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// One renderer with the buffers that its images are read into.
class Painter {
 public:
  Painter(const passes::RenderSettings& settings, passes::Machine& machine,
          const scene::GpuScene& gpu, glm::ivec2 size)
      : renderer_(settings, machine), linearOut_(settings.tonemap.linearOut) {
    renderer_.resize(size);
    renderer_.setScene(gpu);
    display_.width = linear_.width = size.x;
    display_.height = linear_.height = size.y;
    display_.channels = linear_.channels = 3;
    linear_.linear = true;
  }

  passes::FrameResult draw(const scene::Camera& camera, const gaze::PointOfInterest& gaze,
                           bool cut) {
    return renderer_.render(camera, gaze, cut);
  }
  void readBack() {
    renderer_.readDisplay(display_.pixels);
    if (linearOut_) renderer_.readLinear(linear_.pixels);
  }
  void write(const std::filesystem::path& folder, std::string_view stem, int index,
             const std::string& format) const {
    const auto path = folder / fmt::format("{}_{:05}.{}", stem, index, format);
    if (format == "png") image::writePng(path, display_);
    if (format == "exr") image::writeExr(path, linear_);
  }

  [[nodiscard]] const passes::FrameRenderer& renderer() const { return renderer_; }
  [[nodiscard]] const image::Image8& display() const { return display_; }
  [[nodiscard]] const image::ImageF& linear() const { return linear_; }

 private:
  passes::FrameRenderer renderer_;
  bool linearOut_;
  image::Image8 display_;
  image::ImageF linear_;
};

measure::FrameRecord recordOf(const passes::FrameResult& result,
                              const gaze::PointOfInterest& point) {
  measure::FrameRecord record;
  record.gazeX = point.position.x;
  record.gazeY = point.position.y;
  record.rawX = point.raw.x;
  record.rawY = point.raw.y;
  record.gazeState = gaze::stateName(point.state);
  record.gazeAgeSeconds = point.ageSeconds;
  record.gazeRadius = point.radius;
  record.gazeSaccade = point.saccade;
  record.totalMs = result.totalMs;
  for (const frame::PassTime& pass : result.passes) {
    record.passMs.emplace_back(pass.name, pass.ms);
  }
  if (result.fragments) {
    record.fragments =
        measure::FragmentNumbers{result.fragments->generated, result.fragments->stored,
                                 result.fragments->merged, result.fragments->lost};
  }
  if (result.layers) {
    record.layers =
        measure::LayerNumbers{result.layers->min, result.layers->max, result.layers->mean};
  }
  record.exact = result.exact;
  return record;
}

void describeRun(measure::RunRecord& run, const ReplayOptions& options,
                 const passes::Machine& machine, const passes::FrameRenderer& renderer,
                 glm::ivec2 size) {
  run.commit = MACULA_COMMIT;
  run.scene = options.scene;
  run.width = size.x;
  run.height = size.y;
  run.renderer = machine.capabilities.renderer;
  run.version = machine.capabilities.version;
  run.timeSource = gl::nameOf(machine.time.source);
  run.method = options.settings.oit.method;
  if (renderer.plan().method->insertion == passes::Insertion::Sorted) {
    run.sync = passes::nameOf(renderer.plan().sync);
  }
  run.settings = options.registry.toJson();
  const frame::ResourceBytes bytes = renderer.bytes();
  run.oitBytes = bytes.oit;
  run.budgetBytes = renderer.plan().budgetBytes;
  run.overheadBytes = bytes.overhead;
  run.gbufferBytes = bytes.gbuffer;
  for (std::size_t i = 0; i < frame::kResourceCount; ++i) {
    const auto resource = static_cast<frame::Resource>(i);
    const frame::ByteClass kind = frame::infoOf(resource).bytes;
    if (kind != frame::ByteClass::Oit && kind != frame::ByteClass::Overhead) continue;
    const std::uint64_t own = renderer.resources().bytesOf(resource);
    if (own > 0) run.transparencyBytes.emplace_back(frame::nameOf(resource), own);
  }
}

/// Fills in what compares a frame with its reference.
void compareWithReference(measure::FrameRecord& record, const Painter& reference,
                          const Painter& test, const ReplayOptions& options,
                          measure::FlickerMeter& flicker) {
  measure::CompareOptions compare;
  compare.hdr = options.hdr;
  compare.pixelsPerDegree = options.pixelsPerDegree;
  compare.gaze = glm::dvec2(record.gazeX, record.gazeY);
  const image::ImageF wanted = measure::toDisplay(reference.linear());
  const image::ImageF got = measure::toDisplay(test.linear());
  record.error = options.hdr ? measure::compareImages(reference.linear(), test.linear(), compare)
                             : measure::compareImages(wanted, got, compare);
  record.flicker = flicker.next(wanted, got);
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
  fmt::print("{} frames of {} by {}: median {:.2f} ms", options.frames, options.scene,
             options.settings.oit.method, summary["ms"]["median"].get<double>());
  if (options.reference) fmt::print(", rmse {:.5f}", summary["error"]["rmse"].get<double>());
  fmt::print("\nreport: {}\n", (std::filesystem::path(options.out) / "report.json").string());
}

}  // namespace

void replay(const ReplayOptions& options) {
  const auto begin = Clock::now();
  const glm::ivec2 size = parseSize(options.size);
  makeOutputFolder(options.out);
  const auto gazeSource = gaze::parseGazeSpec(options.gaze, options.gazeSettings);
  const auto trueGaze = gaze::parseGazeSpec(options.gaze, gaze::undelayed(options.gazeSettings));
  LoadedScene loaded = loadForRendering(options.scene, options.settings);
  for (const std::string& warning : loaded.scene.warnings) {
    fmt::print(stderr, "warning: {}\n", oneLine(warning));
  }
  const scene::CameraPath path = parseCameraSpec(options.camera, loaded.scene);

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
  }

  measure::FlickerMeter flicker;
  ProgressBar progress("replay", options.frames);
  double previous = 0.0;
  for (int i = 0; i < options.frames; ++i) {
    const double time = i / options.fps;
    const gaze::PointOfInterest point = gazeSource->at(time);
    const bool cut = i > 0 && path.cutAt(previous, time);
    const scene::Camera camera = path.at(time);
    measure::FrameRecord record = recordOf(painter.draw(camera, point, cut), point);
    record.gazeErrorDegrees =
        gaze::pointError(point, trueGaze->at(time), options.gazeSettings.display);
    noteFirstFrame();
    painter.readBack();
    record.index = i;
    record.timeSeconds = time;
    record.imageSha256 = sha256Hex(std::as_bytes(std::span(painter.display().pixels)));
    if (!options.images.empty()) painter.write(options.out, "frame", i, options.images);
    if (turns) {
      turns->draw(camera, point, cut);
      turns->readBack();
      record.hazards = measure::countUnlikePixels(turns->display(), painter.display());
    }
    if (reference) {
      reference->draw(camera, point, cut);
      reference->readBack();
      compareWithReference(record, *reference, painter, options, flicker);
      if (!options.images.empty()) reference->write(options.out, "reference", i, options.images);
    }
    run.frames.push_back(std::move(record));
    previous = time;
    progress.advance();
  }

  describeRun(run, options, machine, painter.renderer(), size);
  const nlohmann::ordered_json report = measure::toJson(run);
  writeFileAtomically(std::filesystem::path(options.out) / "report.json", report.dump(2) + "\n");
  writeJson(options.json, report);
  if (options.json != "-") printSummary(options, report);
}

}  // namespace macula::tools
