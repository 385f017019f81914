#include "engine/experiment/study.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "engine/core/error.h"
#include "engine/core/nearest.h"
#include "engine/experiment/plan.h"

namespace macula::experiment {
namespace {

constexpr int kMaxSide = 16384;  ///< as --size
constexpr double kMaxSeed = 2147483647;
constexpr int kMaxFrames = 10000;
constexpr double kLeastPathFps = 0.01;  ///< slower than this, frames have nothing in common
constexpr double kMostPathFps = 1000.0;
constexpr double kMostKAve = 4096.0;  ///< the ranges of oit.kAve and oit.memoryMiB
constexpr double kMostMiB = 8192.0;
constexpr double kLeastBudget = 1e-6;
constexpr double kLeastPixelsPerDegree = 1.0;  ///< as FLIP takes them
constexpr double kMostPixelsPerDegree = 1000.0;
/// More points than anybody waits for: a slip in a list, not a plan.
constexpr std::size_t kMostPoints = 100000;

Size parseSize(const std::string& text, const std::string& place) {
  Size size;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, size.width);
  const bool cross = first.ec == std::errc{} && first.ptr != end && *first.ptr == 'x';
  const auto second = cross ? std::from_chars(first.ptr + 1, end, size.height) : first;
  const auto fits = [](int side) { return side >= 1 && side <= kMaxSide; };
  if (!cross || second.ec != std::errc{} || second.ptr != end || !fits(size.width) ||
      !fits(size.height)) {
    failInput("{}: sizes: '{}' is no size; write \"WIDTHxHEIGHT\" with sides from 1 to {}", place,
              oneLine(text), kMaxSide);
  }
  return size;
}

Budget readBudget(settings::TypedReader& reader) {
  Budget budget;
  int kinds = 0;
  const auto take = [&](const char* key, Budget::Kind kind, double most) {
    if (!reader.has(key)) return;
    ++kinds;
    budget.kind = kind;
    budget.value = reader.get<double>(key, {.min = kLeastBudget, .max = most});
  };
  take("k_ave", Budget::Kind::KAve, kMostKAve);
  take("mib", Budget::Kind::MiB, kMostMiB);
  take("share", Budget::Kind::Share, 1.0);
  reader.take("scenes", budget.scenes);
  reader.finish();
  if (kinds != 1) {
    failInput("{}: a budget is one of {{ k_ave = 2 }}, {{ mib = 35 }} and {{ share = 0.3 }}",
              reader.place());
  }
  return budget;
}

void requireUnique(const std::vector<std::string>& names, std::string_view what,
                   const std::string& place) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) !=
        names.begin() + static_cast<std::ptrdiff_t>(i)) {
      failInput("{}: {} '{}' stands twice; keep one", place, what, oneLine(names[i]));
    }
  }
}

/// Lists whose members would make the same point twice.
void requireDistinct(const Study& study) {
  requireUnique(study.scenes, "scene", study.place);
  requireUnique(study.lights, "light", study.place);
  std::vector<std::string> texts;
  for (const Size& size : study.sizes)
    texts.push_back(fmt::format("{}x{}", size.width, size.height));
  requireUnique(texts, "size", study.place);
  texts.clear();
  for (const std::int64_t seed : study.seeds) texts.push_back(std::to_string(seed));
  requireUnique(texts, "seed", study.place);
  for (const std::string& scene : study.scenes) {
    texts.clear();
    for (const Budget& budget : study.budgets) {
      if (budget.appliesTo(scene)) texts.push_back(budget.label());
    }
    requireUnique(texts, "for one scene the budget", study.place);
  }
}

const Variant& variantOf(const std::vector<Variant>& variants, const std::string& id) {
  return *std::find_if(variants.begin(), variants.end(),
                       [&](const Variant& variant) { return variant.id == id; });
}

/// How many points a variant makes in one group.
std::size_t pointsOf(const Variant& variant, const Study& study) {
  if (variant.sweep) return variant.sweep->values.size();
  return variant.budgets ? study.budgets.size() : 1;
}

void requireFewEnough(const Study& study, const std::vector<Variant>& variants) {
  std::size_t ofGroup = 0;
  for (const std::string& id : study.variants) ofGroup += pointsOf(variantOf(variants, id), study);
  std::size_t points = ofGroup;
  for (const std::size_t count :
       {study.scenes.size(), study.sizes.size(), study.seeds.size(), study.lights.size()}) {
    points = points > kMostPoints ? points : points * count;
  }
  if (points > kMostPoints) {
    failInput("{}: its lists make more than {} points; shorten them", study.place, kMostPoints);
  }
}

void completeCompare(Study& study) {
  if (study.compare.empty()) {
    study.compare = {study.variants};
    return;
  }
  study.comparesByList = true;
  std::vector<std::string> all;
  for (const auto& list : study.compare) all.insert(all.end(), list.begin(), list.end());
  requireUnique(all, "in compare the variant", study.place);
  for (const std::string& id : all) requireKnown(id, study.variants, "variant", study.place);
  std::vector<std::string> rest;
  for (const std::string& id : study.variants) {
    if (std::find(all.begin(), all.end(), id) == all.end()) rest.push_back(id);
  }
  if (!rest.empty()) study.compare.push_back(rest);
}

