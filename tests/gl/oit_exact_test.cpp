// Exactness: what must hold to the bit, or to the storage's precision.
#include <gmock/gmock.h>

#include <algorithm>
#include <map>

#include "engine/scene/load.h"
#include "engine/scene/procedural/recipes.h"
#include "gl_fixture.h"
#include "shared/oit_constants.h"

namespace macula::test {
namespace {

constexpr glm::ivec2 kSmall{48, 40};

class LayersN : public GlTest, public testing::WithParamInterface<int> {};

void expectComposite(Bench& bench, int n) {
  const glm::vec3 expected = scene::layersComposite(n);
  const std::vector<float> rgb = bench.linear();
  for (std::size_t i = 0; i < rgb.size(); ++i) {
    ASSERT_NEAR(rgb[i], expected[static_cast<int>(i % 3)], 1e-3) << "value " << i;
  }
}

TEST_P(LayersN, SBufferIsExact) {
  const int n = GetParam();
  Bench bench(scene::makeLayers(n, 1), linearSettings("ab-sbuffer"), kSmall, device());
  const passes::FrameResult result = bench.draw();
  EXPECT_TRUE(result.exact);
  EXPECT_EQ(result.fragments->generated, static_cast<std::uint64_t>(n) * kSmall.x * kSmall.y);
  EXPECT_EQ(result.fragments->lost, 0U);
  expectComposite(bench, n);
}

TEST_P(LayersN, VariableIsExactWhereEverythingFits) {
  const int n = GetParam();
  // Importance is uneven: four times the layers give each pixel at least all of its own.
  Bench bench(scene::makeLayers(n, 1), linearSettings("kb-variable", 4.0 * n + 4.0), kSmall,
              device());
  const passes::FrameResult result = bench.draw();
  EXPECT_TRUE(result.exact);
  EXPECT_EQ(result.fragments->lost, 0U);
  expectComposite(bench, n);
}

INSTANTIATE_TEST_SUITE_P(Depths, LayersN,
                         testing::Values(1, 2, 7, 8, 9, 16, 17, 31, 32, 33, 64, 127, 128, 129));

TEST_F(GlTest, DeepPixelsAreCountedAndSortedBeyondEveryLocalArray) {
  constexpr int kDeep = 2300;  // more than 2,048, where 16-bit floats stop counting
  constexpr glm::ivec2 kTiny{6, 5};
  Bench bench(scene::makeLayers(kDeep, 1), linearSettings("ab-sbuffer"), kTiny, device());
  const passes::FrameResult result = bench.draw();
  EXPECT_EQ(result.fragments->generated, std::uint64_t{kDeep} * kTiny.x * kTiny.y);
  EXPECT_EQ(result.deepest, static_cast<std::uint32_t>(kDeep));
  EXPECT_TRUE(result.exact);
  expectComposite(bench, kDeep);
}

TEST_F(GlTest, PoolGrowsAndTheFrameIsDrawnAgain) {
  Bench bench(scene::makeLayers(32, 1), linearSettings("ab-sbuffer"), kSmall, device());
  EXPECT_EQ(bench.draw().recaptures, 1);
  const passes::FrameResult second = bench.draw();
  EXPECT_EQ(second.recaptures, 0);
  EXPECT_TRUE(second.exact);
}

struct OrderCase {
  const char* method;
  const char* sync;
  double kAve;
};

class DrawOrder : public GlTest, public testing::WithParamInterface<OrderCase> {};

TEST_P(DrawOrder, ReversingDrawsAndTrianglesChangesNoBit) {
  const scene::Scene scene = tangle(300, 7);
  passes::RenderSettings settings = linearSettings(GetParam().method, GetParam().kAve);
  settings.oit.sync = GetParam().sync;
  Bench forward(scene, settings, {96, 96}, device());
  Bench backward(scene, settings, {96, 96}, device(), {.reversed = true});
  // Three frames, so that history takes part.
  for (int i = 0; i < 3; ++i) {
    const passes::FrameResult a = forward.draw();
    const passes::FrameResult b = backward.draw();
    EXPECT_EQ(a.fragments->generated, b.fragments->generated);
    EXPECT_EQ(a.fragments->stored, b.fragments->stored);
    EXPECT_GT(a.fragments->generated, 10000U) << "the scene covers the frame";
    EXPECT_EQ(forward.linear(), backward.linear()) << "frame " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, DrawOrder,
                         testing::Values(OrderCase{"ab-sbuffer", "auto", 4},
                                         OrderCase{"ab-sbuffer", "spinlock", 4},
                                         OrderCase{"kb-variable", "auto", 1},
                                         OrderCase{"kb-variable", "spinlock", 1},
                                         OrderCase{"kb-variable", "spinlock", 6}));

TEST_F(GlTest, BlendDependsOnTheOrderSoTheFlipTestCanFail) {
  const scene::Scene scene = tangle(300, 7);
  Bench forward(scene, linearSettings("blend"), {96, 96}, device());
  Bench backward(scene, linearSettings("blend"), {96, 96}, device(), {.reversed = true});
  forward.draw();
  backward.draw();
  EXPECT_NE(forward.linear(), backward.linear());
}

TEST_F(GlTest, SpinlockAndOrderedGiveTheSameImage) {
  if (!device().ordered.passed) GTEST_SKIP() << "sync=ordered: " << device().ordered.reason;
  const scene::Scene scene = tangle(300, 3);
  passes::RenderSettings settings = linearSettings("kb-variable", 2.0);
  settings.oit.sync = "ordered";
  Bench ordered(scene, settings, {96, 96}, device());
  settings.oit.sync = "spinlock";
  Bench locked(scene, settings, {96, 96}, device());
  ordered.draw();
  const passes::FrameResult result = locked.draw();
  EXPECT_EQ(result.lockFailures, 0U);
  EXPECT_EQ(ordered.linear(), locked.linear());
}

TEST_F(GlTest, OpaqueDepthHidesEveryFragmentBehindIt) {
  scene::Scene scene = scene::makeLayers(16, 1);
  // An opaque quad half way between the layers (1 to 10 metres from the camera).
  scene::Primitive wall;
  wall.material = static_cast<std::int32_t>(scene.materials.size());
  scene::Material material;
  material.unlit = true;
  material.doubleSided = true;
  scene.materials.push_back(material);
  const scene::Camera& camera = scene.cameras.front();
  const glm::vec3 forward = glm::normalize(camera.target - camera.position);
  const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up));
  const glm::vec3 up = glm::cross(right, forward);
  constexpr float kWallDistance = 5.5F;
  for (const glm::vec2 c :
       {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(-1, 1), glm::vec2(1, 1)}) {
    wall.positions.push_back(camera.position + kWallDistance * forward +
                             60.0F * (c.x * right + c.y * up));
    wall.attributes.emplace_back();
  }
  wall.indices = {0, 1, 2, 2, 1, 3};
  scene.instances.push_back({static_cast<std::uint32_t>(scene.primitives.size()), glm::mat4(1)});
  scene.primitives.push_back(wall);
  for (const char* method : {"ab-sbuffer", "kb-variable"}) {
    Bench bench(scene, linearSettings(method, 64), kSmall, device());
    // Layers at 1, 1.6, 2.2, ... 10 m: layers 1 to 8 lie before 5.5 m.
    EXPECT_EQ(bench.draw().fragments->generated, 8ULL * kSmall.x * kSmall.y) << method;
  }
}

/// Fragments of a pixel by its fill (shaders/lib/insert_sorted.glsl) and its range.
std::uint32_t storedIn(std::uint32_t fill, std::uint32_t range) {
  return std::min(fill & ~RANGE_TAIL, range & ~RANGE_TAIL);
}

/// Sorted keys of each pixel of the exact method: the oracle of which fragments are nearest.
std::map<std::size_t, std::vector<std::pair<std::uint32_t, std::uint32_t>>> keysOf(Bench& bench) {
  const auto ranges = bench.words(passes::kFragmentRange, 2);
  const auto fill = bench.words(passes::kFragmentFill, 1);
  const auto keys = bench.bufferWords(passes::kFragmentKeys);
  std::map<std::size_t, std::vector<std::pair<std::uint32_t, std::uint32_t>>> result;
  for (std::size_t p = 0; p < fill.size(); ++p) {
    for (std::size_t i = 0; i < storedIn(fill[p], ranges[2 * p + 1]); ++i) {
      const std::size_t slot = 2 * (ranges[2 * p] + i);
      result[p].emplace_back(keys[slot], keys[slot + 1]);
    }
    std::sort(result[p].begin(), result[p].end());
  }
  return result;
}

class Budget : public GlTest, public testing::WithParamInterface<double> {};

TEST_P(Budget, IsNeverExceededAndTheNearestAreKept) {
  const scene::Scene scene = tangle(400, 11);
  constexpr glm::ivec2 kSize{80, 60};
  Bench exact(scene, linearSettings("ab-sbuffer"), kSize, device());
  Bench variable(scene, linearSettings("kb-variable", GetParam()), kSize, device());
  for (int i = 0; i < 2; ++i) {
    exact.draw();
    const passes::FrameResult result = variable.draw();
    const auto ranges = variable.words(passes::kFragmentRange, 2);
    const auto fill = variable.words(passes::kFragmentFill, 1);
    const auto counts = variable.floats(passes::kFragmentCount, 1);
    const std::uint64_t slots = variable.renderer.plan().slots;
    EXPECT_LE(variable.renderer.bytes().oit, *variable.renderer.plan().budgetBytes);
    std::vector<bool> taken(slots, false);
    std::uint64_t sum = 0;
    std::uint64_t stored = 0;
    std::uint64_t covered = 0;
    std::uint64_t starved = 0;
    for (std::size_t p = 0; p < fill.size(); ++p) {
      const std::uint32_t k = ranges[2 * p + 1];
      const auto n = static_cast<std::uint32_t>(counts[p]);
      if (n == 0) {
        EXPECT_EQ(k, 0U) << "an empty pixel gets nothing";
        continue;
      }
      ++covered;
      if (k == 0) ++starved;
      ASSERT_LE(ranges[2 * p] + k, slots);
      for (std::uint32_t s = 0; s < k; ++s) {
        EXPECT_FALSE(taken[ranges[2 * p] + s]) << "ranges overlap";
        taken[ranges[2 * p] + s] = true;
      }
      EXPECT_EQ(storedIn(fill[p], k), std::min(n, k));
      sum += k;
      stored += storedIn(fill[p], k);
    }
    EXPECT_LE(sum, slots);
    EXPECT_EQ(result.fragments->stored, stored);
    EXPECT_EQ(result.fragments->generated - stored, result.fragments->lost);
    if (slots >= covered) {
      EXPECT_EQ(starved, 0U) << "every covered pixel keeps a layer";
    } else {
      EXPECT_GT(sum, slots * 8 / 10) << "a scarce budget is still used";
    }
    const auto all = keysOf(exact);
    for (const auto& [p, kept] : keysOf(variable)) {
      const auto& every = all.at(p);
      ASSERT_LE(kept.size(), every.size());
      EXPECT_TRUE(std::equal(kept.begin(), kept.end(), every.begin())) << "pixel " << p;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Averages, Budget, testing::Values(0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0));

TEST_F(GlTest, BudgetInBytesIsMet) {
  passes::RenderSettings settings = linearSettings("kb-variable");
  settings.oit.memoryMiB = 0.1;
  Bench bench(tangle(200, 5), settings, {64, 64}, device());
  bench.draw();
  EXPECT_EQ(*bench.renderer.plan().budgetBytes, 104857U);
  EXPECT_EQ(bench.renderer.bytes().oit, 104857U / 16 * 16);
}

}  // namespace
}  // namespace macula::test
