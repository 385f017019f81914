// `macula features`: renders views of scenes, asks the oracles, and writes what was found.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "common.h"
#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/core/interrupt.h"
#include "engine/core/output_folder.h"
#include "engine/core/plural.h"
#include "engine/dataset/npz.h"
#include "engine/experiment/tone_curve.h"
#include "engine/measure/oracle.h"
#include "engine/window/headless.h"
#include "macula_version.h"
#include "passes/device_context.h"
#include "passes/oit/learned/read_features.h"
#include "passes/oit/statistics/read_fragments.h"
#include "training_features.h"

namespace macula::tools {
namespace {

constexpr int kVersion = 1;
/// Where the share of the budget stands among the thesis's features.
constexpr std::size_t kReservedShare = 1;

/// Rows of one scene, one a sampled pixel.
struct Rows {
  std::vector<std::uint16_t> view;
  std::vector<std::uint32_t> pixel;                              ///< of its view, from the top left
  std::vector<std::uint32_t> fragments;                          ///< of the pixel
  std::vector<float> thesis, learned;                            ///< features
  std::vector<std::uint16_t> optimal, leastRmse, leastRmseTail;  ///< k, one a budget
  std::vector<std::uint64_t> errorsBegin{0};                     ///< in `errors` and `errorsPlain`
  std::vector<float> errors;       ///< squared error of k = 0 ... n slots with a tail
  std::vector<float> errorsPlain;  ///< and without
  std::vector<std::uint64_t> viewFragments, viewPixels, viewCovered;  ///< one a view
};

/// A uniform number below 1 from a seed and a place; PCG's output function (O'Neill 2014).
double uniformAt(std::uint32_t seed, std::size_t view, std::size_t pixel) {
  const auto mix = [](std::uint32_t value) {
    const std::uint32_t state = value * 747796405U + 2891336453U;
    const std::uint32_t word = ((state >> ((state >> 28U) + 4U)) ^ state) * 277803737U;
    return (word >> 22U) ^ word;
  };
  constexpr double kRange = 4294967296.0;
  return mix(mix(mix(seed) + static_cast<std::uint32_t>(view)) +
             static_cast<std::uint32_t>(pixel)) /
         kRange;
}

std::uint16_t shortOf(std::uint32_t k) {
  return static_cast<std::uint16_t>(std::min<std::uint32_t>(k, 0xFFFFU));
}

/// The renderers of one scene.
class SceneViews {
 public:
  SceneViews(const FeaturesOptions& options, passes::DeviceContext& device,
             const scene::GpuScene& gpu)
      : options_(options),
        device_(device),
        exactSettings_(passes::referenceOf(options.settings)),
        thesisSettings_(exactSettings_),
        learnedSettings_(exactSettings_),
        exact_(exactSettings_, device),
        opaque_(exactSettings_, device),
        thesis_(thesisSettings_, device),
        learned_(learnedSettings_, device) {
    thesisSettings_.oit.method = "kb-learned";
    learnedSettings_.oit.method = "kb-variable";
    learnedSettings_.oit.importance = passes::Predictor::Learned;
    learnedSettings_.oit.fill = true;
    learnedSettings_.oit.tail = passes::Tail::Mean;
    learnedSettings_.readBack = true;
    const glm::ivec2 size = parseSize(options.size);
    for (passes::FrameRenderer* renderer : {&exact_, &opaque_, &thesis_, &learned_}) {
      renderer->resize(size);
      renderer->setScene(gpu);
    }
    opaque_.showTransparency(false);
    const auto exposure = static_cast<float>(std::exp2(options.settings.tonemap.exposure));
    display_ = [curve = options.settings.tonemap.curve, exposure](const glm::vec3& linear) {
      return measure::displayColour(experiment::toneCurve(curve, linear * exposure));
    };
  }

