// The fragments that are read back are those that the frame shows.
#include "passes/oit/statistics/read_fragments.h"

#include <stdexcept>

#include "engine/measure/oracle.h"
#include "engine/scene/procedural/recipes.h"
#include "gl_fixture.h"

namespace macula::test {
namespace {

/// Half-floats hold 11 bits: a step near 1 is 1e-3, and the image itself is stored so.
constexpr float kHalfStep = 2e-3F;

/// One scene, drawn with all fragments and without any.
struct Pair {
  Pair(const scene::Scene& scene, glm::ivec2 size, passes::DeviceContext& device,
       const passes::RenderSettings& settings = linearSettings("ab-sbuffer"))
      : exact(scene, settings, size, device), opaque(scene, settings, size, device) {
    opaque.renderer.showTransparency(false);
    result = exact.draw();
    opaqueResult = opaque.draw();
  }
  [[nodiscard]] measure::FragmentImage read() const {
    return passes::readFragments(exact.renderer, opaque.renderer);
  }
  Bench exact;
  Bench opaque;
  passes::FrameResult result;
  passes::FrameResult opaqueResult;
};

void expectShown(const measure::FragmentImage& image, const std::vector<float>& shown,
                 measure::Tail tail) {
  ASSERT_EQ(shown.size(), 3 * image.pixels());
  for (std::size_t p = 0; p < image.pixels(); ++p) {
    const glm::vec3 all = measure::composite(image, p, image.depth(p), tail);
    for (int c = 0; c < 3; ++c) {
      ASSERT_NEAR(shown[3 * p + static_cast<std::size_t>(c)], all[c], kHalfStep)
          << "pixel " << p << " channel " << c;
    }
  }
}

TEST_F(GlTest, AllFragmentsReadBackMakeTheFrame) {
  const Pair pair(tangle(300, 7), {96, 80}, device());
  const measure::FragmentImage image = pair.read();
  ASSERT_NO_THROW(measure::requireConsistent(image));
  EXPECT_EQ(image.width, 96);
  EXPECT_EQ(image.height, 80);
  EXPECT_EQ(image.fragments.size(), pair.result.fragments->generated);
  EXPECT_GT(image.fragments.size(), 10000U) << "the scene covers the frame";
  expectShown(image, pair.exact.linear(), measure::Tail::None);
  expectShown(image, pair.exact.linear(), measure::Tail::Mean);
}

TEST_F(GlTest, WhatIsBehindIsTheFrameWithoutTransparency) {
  const Pair pair(tangle(300, 7), {96, 80}, device());
  EXPECT_EQ(pair.opaqueResult.fragments->generated, 0U);
  const measure::FragmentImage image = pair.read();
  const std::vector<float> shown = pair.opaque.linear();
  bool lit = false;
  for (std::size_t p = 0; p < image.pixels(); ++p) {
    ASSERT_EQ(image.behind[p], glm::vec3(shown[3 * p], shown[3 * p + 1], shown[3 * p + 2]));
    lit = lit || image.behind[p].g > 0.0F;
  }
  EXPECT_TRUE(lit) << "the opaque wall is in view";
  EXPECT_NE(shown, pair.exact.linear());
}

TEST_F(GlTest, FragmentsOfDeepPixelsAreSortedToo) {
  constexpr int kLayers = 100;  // more than the resolve's local arrays
  const Pair pair(scene::makeLayers(kLayers, 1), {16, 12}, device());
  const measure::FragmentImage image = pair.read();
  EXPECT_EQ(image.depth(0), static_cast<std::uint32_t>(kLayers));
  // Layer i from the front has alpha 1 / (N - i + 1).
  for (int i = 0; i < kLayers; ++i) {
    EXPECT_NEAR(image.layers(5)[static_cast<std::size_t>(i)].a, 1.0 / (kLayers - i), kHalfStep);
  }
  expectShown(image, pair.exact.linear(), measure::Tail::None);
}

TEST_F(GlTest, SamplesOfSupersampledFramesAreReadOneByOne) {
  passes::RenderSettings settings = linearSettings("ab-sbuffer");
  settings.tonemap.ssaa = 2;
  const Pair pair(tangle(100, 3), {32, 24}, device(), settings);
  const measure::FragmentImage image = pair.read();
  EXPECT_EQ(image.pixels(), 4U * 32U * 24U);
  EXPECT_EQ(image.fragments.size(), pair.result.fragments->generated);
}

TEST_F(GlTest, OtherFramesAreRefused) {
  const scene::Scene scene = tangle(50, 1);
  Bench variable(scene, linearSettings("kb-variable"), {32, 32}, device());
  Bench opaque(scene, linearSettings("ab-sbuffer"), {32, 32}, device());
  opaque.renderer.showTransparency(false);
  variable.draw();
  opaque.draw();
  EXPECT_THROW((void)passes::readFragments(variable.renderer, opaque.renderer),
               std::invalid_argument);
  const measure::FragmentImage nothing = passes::readFragments(opaque.renderer, opaque.renderer);
  EXPECT_TRUE(nothing.fragments.empty());
  EXPECT_EQ(nothing.pixels(), 32U * 32U);
}

TEST_F(GlTest, TransparencyCanBeShownAgain) {
  Bench bench(tangle(50, 1), linearSettings("ab-sbuffer"), {32, 32}, device());
  bench.draw();
  const std::vector<float> before = bench.linear();
  bench.renderer.showTransparency(false);
  bench.draw();
  EXPECT_NE(bench.linear(), before);
  bench.renderer.showTransparency(true);
  bench.draw();
  EXPECT_EQ(bench.linear(), before);
}

}  // namespace
}  // namespace macula::test
