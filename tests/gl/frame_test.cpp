// The frame as a whole: allocation, sizes, tone map, self-tests.
#include <gmock/gmock.h>

#include "allocation_count.h"
#include "engine/core/error.h"
#include "engine/scene/load.h"
#include "engine/scene/procedural/recipes.h"
#include "gl_fixture.h"
#include "oit_cases.h"

namespace macula::test {
namespace {

TEST_F(GlTest, FrameLoopAllocatesNothingAfterWarmUp) {
  const scene::Scene scene = tangle(100, 1);
  std::vector<passes::OitSettings> all{
      {.method = "kb-plus", .fill = true, .tail = passes::Tail::Mean},
      {.method = "kb-variable", .fill = true, .importance = passes::Predictor::Error},
      learnedUtility(4.0)};
  for (const passes::Method& method : passes::methods()) {
    if (method.id == "kb-stencil" && device().capabilities.routableSamples.empty()) continue;
    all.push_back({.method = std::string(method.id)});
  }
  for (const passes::OitSettings& oit : all) {
    Bench bench(scene, settingsOf(oit), {64, 64}, device());
    for (int i = 0; i < 3; ++i) bench.draw();
    const std::size_t before = allocationCount();
    for (int i = 0; i < 5; ++i) bench.draw();
    EXPECT_EQ(allocationCount() - before, 0U) << describe(oit);
  }
}

TEST_F(GlTest, TwoRunsGiveTheSameBits) {
  const scene::Scene scene = tangle(300, 6);
  Bench a(scene, linearSettings("kb-variable", 1.0), {96, 64}, device());
  Bench b(scene, linearSettings("kb-variable", 1.0), {96, 64}, device());
  for (int i = 0; i < 3; ++i) {
    a.draw({0.3F, 0.4F});
    b.draw({0.3F, 0.4F});
    EXPECT_EQ(a.display(), b.display());
    EXPECT_EQ(a.linear(), b.linear());
  }
}

TEST_F(GlTest, BackgroundShowsWhereNothingIsDrawnAndRowsStartAtTheTop) {
  scene::Scene scene = scene::makeLayers(1, 1);
  // The quad moves up by its own extent: only the upper half of the picture stays covered.
  const scene::Camera camera = scene.cameras.front();
  float top = -1e9F;
  float bottom = 1e9F;
  for (const glm::vec3& p : scene.primitives.front().positions) {
    top = std::max(top, p.y);
    bottom = std::min(bottom, p.y);
  }
  scene.instances.front().transform[3][1] += camera.position.y - bottom;
  passes::RenderSettings settings = linearSettings("ab-sbuffer");
  settings.background = {0.25F, 0.5F, 0.75F};
  Bench bench(scene, settings, {16, 16}, device());
  bench.draw();
  const std::vector<float> rgb = bench.linear();
  const std::size_t lastRow = 3 * 16 * 15;
  EXPECT_NEAR(rgb[lastRow], 0.25F, 1e-3);
  EXPECT_NEAR(rgb[lastRow + 2], 0.75F, 1e-3);
  EXPECT_NEAR(rgb[0], scene::layersComposite(1).r, 1e-3);
}

TEST_F(GlTest, SupersamplingAveragesSamples) {
  const scene::Scene scene = tangle(60, 8);
  passes::RenderSettings settings = linearSettings("ab-sbuffer");
  Bench full(scene, settings, {64, 64}, device());
  settings.tonemap.ssaa = 2;
  Bench averaged(scene, settings, {32, 32}, device());
  full.draw();
  averaged.draw();
  const auto big = full.linear();
  const auto small = averaged.linear();
  for (std::size_t y = 0; y < 32; ++y) {
    for (std::size_t x = 0; x < 32 * 3; ++x) {
      const std::size_t column = x / 3 * 6 + x % 3;
      const float mean =
          0.25F * (big[2 * y * 192 + column] + big[2 * y * 192 + column + 3] +
                   big[(2 * y + 1) * 192 + column] + big[(2 * y + 1) * 192 + column + 3]);
      ASSERT_NEAR(small[y * 96 + x], mean, 1e-5F);
    }
  }
}

TEST_F(GlTest, AnEvenEnvironmentMakesWhiteSurfacesVanish) {
  // The furnace: under the same light from everywhere a white diffuse surface sends back what it
  // gets, whether it is opaque or transparent, and so looks like the background.
  scene::Panorama even{32, 16, {}};
  even.pixels.assign(32 * 16, glm::vec3(0.5F));
  const scene::Environment environment = scene::makeEnvironment(even);
  scene::Scene scene = tangle(40, 3);
  scene.lights.clear();
  for (scene::Material& material : scene.materials) {
    material.metallic = 0.0F;
    material.roughness = 1.0F;
  }
  for (scene::Primitive& primitive : scene.primitives) {
    for (scene::VertexAttributes& a : primitive.attributes) {
      a.color = glm::vec4(1.0F, 1.0F, 1.0F, a.color.a);
    }
  }
  const scene::GpuScene gpu(scene, &environment);
  const passes::RenderSettings settings = linearSettings("ab-sbuffer");
  passes::FrameRenderer renderer(settings, device());
  renderer.resize({48, 48});
  renderer.setScene(gpu);
  renderer.render(scene.cameras.front(), glm::vec2(0.5F));
  std::vector<float> rgb;
  renderer.readLinear(rgb);
  // The specular part is a fitted curve: some percent.
  for (const float value : rgb) EXPECT_NEAR(value, 0.5F, 0.03F);
}

TEST_F(GlTest, TimerAndRasteriserWereJudged) {
  EXPECT_FALSE(device().time.reason.empty());
  EXPECT_FALSE(device().ordered.reason.empty());
  if (device().capabilities.renderer.starts_with("llvmpipe")) {
    EXPECT_EQ(device().time.source, gl::TimeSource::Finish) << "its timer is known to be wrong";
    EXPECT_TRUE(device().ordered.passed);
  }
}

TEST_F(GlTest, WhatTheGpuCannotDoIsOneLine) {
  const scene::Scene scene = tangle(10, 1);
  passes::RenderSettings settings = linearSettings("kb-variable", 4096.0);
  Bench large(scene, settings, {4096, 4096}, device());
  EXPECT_THROW(large.draw(), InputError);
  settings.oit.kAve = 1.0;
  settings.oit.memoryMiB = 1e-6;
  Bench small(scene, settings, {64, 64}, device());
  EXPECT_THROW(small.draw(), InputError);
  settings.oit.memoryMiB = 0.0;
  settings.tonemap.ssaa = 4;
  EXPECT_THROW(Bench(scene, settings, {16384, 16384}, device()), InputError);
  if (!device().capabilities.fragmentShaderInterlock) {
    settings.tonemap.ssaa = 1;
    settings.oit.sync = "interlock";
    Bench locked(scene, settings, {64, 64}, device());
    EXPECT_THROW(locked.draw(), InputError);
  }
}

}  // namespace
}  // namespace macula::test