  void addView(Rows& rows, const recording::Frame& frame) {
    const std::size_t view = frame.index;
    const auto draw = [&](passes::FrameRenderer& renderer) {
      return renderer.render(frame.camera, frame.gaze);
    };
    const passes::FrameResult result = draw(exact_);
    if (!result.exact)
      failInput("features: a view holds more fragments than fit; use a smaller --size");
    for (passes::FrameRenderer* renderer : {&opaque_, &thesis_, &learned_}) (void)draw(*renderer);
    const measure::FragmentImage image = passes::readFragments(exact_, opaque_);
    const std::vector<float> thesis = passes::readFeatures(thesis_, opaque_, device_.programs);
    const std::vector<float> learned = passes::readFeatures(learned_, opaque_, device_.programs);
    std::vector<measure::LayerChoice> optimal;
    std::vector<measure::LayerChoice> plain;
    std::vector<measure::LayerChoice> tail;
    for (const double share : options_.shares) {
      const auto slots =
          static_cast<std::uint64_t>(share * static_cast<double>(image.fragments.size()));
      optimal.push_back(measure::optimalK(image, slots, display_));
      plain.push_back(measure::leastRmse(image, slots, measure::Tail::None, display_));
      tail.push_back(measure::leastRmse(image, slots, measure::Tail::Mean, display_));
    }
    measure::ErrorCurve curve(image, measure::Tail::Mean, display_);
    measure::ErrorCurve plainCurve(image, measure::Tail::None, display_);
    for (std::size_t p = 0; p < image.pixels(); ++p) {
      if (image.depth(p) == 0) continue;
      if (uniformAt(options_.settings.seed, view, p) >= options_.sample) continue;
      rows.view.push_back(static_cast<std::uint16_t>(view));
      rows.pixel.push_back(static_cast<std::uint32_t>(p));
      rows.fragments.push_back(image.depth(p));
      append(rows.thesis, thesis, p, passes::featuresOf(passes::NetworkModel::Thesis).size());
      const std::size_t features = passes::featuresOf(passes::NetworkModel::Thesis).size();
      rows.thesis[rows.thesis.size() - features + kReservedShare] =
          static_cast<float>(options_.shares.front());
      append(rows.learned, learned, p, passes::featuresOf(passes::NetworkModel::Learned).size());
      for (std::size_t b = 0; b < options_.shares.size(); ++b) {
        rows.optimal.push_back(shortOf(optimal[b].k[p]));
        rows.leastRmse.push_back(shortOf(plain[b].k[p]));
        rows.leastRmseTail.push_back(shortOf(tail[b].k[p]));
      }
      for (const double error : curve.of(p)) rows.errors.push_back(static_cast<float>(error));
      for (const double error : plainCurve.of(p)) {
        rows.errorsPlain.push_back(static_cast<float>(error));
      }
      rows.errorsBegin.push_back(rows.errors.size());
    }
    rows.viewFragments.push_back(image.fragments.size());
    rows.viewPixels.push_back(image.pixels());
    rows.viewCovered.push_back(image.coveredPixels());
  }

 private:
  static void append(std::vector<float>& out, const std::vector<float>& features, std::size_t pixel,
                     std::size_t count) {
    const auto first = features.begin() + static_cast<std::ptrdiff_t>(pixel * count);
    out.insert(out.end(), first, first + static_cast<std::ptrdiff_t>(count));
  }

