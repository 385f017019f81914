// Occupancy culling (Vasilakis 2015): the k nearest always pass, and what is culled was lost
// anyway.
#include <gtest/gtest.h>

#include "engine/scene/load.h"
#include "gl_fixture.h"

namespace macula::test {
namespace {

struct CullCase {
  const char* method;
  double kAve;
  int words;
};

class Culling : public GlTest, public testing::WithParamInterface<CullCase> {};

TEST_P(Culling, KeepsTheNearestOfLemma21) {
  const scene::Scene scene = tangle(600, 21);
  constexpr glm::ivec2 kSize{72, 60};
  passes::RenderSettings settings = linearSettings(GetParam().method, GetParam().kAve);
  const bool sorted = passes::methodById(GetParam().method).sorts();
  for (const char* sync : {"auto", "spinlock"}) {
    if (!sorted && std::string_view(sync) != "auto") continue;
    settings.oit.sync = sync;
    settings.oit.cull = passes::Cull::None;
    Bench plain(scene, settings, kSize, device());
    settings.oit.cull = passes::Cull::Occupancy;
    settings.oit.cullWords = GetParam().words;
    Bench culled(scene, settings, kSize, device());
    for (int i = 0; i < 3; ++i) {  // the map is left empty for the next frame
      const passes::FrameResult a = plain.draw();
      const passes::FrameResult b = culled.draw();
      EXPECT_EQ(plain.linear(), culled.linear()) << "frame " << i << ", sync " << sync;
      EXPECT_EQ(a.fragments->stored, b.fragments->stored);
      EXPECT_EQ(a.fragments->generated, b.fragments->generated);
      RecordProperty("fragments", static_cast<int>(a.fragments->generated));
      RecordProperty("lost", static_cast<int>(a.fragments->lost));
      EXPECT_GT(a.fragments->lost, 0U) << "there is something to cull";
    }
    // Reversed depth: culling can only bring the bound nearer.
    const auto bound = culled.depths(passes::kCullDepth);
    const auto opaque = culled.depths(passes::kDepth);
    std::size_t nearer = 0;
    for (std::size_t p = 0; p < bound.size(); ++p) {
      ASSERT_GE(bound[p], opaque[p]);
      if (bound[p] > opaque[p]) ++nearer;
    }
    EXPECT_GT(nearer, bound.size() / 4) << "most crowded pixels are culled";
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Culling,
                         testing::Values(CullCase{"kb-fixed", 1, 32}, CullCase{"kb-fixed", 4, 1},
                                         CullCase{"kb-fixed", 3, 64}, CullCase{"kb-atomic", 2, 8},
                                         CullCase{"kb-plus", 2, 32}, CullCase{"kb-plus", 4, 2},
                                         CullCase{"kb-variable", 3, 32},
                                         CullCase{"kb-variable", 2, 5}));

TEST_F(GlTest, CullingKeepsCoplanarLayers) {
  // All fragments of a pixel in one interval: nothing can be told apart, so nothing may go.
  scene::Scene scene = scene::loadScene("layers-8", 1);
  passes::RenderSettings settings = linearSettings("kb-fixed", 3);
  for (auto& primitive : scene.primitives) {
    for (auto& position : primitive.positions) {
      const glm::vec3& eye = scene.cameras.front().position;
      const glm::vec3 forward = glm::normalize(scene.cameras.front().target - eye);
      position += forward * (5.0F - glm::dot(position - eye, forward));
    }
  }
  Bench plain(scene, settings, {32, 24}, device());
  settings.oit.cull = passes::Cull::Occupancy;
  Bench culled(scene, settings, {32, 24}, device());
  plain.draw();
  culled.draw();
  EXPECT_EQ(plain.linear(), culled.linear());
}

passes::RenderSettings predicted(double kAve) {
  passes::RenderSettings settings = linearSettings("kb-variable", kAve);
  settings.oit.fill = true;
  settings.oit.tail = passes::Tail::Mean;
  settings.oit.count = passes::CountSource::Predicted;
  return settings;
}

TEST_F(GlTest, PredictedCountsOfAStillViewAreThoseOfTheLastFrame) {
  Bench bench(tangle(300, 5), predicted(3.0), {64, 48}, device());
  bench.draw();
  const auto counted = bench.floats(passes::kFragmentCount, 1);
  const passes::FrameResult second = bench.draw();
  const auto expected = bench.floats(passes::kPredictedCount, 1);
  for (std::size_t p = 0; p < counted.size(); ++p) {
    // Beside a covered pixel at least one is expected.
    if (counted[p] > 0.0F) {
      ASSERT_EQ(expected[p], counted[p]);
    } else {
      ASSERT_LE(expected[p], 1.0F);
    }
  }
  EXPECT_EQ(second.fragments->lost, 0U);
}

TEST_F(GlTest, StillViewsWithTailsRepeat) {
  passes::RenderSettings settings = predicted(1.5);
  for (const auto count : {passes::CountSource::Drawn, passes::CountSource::Predicted}) {
    settings.oit.count = count;
    Bench bench(tangle(300, 6), settings, {64, 48}, device());
    // A pixel whose only slot is its tail's learns its front's normal when it first gets another.
    constexpr int kSettling = 30;
    for (int i = 0; i < kSettling; ++i) bench.draw();
    const auto still = bench.linear();
    for (int i = 0; i < 3; ++i) {
      bench.draw();
      EXPECT_EQ(bench.linear(), still) << "frame " << i + kSettling;
    }
  }
}

TEST_F(GlTest, PredictedCountsLoseNothingAtACutAndLittleInMotion) {
  Bench bench(tangle(300, 5), predicted(3.0), {64, 48}, device());
  bench.draw();
  bench.draw();
  const scene::Camera start = bench.camera;
  const auto shift = [&](float metres) {
    bench.camera.position.x = start.position.x + metres;
    bench.camera.target.x = start.target.x + metres;
  };
  shift(0.5F);
  const passes::FrameResult cut = bench.draw(glm::vec2(0.5F), true);
  EXPECT_EQ(cut.fragments->lost, 0U) << "a cut counts its own fragments";
  std::uint64_t lost = 0;
  std::uint64_t generated = 0;
  for (int i = 0; i < 10; ++i) {
    shift(0.5F + 0.02F * static_cast<float>(i));
    const passes::FrameResult moving = bench.draw();
    lost += moving.fragments->lost;
    generated += moving.fragments->generated;
    EXPECT_LE(bench.renderer.bytes().oit, *bench.renderer.plan().budgetBytes);
    EXPECT_EQ(moving.fragments->generated,
              moving.fragments->stored + moving.fragments->merged + moving.fragments->lost);
  }
  RecordProperty("lost", static_cast<int>(lost));
  RecordProperty("generated", static_cast<int>(generated));
  EXPECT_LT(lost, generated / 50) << "of " << generated;
}

}  // namespace
}  // namespace macula::test
