// Slots by a network: the budget holds whatever it says, like pixels get like slots, tiles agree.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <glm/gtc/packing.hpp>

#include "engine/core/file.h"
#include "engine/scene/procedural/recipes.h"
#include "model_network.h"
#include "network_mirror.h"
#include "oit_cases.h"
#include "slots.h"
#include "temporary_path.h"

namespace macula::test {
namespace {

using frame::Resource;
using passes::NetworkModel;
using passes::OitSettings;
using passes::Tail;

/// Files of made-up networks, until the test ends.
class Networks : public GlTest {
 protected:
  void TearDown() override {
    for (const std::filesystem::path& file : files_) std::filesystem::remove(file);
    GlTest::TearDown();
  }
  std::filesystem::path write(const network::Network& network) {
    files_.emplace_back(temporaryPath(std::to_string(files_.size()) + ".safetensors"));
    writeFileAtomically(files_.back(), fileOf(network));
    return files_.back();
  }
  /// The options that use a model, with a network of so many hidden values.
  OitSettings with(OitSettings oit, const network::Network& network) {
    oit.network = write(network);
    return oit;
  }
  OitSettings random(OitSettings oit, std::uint32_t seed) {
    return with(oit, randomNetwork(modelOf(oit), {8}, seed));
  }
  static NetworkModel modelOf(const OitSettings& oit) {
    return passes::methodById(oit.method).learnsImportance() ? NetworkModel::Thesis
                                                             : NetworkModel::Learned;
  }
  /// kb-learned without and with a filled budget, and kb-variable by learned bids.
  static std::vector<OitSettings> ways(double kAve) {
    return {{.method = "kb-learned", .kAve = kAve},
            {.method = "kb-learned", .kAve = kAve, .fill = true},
            {.method = "kb-learned", .kAve = kAve, .fill = true, .tail = Tail::Mean},
            learnedBids(kAve)};
  }

 private:
  std::vector<std::filesystem::path> files_;
};

passes::RenderSettings tiled(const OitSettings& oit, int tile) {
  passes::RenderSettings settings = settingsOf(oit);
  settings.importance.networkTile = tile;
  return settings;
}

/// Draws a frame and checks what was given. @returns the slots of each pixel
std::vector<Given> expectBudgetHolds(Bench& bench, const std::string& what) {
  const passes::FrameResult result = bench.draw();
  const passes::OitPlan& plan = bench.renderer.plan();
  std::vector<Given> given = givenBy(bench);
  const std::uint64_t sum = expectDisjoint(given, plan.slots, what);
  EXPECT_LE(sum, plan.slots) << what;
  EXPECT_GT(result.fragments->generated, 0U) << what;
  EXPECT_TRUE(allFinite(bench.linear())) << what;
  if (plan.auctions()) {
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
            Bench bench(scene, tiled(oit, tile), {45, 38}, machine());
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
        Bench bench(scene, tiled(oit, tile), {45, 38}, machine());
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
      Bench a(scene, tiled(oit, tile), {50, 40}, machine());
      Bench b(scene, tiled(oit, tile), {50, 40}, machine());
      a.draw();
      b.draw();
      const std::vector<float> first = a.linear();
      EXPECT_EQ(countUnlike(first, b.linear()), 0U) << describe(oit);
      a.draw();
      EXPECT_EQ(countUnlike(first, a.linear()), 0U) << describe(oit) << ": no history";
      EXPECT_EQ(a.bufferWords(Resource::OitTotals), b.bufferWords(Resource::OitTotals));
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
      Bench bench(scene, tiled(oit, tile), {45, 38}, machine());
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
          Bench bench(scene, tiled(oit, tile), size, machine());
          bench.draw();
          // Between tiles importance fades over one of them, so that one and a half are left out.
          expectEvenHalves(bench, size, tile == 1 ? 0 : 6, describe(oit));
        }
      }
    }
  }
}

/// Mean |difference of slots| of neighbours with as many fragments.
double speckleOf(const Bench& bench, glm::ivec2 size) {
  const std::vector<Given> given = givenBy(bench);
  double sum = 0.0;
  double pairs = 0.0;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const Given& own = given[static_cast<std::size_t>(y * size.x + x)];
      for (const glm::ivec2 step : {glm::ivec2(1, 0), glm::ivec2(0, 1)}) {
        const glm::ivec2 p = glm::ivec2(x, y) + step;
        if (p.x >= size.x || p.y >= size.y || own.count == 0) continue;
        const Given& other = given[static_cast<std::size_t>(p.y * size.x + p.x)];
        if (other.count != own.count) continue;
        sum += std::abs(static_cast<double>(own.slots) - static_cast<double>(other.slots));
        pairs += 1.0;
      }
    }
  }
  EXPECT_GT(pairs, 500.0);
  return sum / pairs;
}

