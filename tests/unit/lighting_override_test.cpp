#include "engine/scene/material_override.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/scene/load.h"
#include "engine/scene/scene_facts.h"
#include "passes/render_settings.h"

namespace macula::scene {
namespace {

/// A cube of 2 m a side around (1, 2, 3): opaque lit, opaque unlit, blend unlit, transmission lit.
Scene mixed() {
  Scene scene;
  scene.materials.resize(4);
  scene.materials[1].unlit = true;
  scene.materials[2].alphaMode = AlphaMode::Blend;
  scene.materials[2].unlit = true;
  scene.materials[2].metallicRoughnessTexture.image = 0;
  scene.materials[3].transmission = 1.0F;
  scene.materials[3].roughness = 0.2F;
  for (std::int32_t m = 0; m < 4; ++m) {
    Primitive primitive;
    primitive.positions = {{0, 1, 2}, {2, 3, 4}, {0, 3, 2}};
    primitive.attributes.resize(3);
    primitive.indices = {0, 1, 2};
    primitive.material = m;
    scene.primitives.push_back(primitive);
    scene.instances.push_back({static_cast<std::uint32_t>(m), glm::mat4(1.0F)});
  }
  scene.lights.resize(2);
  scene.ambient = {0.5F, 0.5F, 0.5F};
  return scene;
}

TEST(LightingOverride, OwnChangesNothing) {
  Scene scene = mixed();
  overrideLighting(scene, LightingOverride::Own);
  EXPECT_TRUE(scene.materials[2].unlit);
  EXPECT_FALSE(scene.materials[3].unlit);
  EXPECT_EQ(scene.lights.size(), 2U);
}

TEST(LightingOverride, UnlitIsForTransparentMaterialsAlone) {
  Scene scene = mixed();
  overrideLighting(scene, LightingOverride::Unlit);
  EXPECT_FALSE(scene.materials[0].unlit);
  EXPECT_TRUE(scene.materials[1].unlit);
  EXPECT_TRUE(scene.materials[2].unlit);
  EXPECT_TRUE(scene.materials[3].unlit);
  EXPECT_EQ(scene.lights.size(), 2U);
  EXPECT_EQ(scene.ambient, glm::vec3(0.5F));
}

TEST(LightingOverride, FourLightsTransparentMaterials) {
  Scene scene = mixed();
  overrideLighting(scene, LightingOverride::Four);
  EXPECT_FALSE(scene.materials[0].unlit);
  EXPECT_TRUE(scene.materials[1].unlit) << "opaque ones stay";
  EXPECT_FALSE(scene.materials[2].unlit);
  EXPECT_EQ(scene.materials[2].metallic, 0.0F) << "paint, not glTF's default metal";
  EXPECT_EQ(scene.materials[2].metallicRoughnessTexture.image, kNone);
  EXPECT_EQ(scene.materials[3].roughness, 0.2F) << "what was lit keeps its surface";

  ASSERT_EQ(scene.lights.size(), 4U);
  const auto ofType = [&](LightType type) {
    return std::count_if(scene.lights.begin(), scene.lights.end(),
                         [type](const Light& light) { return light.type == type; });
  };
  EXPECT_EQ(ofType(LightType::Directional), 1);
  EXPECT_EQ(ofType(LightType::Point), 2);
  EXPECT_EQ(ofType(LightType::Spot), 1);
  EXPECT_TRUE(factsOf(scene, false).shadowLight);
  for (const Light& light : scene.lights) {
    EXPECT_NEAR(glm::length(light.direction), 1.0F, 1e-5F);
    EXPECT_EQ(light.castsShadow, light.type == LightType::Directional);
  }
  // The spot shines on the middle of the bounds.
  const Light& spot = scene.lights[3];
  EXPECT_NEAR(glm::dot(glm::normalize(glm::vec3(1, 2, 3) - spot.position), spot.direction), 1.0F,
              1e-5F);
}

TEST(LightingOverride, LampsGrowWithTheScene) {
  Scene small = mixed();
  Scene large = mixed();
  for (Instance& instance : large.instances) instance.transform = glm::mat4(10.0F);
  for (Instance& instance : large.instances) instance.transform[3] = {0, 0, 0, 1};
  overrideLighting(small, LightingOverride::Four);
  overrideLighting(large, LightingOverride::Four);
  EXPECT_EQ(small.lights[0].intensity, large.lights[0].intensity) << "a sun is a sun";
  for (std::size_t i = 1; i < 4; ++i) {
    // Illuminance at the middle: candela over distance squared.
    const auto lux = [i](const Scene& scene) {
      const glm::vec3 d = scene.lights[i].position - boundsOf(scene).center();
      return scene.lights[i].intensity / glm::dot(d, d);
    };
    EXPECT_NEAR(lux(small), lux(large), 1e-4F) << i;
  }
}

TEST(LightingOverride, MakesSmokeLitAndBottlesUnlit) {
  Scene smoke = loadScene("smoke", 1);
  EXPECT_FALSE(factsOf(smoke, false).litTransparent);
  overrideLighting(smoke, LightingOverride::Four);
  EXPECT_TRUE(factsOf(smoke, false).litTransparent);
  Scene bottles = loadScene("bottles", 1);
  overrideLighting(bottles, LightingOverride::Unlit);
  EXPECT_FALSE(factsOf(bottles, false).litTransparent);
  EXPECT_TRUE(factsOf(bottles, false).litOpaque);
}

TEST(LightingOverride, IsASetting) {
  passes::RenderSettings values;
  settings::Registry registry;
  passes::registerSettings(registry, values);
  registry.setText("scene.lighting", "unlit", "test");
  EXPECT_EQ(values.lighting, LightingOverride::Unlit);
  registry.setText("scene.lighting", "four", "test");
  EXPECT_EQ(values.lighting, LightingOverride::Four);
}

}  // namespace
}  // namespace macula::scene