bool holds(const std::vector<std::string>& list, const std::string& id) {
  return std::find(list.begin(), list.end(), id) != list.end();
}

/// Points without a budget are interleaved, so a sweep's renderers live together with all of them.
void requireRoomForSweeps(const Study& study, const std::vector<Variant>& variants) {
  if (study.comparesByList) return;
  std::size_t together = 0;
  bool swept = false;
  for (const std::string& id : study.variants) {
    const Variant& variant = variantOf(variants, id);
    if (!variant.budgets) together += pointsOf(variant, study);
    swept = swept || variant.sweep;
  }
  if (swept && together > kMostTogether) {
    failInput(
        "{}: its sweeps make {} renderers that live at the same time, more than {}; name "
        "those to interleave in compare, or shorten the sweeps",
        study.place, together, kMostTogether);
  }
}

/// The base must be one point, and every curve must be interleaved with it.
void requireBase(const Study& study, const std::vector<Variant>& variants) {
  if (study.base.empty()) return;
  requireKnown(study.base, study.variants, "base variant", study.place);
  const Variant& base = variantOf(variants, study.base);
  if (base.sweep || base.budgets) {
    failInput("{}: base '{}' has a sweep or budgets; name a variant that is one point", study.place,
              base.id);
  }
  const auto& list = *std::find_if(study.compare.begin(), study.compare.end(),
                                   [&](const auto& ids) { return holds(ids, base.id); });
  for (const std::string& id : study.variants) {
    if (variantOf(variants, id).sweep && !holds(list, id)) {
      failInput(
          "{}: variant '{}' is not interleaved with the base '{}'; name both in one list of "
          "compare",
          study.place, id, base.id);
    }
  }
}

}  // namespace

void requireKnown(const std::string& name, const std::vector<std::string>& known,
                  std::string_view what, std::string_view place) {
  if (std::find(known.begin(), known.end(), name) != known.end()) return;
  failInput("{}: unknown {} '{}'; the nearest is '{}'", place, what, oneLine(name),
            nearestName(name, known));
}

void readStudyKeys(settings::TypedReader& reader, Study& study) {
  reader.take("scenes", study.scenes);
  reader.take("optional_scenes", study.optionalScenes);
  if (const auto sizes = reader.find<std::vector<std::string>>("sizes")) {
    study.sizes.clear();
    for (const std::string& size : *sizes) {
      study.sizes.push_back(parseSize(size, reader.place("sizes")));
    }
  }
  reader.take("seeds", study.seeds, {.min = 0.0, .max = kMaxSeed});
  reader.take("lights", study.lights);
  reader.take("camera", study.camera);
  reader.take("gaze", study.gaze);
  reader.take("base", study.base);
  reader.take("frames", study.frames, {.min = 1.0, .max = kMaxFrames});
  reader.take("path_frames", study.pathFrames, {.min = 0.0, .max = kMaxFrames});
  if (study.pathFrames == 1) {
    failInput("{}: path_frames: one frame has no change to the next; give 0 for none, or 2 or more",
              reader.place("path_frames"));
  }
  reader.take("path_fps", study.pathFps, {.min = kLeastPathFps, .max = kMostPathFps}, "frames/s");
  reader.take("flip_maps", study.flipMaps);
  reader.take("pixels_per_degree", study.pixelsPerDegree,
              {.min = kLeastPixelsPerDegree, .max = kMostPixelsPerDegree});
  reader.take("compare", study.compare);
  if (reader.has("budgets")) study.budgets.clear();
  for (settings::TypedReader& budget : reader.tables("budgets")) {
    study.budgets.push_back(readBudget(budget));
  }
  if (const toml::table* settings = reader.table("settings").toml()) {
    study.settings.push_back(settings);
  }
}

void completeStudy(Study& study, const std::vector<Variant>& variants) {
  std::vector<std::string> known;
  for (const Variant& variant : variants) known.push_back(variant.id);
  if (study.variants.empty()) study.variants = known;
  for (const std::string& id : study.variants) requireKnown(id, known, "variant", study.place);
  requireUnique(study.variants, "variant", study.place);
  study.scenes.insert(study.scenes.end(), study.optionalScenes.begin(), study.optionalScenes.end());
  if (study.scenes.empty()) {
    failInput("{}: no scenes; add scenes = [\"smoke\"]", study.place);
  }
  for (const Budget& budget : study.budgets) {
    for (const std::string& scene : budget.scenes) {
      requireKnown(scene, study.scenes, "scene of a budget", study.place);
    }
  }
  for (const Variant& variant : variants) {
    if (holds(study.variants, variant.id) && variant.budgets && study.budgets.empty()) {
      failInput(
          "{}: variant '{}' has budgets = true and there are none; add budgets = "
          "[{{ k_ave = 2 }}]",
          study.place, variant.id);
    }
  }
  if (study.sizes.empty()) study.sizes = {{256, 256}};
  if (study.seeds.empty()) study.seeds = {1};
  if (study.lights.empty()) study.lights = {kOwnLight};
  requireFewEnough(study, variants);
  requireDistinct(study);
  completeCompare(study);
  requireRoomForSweeps(study, variants);
  requireBase(study, variants);
}

}  // namespace macula::experiment
