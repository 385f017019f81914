// Slots by a network: the budget holds whatever it predicts, and like pixels get like slots.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>

#include "engine/scene/procedural/recipes.h"
#include "network_cases.h"
#include "slots.h"

namespace macula::test {
namespace {

using passes::OitSettings;

/// Draws a frame and checks what was given. @returns the slots of each pixel
std::vector<Given> expectBudgetHolds(Bench& bench, const std::string& what) {
  const passes::FrameResult result = bench.draw();
  const passes::OitPlan& plan = bench.renderer.plan();
  std::vector<Given> given = givenBy(bench);
  const std::uint64_t sum = expectDisjoint(given, plan.slots, what);
  EXPECT_LE(sum, plan.slots) << what;
  EXPECT_GT(result.fragments->generated, 0U) << what;
  EXPECT_TRUE(allFinite(bench.linear())) << what;
  if (plan.sharesByUtility()) {
    EXPECT_EQ(sum, std::min<std::uint64_t>(plan.slots, result.fragments->generated)) << what;
    for (const Given& g : given) EXPECT_LE(g.slots, g.count) << what;
  }
  return given;
}

TEST_F(Networks, OfAnyWeightsKeepTheBudget) {
  const std::vector<scene::Scene> scenes{unlit(tangle(240, 3)), unlit(scene::makeMedley(2)),
                                         scene::makeLayers(8, 1)};
  int frames = 0;
  for (const OitSettings& way : ways(1.0)) {
    for (const std::uint32_t seed : {1U, 2U}) {
      OitSettings oit = random(way, seed);
      for (const scene::Scene& scene : scenes) {
        for (const double kAve : {0.3, 1.5, 4.0, 30.0}) {
          oit.kAve = kAve;
          for (const int tile : {1, 2, 4}) {
            Bench bench(scene, tiled(oit, tile), {45, 38}, device());
            expectBudgetHolds(bench, describe(oit) + " tile " + std::to_string(tile));
            ++frames;
          }
        }
      }
    }
  }
  note("frames", frames);
}

TEST_F(Networks, ThatSayNothingOrTooMuchKeepTheBudget) {
  const scene::Scene scene = unlit(tangle(240, 3));
  for (const OitSettings& way : ways(2.0)) {
    const network::Network usual = randomNetwork(modelOf(way), {4}, 1);
    std::vector<network::Network> all;
    for (const float bias : {-1e4F, 1e4F}) {  // nothing is important; all is as much as can be
      network::Network network = usual;
      std::fill(network.layers.back().bias.begin(), network.layers.back().bias.end(), bias);
      all.push_back(network);
    }
    network::Network huge = usual;  // sums overflow, and one infinity is taken from another
    for (network::DenseLayer& layer : huge.layers) {
      for (float& weight : layer.weights) weight *= 1e38F;
    }
    all.push_back(huge);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const OitSettings oit = with(way, all[i]);
      for (const int tile : {1, 2}) {
        Bench bench(scene, tiled(oit, tile), {45, 38}, device());
        expectBudgetHolds(bench, describe(oit) + " network " + std::to_string(i));
      }
    }
  }
}

TEST_F(Networks, GiveTheSameFrameAgain) {
  const scene::Scene scene = unlit(tangle(240, 3));
  for (const OitSettings& way : ways(2.0)) {
    for (const int tile : {1, 2, 4}) {
      const OitSettings oit = random(way, 5);
      Bench a(scene, tiled(oit, tile), {50, 40}, device());
      Bench b(scene, tiled(oit, tile), {50, 40}, device());
      a.draw();
      b.draw();
      const std::vector<float> first = a.linear();
      EXPECT_EQ(countUnlike(first, b.linear()), 0U) << describe(oit);
      a.draw();
      EXPECT_EQ(countUnlike(first, a.linear()), 0U) << describe(oit) << ": no history";
      EXPECT_EQ(a.bufferWords(passes::kOitTotals), b.bufferWords(passes::kOitTotals));
    }
  }
}

TEST_F(Networks, GiveAlikePixelsAlikeSlotsWhateverTheTile) {
  const scene::Scene scene = scene::makeLayers(8, 1);
  for (const OitSettings& way : ways(3.5)) {
    const OitSettings oit = random(way, 4);
    std::uint32_t least = 1000;
    std::uint32_t most = 0;
    for (const int tile : {1, 2, 4}) {
      Bench bench(scene, tiled(oit, tile), {45, 38}, device());
      bench.draw();
      for (const Given& g : givenBy(bench)) {
        ASSERT_EQ(g.count, 8U);
        least = std::min(least, g.slots);
        most = std::max(most, g.slots);
      }
    }
    EXPECT_GE(least, 3U) << describe(oit);
    EXPECT_LE(most - least, 1U) << describe(oit);
  }
}

/// Slots of each pixel of two halves side by side, each even in itself and of another depth.
/// @param margin pixels left out on both sides of the seam
void expectEvenHalves(Bench& bench, glm::ivec2 size, int margin, const std::string& what) {
  const std::vector<Given> given = givenBy(bench);
  const auto at = [&](int x, int y) { return given[static_cast<std::size_t>(y * size.x + x)]; };
  int uneven = 0;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const bool left = x < size.x / 2;
      const int first = left ? 0 : size.x / 2 + margin;
      const int last = left ? size.x / 2 - 1 - margin : size.x - 1;
      if (x < first || x > last) continue;
      ASSERT_EQ(at(x, y).count, left ? 3U : 9U) << x << "," << y;
      const auto unlike = [&](const Given& other) {
        return std::abs(static_cast<int>(at(x, y).slots) - static_cast<int>(other.slots)) > 1;
      };
      // All of a half, not only neighbours: the remainder of the budget is one slot at the most.
      uneven += unlike(at(first, 0)) ? 1 : 0;
    }
  }
  EXPECT_EQ(uneven, 0) << what;
}

TEST_F(Networks, LeaveSmoothHalvesWithoutSpeckle) {
  // Tsopouridis 2021, Fig. 5.1: the formula's noise gives neighbours that are alike unlike k.
  const glm::ivec2 size(64, 40);
  scene::Scene scene = emptyScene();
  for (int i = 0; i < 9; ++i) {
    const float distance = 2.0F + 0.5F * static_cast<float>(i);
    if (i < 3) addRectangle(scene, distance, {-60, -60}, {0, 60}, variedColor(i + 1, 0.4F), false);
    addRectangle(scene, distance, {0, -60}, {60, 60}, variedColor(i + 5, 0.3F), false);
  }
  for (const double kAve : {1.0, 2.7, 4.0}) {
    for (const OitSettings& way : ways(kAve)) {
      for (const std::uint32_t seed : {1U, 2U, 3U}) {
        const OitSettings oit = random(way, seed);
        for (const int tile : {1, 4}) {
          Bench bench(scene, tiled(oit, tile), size, device());
          bench.draw();
          // Between tiles importance fades over one of them, so that one and a half are left out.
          expectEvenHalves(bench, size, tile == 1 ? 0 : 6, describe(oit));
        }
      }
    }
  }
}

}  // namespace
}  // namespace macula::test
