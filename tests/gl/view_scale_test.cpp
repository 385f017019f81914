// What is drawn follows what is in view and not the unit of length: scales, lights, heat maps.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "allocation_count.h"
#include "engine/scene/camera_path.h"
#include "engine/scene/material_override.h"
#include "gl_fixture.h"
#include "shared/scene_data.h"

namespace macula::test {
namespace {

/// The tangle, so many times as large.
scene::Scene tangleOf(float scale, scene::LightingOverride lighting) {
  scene::Scene scene = tangle(60, 4);
  scene.cameras.clear();
  for (scene::Primitive& primitive : scene.primitives) {
    for (glm::vec3& p : primitive.positions) p *= scale;
  }
  scene::overrideLighting(scene, lighting);
  return scene;
}

std::vector<float> orbitOf(const scene::Scene& scene, passes::DeviceContext& device) {
  scene::Scene seen = scene;
  seen.cameras = {scene::autoOrbit(scene).at(2.0)};
  Bench bench(seen, linearSettings("ab-sbuffer"), {64, 64}, device);
  bench.draw();
  return bench.linear();
}

TEST_F(GlTest, OrbitsShowAModelOfAnyScaleAlike) {
  for (const auto lighting : {scene::LightingOverride::Own, scene::LightingOverride::Four}) {
    // Powers of two: the same numbers, but for their exponents.
    const std::vector<float> metre = orbitOf(tangleOf(1.0F, lighting), device());
    EXPECT_GT(std::count_if(metre.begin(), metre.end(), [](float v) { return v > 0.0F; }), 2000);
    for (const int power : {-14, -7, 10, 17}) {
      const std::vector<float> other =
          orbitOf(tangleOf(std::ldexp(1.0F, power), lighting), device());
      double sum = 0.0;
      for (std::size_t i = 0; i < metre.size(); ++i) {
        sum += std::pow(static_cast<double>(other[i]) - static_cast<double>(metre[i]), 2.0);
      }
      EXPECT_LT(std::sqrt(sum / static_cast<double>(metre.size())), 1e-3) << "2^" << power;
    }
  }
}

/// The tangle with lights that matter behind as many as a frame takes that do not.
scene::Scene manyLights(int dark) {
  scene::Scene scene = tangle(60, 4);
  scene::Light lamp;
  lamp.type = scene::LightType::Point;
  scene.lights.clear();
  lamp.intensity = 0.0F;
  scene.lights.assign(static_cast<std::size_t>(dark), lamp);
  lamp.intensity = 3.0F;
  for (int i = 0; i < 4; ++i) {
    lamp.position = {2.0F * static_cast<float>(i) - 3.0F, 1.0F, -3.0F};
    scene.lights.push_back(lamp);
  }
  scene::Light sun;
  sun.castsShadow = true;
  scene.lights.push_back(sun);
  return scene;
}

TEST_F(GlTest, LightsBeyondTheLimitAreChosenByWhatTheyAdd) {
  Bench few(manyLights(0), linearSettings("ab-sbuffer"), {48, 48}, device());
  Bench many(manyLights(MAX_LIGHTS), linearSettings("ab-sbuffer"), {48, 48}, device());
  few.draw();
  many.draw();
  const std::vector<float> wanted = few.linear();
  EXPECT_GT(*std::max_element(wanted.begin(), wanted.end()), 0.1F);
  const std::vector<float> got = many.linear();
  for (std::size_t i = 0; i < got.size(); ++i) ASSERT_NEAR(got[i], wanted[i], 1e-3F) << i;
}

TEST_F(GlTest, ChoosingLightsAllocatesNothing) {
  scene::Scene scene = manyLights(0);
  const scene::Light lamp = scene.lights.front();
  for (int i = 0; i < 60; ++i) {
    scene.lights.push_back(lamp);
    scene.lights.back().position = {0.2F * static_cast<float>(i) - 6.0F, 1.5F, -4.0F};
    scene.lights.back().range = 1.0F;
  }
  Bench bench(scene, linearSettings("kb-variable"), {48, 48}, device());
  for (int i = 0; i < 3; ++i) bench.draw();
  const std::size_t before = allocationCount();
  for (int i = 0; i < 5; ++i) {
    bench.camera.position.x += 0.05F;
    bench.camera.target.x += 0.05F;
    bench.draw();
  }
  EXPECT_EQ(allocationCount() - before, 0U);
}

TEST_F(GlTest, AHeatMapLeavesTheImageAsItIs) {
  const scene::Scene scene = tangle(60, 4);
  passes::RenderSettings settings = linearSettings("kb-variable", 2.0);
  Bench plain(scene, settings, {48, 48}, device());
  plain.draw();
  EXPECT_FALSE(plain.renderer.legend());
  EXPECT_EQ(plain.shown(), plain.display());
  for (const std::string& map : passes::heatmapNames()) {
    if (map == "none") continue;
    settings.heatmap.map = map;
    settings.foveation.enabled = map == "shading-rate";
    Bench mapped(scene, settings, {48, 48}, device());
    mapped.draw();
    if (map != "shading-rate") {
      EXPECT_EQ(mapped.display(), plain.display()) << map;
    }
    EXPECT_NE(mapped.shown(), mapped.display()) << map;
    ASSERT_TRUE(mapped.renderer.legend()) << map;
    EXPECT_FALSE(mapped.renderer.legend()->quantity.empty());
  }
}

TEST_F(GlTest, TheLegendHasTheRangeThatTheFrameWasDrawnWith) {
  const scene::Scene scene = tangle(200, 4);
  passes::RenderSettings settings = linearSettings("kb-variable", 4.0);
  settings.heatmap.map = "k";
  Bench bench(scene, settings, {48, 48}, device());
  EXPECT_EQ((bench.draw(), bench.renderer.legend()->maximum), 4.0) << "nothing was counted yet";
  const double most = bench.draw().layers->max;
  EXPECT_GT(most, 4.0);
  settings.heatmap.range = bench.renderer.legend()->maximum;
  Bench fixed(scene, settings, {48, 48}, device());
  fixed.draw();
  fixed.draw();
  EXPECT_EQ(bench.shown(), fixed.shown());
}

TEST_F(GlTest, NoSunMakesAPixelInfinite) {
  for (const float radiance : {3e5F, 1e12F}) {
    scene::Panorama p{64, 32, {}};
    p.pixels.assign(64 * 32, glm::vec3(0.1F));
    p.pixels[64 * 14 + 40] = glm::vec3(radiance);
    const scene::Environment environment = scene::makeEnvironment(std::move(p));
    scene::Scene scene = tangle(40, 3);
    scene.materials[0].roughness = 0.0F;
    const scene::GpuScene gpu(scene, &environment);
    for (const char* method : {"blend", "ab-sbuffer", "wboit"}) {
      passes::RenderSettings settings = linearSettings(method);
      settings.tonemap.curve = "neutral";
      passes::FrameRenderer renderer(settings, device());
      renderer.resize({48, 48});
      renderer.setScene(gpu);
      renderer.render(scene.cameras.front(), glm::vec2(0.5F));
      std::vector<float> rgb;
      renderer.readLinear(rgb);
      for (const float value : rgb) ASSERT_TRUE(std::isfinite(value)) << method << " " << radiance;
    }
  }
}

}  // namespace
}  // namespace macula::test