TEST_F(Networks, SpeckleNoMoreWhereTheySpeakForTiles) {
  const glm::ivec2 size(96, 96);
  const scene::Scene scene = unlit(scene::makeMedley(0));
  for (const OitSettings& way : ways(4.0)) {
    // Unfilled budgets are divided with so little to spare that k hardly differs at all.
    if (!way.fill) continue;
    // Of several networks, because the budget's remainder falls here or there.
    double speckle[2]{};
    for (const std::uint32_t seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
      const OitSettings oit = random(way, seed);
      for (const int tile : {1, 2}) {
        Bench bench(scene, tiled(oit, tile), size, machine());
        bench.draw();
        speckle[tile - 1] += speckleOf(bench, size) / 6.0;
      }
    }
    note(describe(way) + " tile 1", speckle[0]);
    note(describe(way) + " tile 2", speckle[1]);
    EXPECT_LE(speckle[1], speckle[0]) << describe(way);
  }
}

TEST_F(Networks, AreReadBetweenTilesAsTheMirrorSays) {
  // By hand: pixel 2 of tiles of 4 lies at 2.5 / 4 - 0.5 = 0.125 of the way to the next tile.
  EXPECT_DOUBLE_EQ(outputBetween({1.0, 3.0}, {1.0, 1.0}, {2, 1}, 4, {2, 1}), 1.25);
  EXPECT_DOUBLE_EQ(outputBetween({1.0, 3.0}, {1.0, 0.0}, {2, 1}, 4, {2, 1}), 1.0) << "empty";
  EXPECT_DOUBLE_EQ(outputBetween({1.0, 3.0}, {1.0, 1.0}, {2, 1}, 4, {0, 0}), 1.0) << "the edge";
  const scene::Scene scene = unlit(tangle(60, 3));
  const glm::ivec2 size(45, 38);  // no multiple of a tile
  for (const int tile : {1, 2, 4}) {
    Bench bench(scene, tiled(random({.method = "kb-learned"}, 3), tile), size, machine());
    bench.draw();
    const glm::ivec2 tiles = (size + tile - 1) / tile;
    const auto words = bench.words(Resource::NetworkOutput, 4);
    ASSERT_EQ(words.size(), static_cast<std::size_t>(4 * tiles.x * tiles.y));
    std::vector<double> said;
    std::vector<double> covered;
    for (std::size_t i = 0; i < words.size(); i += 4) {
      said.push_back(static_cast<double>(glm::unpackHalf2x16(words[i]).x));
      covered.push_back(static_cast<double>(glm::unpackHalf2x16(words[i + 3]).y));
    }
    const auto counts = bench.floats(Resource::FragmentCount, 1);
    const auto importance = bench.words(Resource::Importance, 1);
    std::size_t empty = 0;
    for (int y = 0; y < size.y; ++y) {
      for (int x = 0; x < size.x; ++x) {
        const auto p = static_cast<std::size_t>(y * size.x + x);
        if (counts[p] == 0.0F) {
          ++empty;
          ASSERT_EQ(importance[p], 0U);
          continue;
        }
        const double expected =
            tile == 1 ? said[p] : outputBetween(said, covered, tiles, tile, {x, y});
        // A step of fixed point, and single precision.
        ASSERT_NEAR(importance[p], 65536.0 * expected, 1.5) << x << "," << y << " tile " << tile;
      }
    }
    EXPECT_GT(empty, 50U) << "some tiles are empty in part";
  }
}

TEST_F(Networks, ForgetTilesOfFramesOfAnotherRate) {
  const scene::Scene scene = unlit(tangle(240, 3));
  for (const OitSettings& way : ways(2.0)) {
    const OitSettings oit = random(way, 6);
    for (const int tile : {1, 2, 4}) {
      passes::RenderSettings settings = tiled(oit, tile);
      settings.lod.transparency = true;
      // Of 32 x 24 texels: the last ones lie beyond the middle of the last tile.
      Bench used(scene, settings, {64, 48}, machine());
      used.draw();  // at full rate
      used.renderer.setLevers({.resize = 2.0F});
      used.draw();
      Bench fresh(scene, settings, {64, 48}, machine());
      fresh.renderer.setLevers({.resize = 2.0F});
      fresh.draw();
      EXPECT_TRUE(fresh.renderer.plan().resized());
      const std::string what = describe(oit) + " tile " + std::to_string(tile);
      EXPECT_EQ(countUnlike(used.linear(), fresh.linear()), 0U) << what;
      if (!fresh.renderer.plan().mapsImportance()) continue;
      const auto importance = fresh.words(Resource::Importance, 1);
      EXPECT_EQ(used.words(Resource::Importance, 1), importance) << what;
    }
  }
}

}  // namespace
}  // namespace macula::test