  const FeaturesOptions& options_;
  passes::DeviceContext& device_;
  passes::RenderSettings exactSettings_, thesisSettings_, learnedSettings_;
  passes::FrameRenderer exact_, opaque_, thesis_, learned_;
  measure::DisplayTransform display_;
};

/// The scene's own camera first, where it has one; the others evenly around it.
recording::ListedFrames viewsOf(const scene::Scene& scene, int views, glm::ivec2 size) {
  std::vector<scene::Camera> cameras;
  if (!scene.cameras.empty()) cameras.push_back(parseCameraSpec("scene", scene).at(0.0));
  const scene::CameraPath orbit = parseCameraSpec("auto", scene);
  const int around = views - static_cast<int>(cameras.size());
  for (int i = 0; i < around; ++i) cameras.push_back(orbit.at(scene::kOrbitSeconds * i / around));
  return {cameras, size};
}

void writeScene(const FeaturesOptions& o, const FeaturesScene& scene, const Rows& rows) {
  const std::size_t count = rows.pixel.size();
  const std::size_t budgets = o.shares.size();
  const auto thesis = passes::featuresOf(passes::NetworkModel::Thesis);
  const auto learned = passes::featuresOf(passes::NetworkModel::Learned);
  const nlohmann::ordered_json about{{"format", "macula-features"},
                                     {"version", kVersion},
                                     {"scene", scene.scene},
                                     {"split", scene.split},
                                     {"size", o.size},
                                     {"views", rows.viewFragments.size()},
                                     {"sample", o.sample},
                                     {"seed", o.settings.seed},
                                     {"shares", o.shares},
                                     {"thesis", thesis},
                                     {"learned", learned},
                                     {"settings", o.registry.toJson()},
                                     {"commit", MACULA_COMMIT}};
  dataset::NpzWriter npz;
  npz.addText("about", about.dump());
  npz.add("view", {count}, rows.view);
  npz.add("pixel", {count}, rows.pixel);
  npz.add("fragments", {count}, rows.fragments);
  npz.add("thesis", {count, thesis.size()}, rows.thesis);
  npz.add("learned", {count, learned.size()}, rows.learned);
  npz.add("optimal_k", {count, budgets}, rows.optimal);
  npz.add("least_rmse_k", {count, budgets}, rows.leastRmse);
  npz.add("least_rmse_tail_k", {count, budgets}, rows.leastRmseTail);
  npz.add("errors_begin", {count + 1}, rows.errorsBegin);
  npz.add("errors", {rows.errors.size()}, rows.errors);
  npz.add("errors_plain", {rows.errorsPlain.size()}, rows.errorsPlain);
  npz.add("view_fragments", {rows.viewFragments.size()}, rows.viewFragments);
  npz.add("view_pixels", {rows.viewPixels.size()}, rows.viewPixels);
  npz.add("view_covered", {rows.viewCovered.size()}, rows.viewCovered);
  npz.write(scene.file);
}

}  // namespace

void writeFeatures(const FeaturesOptions& o) {
  const std::vector<FeaturesScene> scenes = scenesOf(o);
  const InterruptGuard guard;
  OutputFolder output(o.out, "features", o.force);
  // Before minutes of rendering, not after.
  for (const FeaturesScene& scene : scenes) makeOutputFolder(scene.file.parent_path());
  const window::HeadlessContext context(platformOf(o.platform));
  passes::DeviceContext device;
  nlohmann::ordered_json written = nlohmann::ordered_json::array();
  ProgressBar progress("features", static_cast<int>(scenes.size()) * o.views);
  for (const FeaturesScene& scene : scenes) {
    if (interruptAsked()) break;
    const LoadedScene loaded = loadForRendering(scene.scene, o.settings);
    const scene::GpuScene gpu(loaded.scene, loaded.environment ? &*loaded.environment : nullptr);
    if (gpu.facts().transparentTriangles == 0) {
      failInput("features: nothing in '{}' is transparent; add --scene.opacity 0.5", scene.scene);
    }
    Rows rows;
    SceneViews views(o, device, gpu);
    recording::ListedFrames frames = viewsOf(loaded.scene, o.views, parseSize(o.size));
    playFrames(frames, progress,
               [&](const recording::Frame& frame) { views.addView(rows, frame); });
    if (rows.viewFragments.size() < frames.count()) break;
    if (written.empty()) output.begin();  // scenes of earlier calls stay
    writeScene(o, scene, rows);
    written.push_back(
        {{"file", scene.file.string()}, {"split", scene.split}, {"pixels", rows.pixel.size()}});
    if (o.json != "-") {
      fmt::print("{}: {}\n", scene.file.string(), counted(rows.pixel.size(), "pixel"));
    }
  }
  progress.end();
  if (written.empty()) endIfInterrupted();
  const bool interrupted = written.size() < scenes.size();
  writeJson(o.json, {{"interrupted", interrupted}, {"scenes", written}});
  if (interrupted) {
    throw Interrupted(fmt::format("interrupted: {} of {} scenes are in {}", written.size(),
                                  scenes.size(), o.out.string()));
  }
}

}  // namespace macula::tools
