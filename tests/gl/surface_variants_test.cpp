// What the programs of runs are specialised by, and what is left out of a view.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/scene/procedural/mesh_builder.h"
#include "oit_cases.h"

namespace macula::test {
namespace {

constexpr glm::ivec2 kSize{48, 40};

/// An opaque wall 2 m ahead, of cells x cells squares, with a fine checkerboard on the second set
/// of coordinates, while the first one stays at one place.
scene::Scene checkedWall(int cells) {
  scene::Scene scene = emptyScene();
  constexpr int kTexels = 64;
  scene::Image board{.name = "board", .width = kTexels, .height = kTexels, .rgba = {}};
  for (int i = 0; i < kTexels * kTexels; ++i) {
    const auto value = static_cast<std::uint8_t>((i + i / kTexels) % 2 == 0 ? 255 : 0);
    board.rgba.insert(board.rgba.end(), {value, value, value, 255});
  }
  scene.images.push_back(std::move(board));
  scene::Material material;
  material.unlit = true;
  material.doubleSided = true;
  material.baseColorTexture.image = 0;
  material.baseColorTexture.uvSet = 1;
  scene.materials.push_back(material);
  scene::Primitive wall;
  wall.material = 0;
  for (int y = 0; y < cells; ++y) {
    for (int x = 0; x < cells; ++x) {
      const auto place = [cells](int i) {
        return 4.0F * static_cast<float>(i) / static_cast<float>(cells) - 2.0F;
      };
      scene::addQuad(wall, {place(x), place(y), -2.0F}, {place(x + 1), place(y), -2.0F},
                     {place(x + 1), place(y + 1), -2.0F}, {place(x), place(y + 1), -2.0F});
    }
  }
  for (std::size_t i = 0; i < wall.positions.size(); ++i) {
    wall.attributes[i].uv0 = glm::vec2(0.25F);
    wall.attributes[i].uv1 = 8.0F * glm::vec2(wall.positions[i]);
  }
  scene.primitives.push_back(std::move(wall));
  scene.instances.push_back({0, glm::mat4(1.0F)});
  return scene;
}

TEST_F(GlTest, TheSecondCoordinatesOfATextureAreKnownBesideATriangleToo) {
  // Neighbours outside of the triangle find the level of a texture with those inside. In storage
  // they would read nothing, and so the wrong set of coordinates.
  Bench whole(checkedWall(1), linearSettings("blend"), kSize, device());
  whole.draw();
  Bench parts(checkedWall(24), linearSettings("blend"), kSize, device());
  parts.draw();
  EXPECT_LT(largestDifference(whole.linear(), parts.linear()), 0.02F);
}

/// A lit floor ahead under a sun from behind, and perhaps a roof that the camera cannot see.
scene::Scene floorUnderASun(bool roof) {
  scene::Scene scene = emptyScene();
  scene::Light sun;
  sun.direction = glm::normalize(glm::vec3(0.0F, -1.0F, -1.0F));
  sun.intensity = 3.0F;
  sun.castsShadow = true;
  scene.lights.push_back(sun);
  scene::Material material;
  material.metallic = 0.0F;
  material.doubleSided = true;
  scene.materials.push_back(material);
  const auto add = [&scene](float y, float far, float near) {
    scene::Primitive quad;
    quad.material = 0;
    scene::addQuad(quad, {-20.0F, y, near}, {20.0F, y, near}, {20.0F, y, far}, {-20.0F, y, far});
    scene.instances.push_back({static_cast<std::uint32_t>(scene.primitives.size()), glm::mat4(1)});
    scene.primitives.push_back(std::move(quad));
  };
  add(-1.0F, -9.0F, -1.0F);
  if (roof) add(6.0F, -6.0F, 12.0F);
  return scene;
}

/// The wall in plain grey, lit from the eye's side.
scene::Scene litWall(glm::vec3 color, float intensity) {
  scene::Scene scene = checkedWall(1);
  scene::Material grey;
  grey.baseColor = {0.5F, 0.5F, 0.5F, 1.0F};
  grey.roughness = 0.4F;
  grey.doubleSided = true;
  scene.materials[0] = grey;
  scene::Light light;
  light.type = scene::LightType::Point;
  light.color = color;
  light.intensity = intensity;
  light.position = {0.3F, 0.2F, 0.5F};
  light.range = 20.0F;
  scene.lights.push_back(light);
  return scene;
}

TEST_F(GlTest, LightsAreTheSameAsConstantsAndAsUniforms) {
  scene::Scene scene = litWall({1.0F, 0.8F, 0.6F}, 3.0F);
  Bench constants(scene, linearSettings("blend"), kSize, device());
  constants.draw();
  // More than programs are specialised by, of which only one shines.
  scene::Light dark;
  dark.type = scene::LightType::Point;
  dark.intensity = 0.0F;
  scene.lights.resize(scene::kSpecialisedLights + 1, dark);
  Bench uniforms(scene, linearSettings("blend"), kSize, device());
  uniforms.draw();
  const std::vector<float> lit = constants.linear();
  EXPECT_GT(*std::max_element(lit.begin(), lit.end()), 0.1F) << "there is light to compare";
  EXPECT_LT(largestDifference(lit, uniforms.linear()), 1e-3F) << "halves, and constants fold";
}

TEST_F(GlTest, ALightBeyondTheRangeOfFloatsStillDraws) {
  Bench bench(litWall(glm::vec3(100.0F), 3e38F), linearSettings("blend"), kSize, device());
  bench.draw();
  const std::vector<float> values = bench.linear();
  EXPECT_TRUE(std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); }));
}

TEST_F(GlTest, WhatIsOutsideOfTheViewStillCastsItsShadow) {
  const auto sumOf = [](bool roof) {
    Bench bench(floorUnderASun(roof), linearSettings("blend"), kSize, device());
    bench.draw();
    const std::vector<float> image = bench.linear();
    return std::accumulate(image.begin(), image.end(), 0.0F);
  };
  const float lit = sumOf(false);
  EXPECT_GT(lit, 10.0F);
  EXPECT_LT(sumOf(true), 0.05F * lit);
}

}  // namespace
}  // namespace macula::test
