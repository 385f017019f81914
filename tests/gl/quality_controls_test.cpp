// What a controller may change from frame to frame: nothing is allocated, history stays.
#include <gmock/gmock.h>

#include <cmath>

#include "allocation_count.h"
#include "gl_fixture.h"
#include "lod_scenes.h"

namespace macula::test {
namespace {

constexpr glm::ivec2 kSize{150, 101};  // no multiple of tiles or groups

TEST_F(GlTest, ChangingControlsAllocatesNothing) {
  for (const bool foveated : {false, true}) {
    passes::RenderSettings settings = resized(1.5);
    settings.foveation.enabled = foveated;
    Bench bench(tangle(60, 3), settings, {96, 64}, device());
    // The driver compiles what it has not run yet: full rate and less.
    for (const float r : {1.0F, 2.0F, 1.0F}) {
      bench.renderer.setControls({.resize = r});
      (void)bench.draw();
    }
    const frame::ResourceBytes bytes = bench.renderer.bytes();
    const std::size_t before = allocationCount();
    for (int i = 0; i < 24; ++i) {
      bench.renderer.setControls({.resize = 1.0F + 0.29F * static_cast<float>(i),
                                  .foveaSlope = 1.0F + 0.1F * static_cast<float>(i)});
      (void)bench.draw({0.04F * static_cast<float>(i), 0.5F});
      EXPECT_TRUE(i == 0 || bench.renderer.inputs().historyValid);
    }
    EXPECT_EQ(allocationCount() - before, 0U);
    EXPECT_EQ(bench.renderer.bytes().other, bytes.other);
    EXPECT_EQ(bench.renderer.bytes().gbuffer, bytes.gbuffer);
  }
}

TEST_F(GlTest, LessIsShadedAtHigherFactors) {
  Bench bench(still(), resized(1.0), {128, 128}, device());
  std::uint64_t last = 0;
  for (const float r : {8.0F, 4.0F, 2.0F, 1.5F, 1.0F}) {
    bench.renderer.setControls({.resize = r});
    const passes::FrameResult result = bench.draw();
    EXPECT_EQ(result.resizeFactor, static_cast<double>(r));
    EXPECT_EQ(result.shading.shaded - result.shading.holes,
              static_cast<std::uint64_t>(std::pow(std::ceil(128.0F / r), 2.0F)));
    EXPECT_GT(result.shading.shaded, last);
    last = result.shading.shaded;
  }
}

TEST_F(GlTest, TheLayersControlUsesLessOfTheSameMemory) {
  for (const char* method : {"kb-variable", "kb-plus", "kb-fixed", "kb-atomic"}) {
    passes::RenderSettings settings = linearSettings(method, 4.0);
    Bench bench(tangle(200, 5), settings, {96, 64}, device());
    (void)bench.draw();  // what depends on the frame before is settled with the second
    const passes::FrameResult full = bench.draw();
    const std::uint64_t bytes = bench.renderer.bytes().oit;
    bench.renderer.setControls({.layerShare = 0.25F});
    const passes::FrameResult less = bench.draw();
    EXPECT_EQ(bench.renderer.bytes().oit, bytes) << method;
    EXPECT_EQ(less.fragments->generated, full.fragments->generated) << method;
    EXPECT_LT(less.fragments->stored, full.fragments->stored) << method;
    EXPECT_LE(less.fragments->stored, 96U * 64U) << method << ": a quarter of four layers";
    bench.renderer.setControls({});
    EXPECT_EQ(bench.draw().fragments->stored, full.fragments->stored) << method << ": released";
  }
}

TEST_F(GlTest, TheFoveaControlShadesLess) {
  passes::RenderSettings settings = resized(1.0);
  settings.foveation.enabled = true;
  settings.foveation.pixelsPerDegree = 20.0;
  Bench bench(still(), settings, {300, 200}, device());
  const std::uint64_t rest = bench.draw().shading.shaded;
  bench.renderer.setControls({.foveaSlope = 3.0F});
  EXPECT_LT(bench.draw().shading.shaded, rest * 8 / 10);
  bench.renderer.setControls({});
  EXPECT_EQ(bench.draw().shading.shaded, rest);
}

TEST_F(GlTest, ControlsResizeTransparencyUnderFoveation) {
  passes::RenderSettings settings = resized(1.0);
  settings.foveation.enabled = true;
  settings.lod.transparency = true;
  Bench bench(tangle(60, 3), settings, {96, 64}, device());
  (void)bench.draw();
  EXPECT_FALSE(bench.renderer.plan().reduced());
  bench.renderer.setControls({.resize = 2.0F});
  (void)bench.draw();
  EXPECT_TRUE(bench.renderer.plan().reduced());
}

TEST_F(GlTest, TheLayersControlLeavesATailItsPlace) {
  passes::RenderSettings settings = linearSettings("kb-fixed", 4.0);
  settings.oit.tail = passes::Tail::Mean;
  settings.oit.fragmentBytes = 8;
  Bench bench(tangle(200, 5), settings, {96, 64}, device());
  (void)bench.draw();
  bench.renderer.setControls({.layerShare = 0.25F});
  const passes::FrameResult result = bench.draw();
  EXPECT_EQ(bench.renderer.plan().layers, 2U) << "what a packed tail takes";
  EXPECT_EQ(result.fragments->lost, 0U);
}

}  // namespace
}  // namespace macula::test
