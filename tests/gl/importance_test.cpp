// The importance map against its CPU mirror, which is first checked by hand.
#include "importance_mirror.h"

#include <cmath>

#include "gl_fixture.h"

namespace macula::test {
namespace {

TEST(ImportanceMirror, AgreesWithACaseByHand) {
  // 300x400 pixels: the diagonal is 500. A pixel 55 from the gaze: 2 * 55 / 550 = 0.2, cubed
  // 0.008, so I_per = 0.992. 5 of 10 layers with alpha 0.35: 0.35 + 0.65 / 2 = 0.675.
  const double value = importanceOf({155.0, 200.0}, {100.0, 200.0}, {300.0, 400.0}, 5.0, {});
  EXPECT_NEAR(value, 0.992 * 0.675, 1e-12);
  // Beyond 0.55 of the diagonal the unclamped factor is negative.
  EXPECT_EQ(importanceOf({300.0, 400.0}, {0.0, 0.0}, {300.0, 400.0}, 5.0, {}), 0.0);
}

TEST(ImportanceMirror, SharesTheBudgetAsByHand) {
  // Importance 6, 3, 1 and an empty pixel; M = 10, C = 3. Shares of M - C = 7: 4.2, 2.1, 0.7, so
  // one pixel starves and Z = 1. Shares of 9: 5.4, 2.7, 0.9 -> 5, 2, and 1 for the starved one.
  EXPECT_EQ(layersOf({6, 3, 1, 0}, {4, 4, 4, 0}, 10), (std::vector<std::uint32_t>{5, 2, 1, 0}));
}

passes::RenderSettings mirrored(double kAve) {
  passes::RenderSettings settings = linearSettings("kb-variable", kAve);
  settings.importance.noise = 0.0;
  settings.importance.layerLimit = 10.0;
  return settings;
}

TEST_F(GlTest, ImportanceAndLayersEqualTheMirror) {
  constexpr glm::ivec2 kSize{75, 50};  // no multiple of a strip
  for (const glm::vec2 gaze : {glm::vec2(0.5F), glm::vec2(0.0F, 1.0F), glm::vec2(0.8F, 0.1F)}) {
    for (const double kAve : {2.0, 5.0}) {
      Bench bench(tangle(400, 2), mirrored(kAve), kSize, device());
      bench.draw(gaze);
      const auto importance = bench.words(passes::kImportance, 1);
      const auto ranges = bench.words(passes::kFragmentRange, 2);
      const auto counts = bench.floats(passes::kFragmentCount, 1);
      std::vector<std::uint32_t> integerCounts(counts.begin(), counts.end());
      // The mirror of k takes the GPU's importance, so that it must agree to the bit.
      const auto layers = layersOf(importance, integerCounts, bench.renderer.plan().slots);
      for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x) {
          const auto p = static_cast<std::size_t>(y * kSize.x + x);
          const double expected =
              counts[p] == 0.0F ? 0.0
                                : importanceOf({x + 0.5, y + 0.5},
                                               {gaze.x * static_cast<float>(kSize.x),
                                                (1.0F - gaze.y) * static_cast<float>(kSize.y)},
                                               glm::dvec2(kSize), counts[p], {});
          // Two steps of fixed point: single precision in pow and length.
          EXPECT_NEAR(importance[p], expected * 65536.0, 2.0) << x << "," << y;
          EXPECT_EQ(ranges[2 * p + 1], layers[p]) << x << "," << y;
        }
      }
    }
  }
}

TEST_F(GlTest, AnUncertainGazeWidensWhatCountsAsLookedAt) {
  constexpr glm::ivec2 kSize{60, 40};
  Bench bench(tangle(400, 2), mirrored(3.0), kSize, device());
  gaze::PointOfInterest point = gaze::exactPoint({0.25, 0.5});
  point.radius = gaze::kFoveaRadius + 0.2F;  // 8 pixels more
  bench.renderer.render(bench.camera, point);
  const auto importance = bench.words(passes::kImportance, 1);
  const auto counts = bench.floats(passes::kFragmentCount, 1);
  MirrorSettings widened;
  widened.widened = 8.0;
  for (int y = 0; y < kSize.y; ++y) {
    for (int x = 0; x < kSize.x; ++x) {
      const auto p = static_cast<std::size_t>(y * kSize.x + x);
      if (counts[p] == 0.0F) continue;
      const double expected =
          importanceOf({x + 0.5, y + 0.5}, {15.0, 20.0}, glm::dvec2(kSize), counts[p], widened);
      EXPECT_NEAR(importance[p], expected * 65536.0, 2.0) << x << "," << y;
    }
  }
}

TEST_F(GlTest, LayersFollowTheGaze) {
  Bench bench(tangle(900, 4), mirrored(6.0), {96, 96}, device());
  const auto meanNear = [&](glm::vec2 gaze, int centerX) {
    bench.draw(gaze);
    const auto ranges = bench.words(passes::kFragmentRange, 2);
    double sum = 0.0;
    for (int y = 38; y < 58; ++y) {
      for (int x = centerX - 10; x < centerX + 10; ++x) {
        sum += ranges[2 * static_cast<std::size_t>(y * 96 + x) + 1];
      }
    }
    return sum;
  };
  EXPECT_GT(meanNear({0.2F, 0.5F}, 20), 1.1 * meanNear({0.9F, 0.5F}, 20));
}

class History : public GlTest {};

TEST_F(History, IsInvalidOnTheFirstFrameAfterAResizeAndAfterACut) {
  const scene::Scene scene = tangle(300, 9);
  const auto importanceOfFrame = [](Bench& bench, bool cut) {
    bench.draw(glm::vec2(0.5F), cut);
    return bench.words(passes::kImportance, 1);
  };
  Bench bench(scene, mirrored(2.0), {64, 64}, device());
  const auto first = importanceOfFrame(bench, false);
  const auto second = importanceOfFrame(bench, false);
  EXPECT_NE(first, second) << "the second frame sees the first one's normals";
  EXPECT_EQ(importanceOfFrame(bench, false), second) << "a still frame repeats";
  EXPECT_EQ(importanceOfFrame(bench, true), first) << "a flagged cut forgets";
  importanceOfFrame(bench, false);
  bench.camera.position.x += 0.5F * bench.gpu.bounds().radius();
  bench.camera.target.x += 0.5F * bench.gpu.bounds().radius();
  Bench moved(scene, mirrored(2.0), {64, 64}, device());
  moved.camera = bench.camera;
  EXPECT_EQ(importanceOfFrame(bench, false), importanceOfFrame(moved, false))
      << "a jump of the camera forgets";
  bench.renderer.resize({64, 64});
  moved.renderer.resize({64, 64});
  EXPECT_EQ(importanceOfFrame(bench, false), importanceOfFrame(moved, false));
}

TEST_F(History, FrontNormalIsThatOfTheNearestFragment) {
  Bench bench(tangle(300, 9), mirrored(4.0), {64, 64}, device());
  bench.draw();
  const auto normals = bench.floats(passes::kFrontNormal, 4);
  const auto counts = bench.floats(passes::kFragmentCount, 1);
  for (std::size_t p = 0; p < counts.size(); ++p) {
    EXPECT_EQ(normals[4 * p + 3] > 0.0F, counts[p] > 0.0F) << "pixel " << p;
    if (counts[p] == 0.0F) continue;
    const double length = std::hypot(normals[4 * p], normals[4 * p + 1], normals[4 * p + 2]);
    EXPECT_NEAR(length, 1.0, 0.02) << "8 bits a component";
  }
}

}  // namespace
}  // namespace macula::test
