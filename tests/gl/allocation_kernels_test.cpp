// The kernels of the allocation in both shapes of their work-groups.
#include <gmock/gmock.h>

#include <algorithm>

#include "engine/scene/procedural/recipes.h"
#include "oit_cases.h"

namespace macula::test {
namespace {

using passes::OitSettings;
using passes::Predictor;
using passes::Tail;

class Kernels : public GlTest {};

/// What the allocation of one frame gave and found.
struct Found {
  std::vector<std::uint32_t> slots;  ///< of each pixel, and whether with a tail
  std::vector<std::uint32_t> totals;
  std::vector<std::uint32_t> statistics;
  std::vector<std::uint32_t> importance;
  std::vector<float> image;
};

std::vector<Found> draw(const scene::Scene& scene, const OitSettings& oit, glm::ivec2 size,
                        passes::DeviceContext& device) {
  passes::RenderSettings settings = settingsOf(oit);
  settings.readBack = true;
  Bench bench(scene, settings, size, device);
  std::vector<Found> frames;
  for (int frame = 0; frame < 2; ++frame) {  // the second has history
    bench.draw({0.4F, 0.6F});
    Found found;
    if (bench.renderer.plan().method->hasRanges()) {
      const auto ranges = bench.words(passes::kFragmentRange, 2);
      for (std::size_t p = 0; 2 * p < ranges.size(); ++p) found.slots.push_back(ranges[2 * p + 1]);
    }
    found.totals = bench.bufferWords(passes::kOitTotals);
    found.statistics = bench.bufferWords(passes::kOitStatistics);
    if (bench.renderer.plan().mapsImportance()) {
      found.importance = bench.words(passes::kImportance, 1);
    }
    found.image = bench.linear();
    frames.push_back(std::move(found));
  }
  return frames;
}

TEST_F(Kernels, OfBothShapesFindTheSame) {
  std::vector<OitSettings> cases{{.method = "ab-sbuffer"}};
  for (const double kAve : {0.3, 2.5}) {  // fewer slots than covered pixels, and more
    for (const bool fill : {false, true}) {
      cases.push_back({.method = "kb-plus", .kAve = kAve, .fill = fill});
      cases.push_back({.method = "kb-variable", .kAve = kAve, .fill = fill});
    }
  }
  cases.push_back({.method = "kb-variable", .kAve = 2.5, .tail = Tail::Mean});
  cases.push_back({.method = "kb-variable", .kAve = 2.5, .fill = true, .tail = Tail::Mean});
  cases.push_back({.method = "kb-variable", .kAve = 2.5, .importance = Predictor::Error});
  cases.push_back({.method = "kb-learned", .kAve = 2.5});
  cases.push_back(learnedUtility(2.5));
  passes::DeviceContext alone;
  passes::DeviceContext together;
  alone.sumInGroups(false);
  together.sumInGroups(true);
  const scene::Scene scene = unlit(tangle(240, 7));
  // More than one chunk of a row's strips, no multiple of a strip or a tile; more rows than a group
  // that sums rows has threads; less than a strip.
  for (const glm::ivec2 size : {glm::ivec2(1061, 37), glm::ivec2(41, 301), glm::ivec2(19, 5)}) {
    for (const OitSettings& oit : cases) {
      const std::vector<Found> one = draw(scene, oit, size, alone);
      const std::vector<Found> other = draw(scene, oit, size, together);
      for (std::size_t frame = 0; frame < one.size(); ++frame) {
        const std::string what =
            describe(oit) + " frame " + std::to_string(frame) + " width " + std::to_string(size.x);
        EXPECT_EQ(one[frame].slots, other[frame].slots) << what;
        EXPECT_EQ(one[frame].totals, other[frame].totals) << what;
        EXPECT_EQ(one[frame].statistics, other[frame].statistics) << what;
        EXPECT_EQ(one[frame].importance, other[frame].importance) << what;
        EXPECT_EQ(countUnlike(one[frame].image, other[frame].image), 0U) << what;
      }
    }
  }
  note("cases in three sizes", static_cast<double>(cases.size()));
}

/// The largest k with sum min(n, k) <= slots, by trying one after another.
std::uint32_t largestCommon(const std::vector<float>& counts, std::uint64_t slots) {
  const auto needs = [&](std::uint32_t k) {
    std::uint64_t sum = 0;
    for (const float n : counts) sum += std::min(static_cast<std::uint32_t>(n), k);
    return sum;
  };
  std::uint32_t k = 0;
  while (needs(k + 1) <= slots && needs(k + 1) > needs(k)) ++k;
  return k;
}

TEST_F(Kernels, TheOneLayerCountIsTheLargestThatFits) {
  EXPECT_EQ(largestCommon({1.0F, 3.0F, 3.0F, 0.0F}, 6), 2U) << "1 + 2 + 2 <= 6 < 1 + 3 + 3";
  EXPECT_EQ(largestCommon({1.0F, 3.0F}, 99), 3U) << "no more than there are fragments";
  passes::DeviceContext own;
  for (const bool groups : {false, true}) {
    own.sumInGroups(groups);
    for (const scene::Scene& scene : {unlit(tangle(900, 4)), scene::makeLayers(300, 1)}) {
      for (const double kAve : {0.2, 1.0, 2.5, 4.0, 7.0, 299.0}) {
        Bench bench(scene, settingsOf({.method = "kb-plus", .kAve = kAve}), {53, 35}, own);
        bench.draw();
        const auto counts = bench.floats(passes::kFragmentCount, 1);
        const std::uint32_t k = largestCommon(counts, bench.renderer.plan().slots);
        const auto ranges = bench.words(passes::kFragmentRange, 2);
        for (std::size_t p = 0; p < counts.size(); ++p) {
          ASSERT_EQ(ranges[2 * p + 1], std::min(static_cast<std::uint32_t>(counts[p]), k))
              << "k " << kAve << " pixel " << p;
        }
      }
    }
  }
}

}  // namespace
}  // namespace macula::test
