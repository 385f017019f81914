// What alpha leaves of transparent surfaces, as far as it is known before drawing.
#include "engine/scene/alpha_holes.h"

#include <gtest/gtest.h>

#include "engine/scene/procedural/recipes.h"
#include "engine/scene/scene_facts.h"
#include "engine/scene/scene_info.h"

namespace macula::scene {
namespace {

/// A triangle of one material, under an image of two texels.
Scene triangle(std::uint8_t texelA, std::uint8_t texelB) {
  Scene scene;
  scene.images.push_back({"image", 2, 1, {255, 255, 255, texelA, 255, 255, 255, texelB}});
  Material material;
  material.alphaMode = AlphaMode::Blend;
  material.baseColorTexture.image = 0;
  scene.materials.push_back(material);
  Primitive mesh;
  mesh.material = 0;
  mesh.positions.resize(3);
  mesh.attributes.resize(3);
  mesh.indices = {0, 1, 2};
  scene.primitives.push_back(mesh);
  scene.instances.push_back({});
  return scene;
}

AlphaHoles holesOf(const Scene& scene) {
  return alphaHolesOf(scene).front();
}

TEST(AlphaHoles, FollowTheImage) {
  EXPECT_EQ(holesOf(triangle(255, 255)), AlphaHoles::None);
  EXPECT_EQ(holesOf(triangle(1, 255)), AlphaHoles::None);
  EXPECT_EQ(holesOf(triangle(0, 255)), AlphaHoles::Some);
  EXPECT_EQ(holesOf(triangle(0, 0)), AlphaHoles::All);
}

TEST(AlphaHoles, FollowFactorAndCorners) {
  Scene scene = triangle(200, 255);
  scene.primitives[0].attributes[1].color.a = 0.0F;
  EXPECT_EQ(holesOf(scene), AlphaHoles::None) << "two corners have alpha, so has all between";
  EXPECT_FALSE(
      isNothing(scene.materials[0], scene.primitives[0], scene.primitives[0].indices.data()));
  for (VertexAttributes& vertex : scene.primitives[0].attributes) vertex.color.a = 0.0F;
  EXPECT_EQ(holesOf(scene), AlphaHoles::All);
  EXPECT_TRUE(
      isNothing(scene.materials[0], scene.primitives[0], scene.primitives[0].indices.data()));
  scene = triangle(200, 255);
  scene.materials[0].baseColor.a = 0.0F;
  EXPECT_EQ(holesOf(scene), AlphaHoles::All);
  scene.materials[0].baseColor.a = 1e-8F;  // a half float holds 0
  EXPECT_EQ(holesOf(scene), AlphaHoles::All);
  scene.materials[0].baseColor.a = 1e-7F;
  EXPECT_EQ(holesOf(scene), AlphaHoles::None);
}

TEST(AlphaHoles, FollowTheAlphaMode) {
  Scene scene = triangle(0, 255);
  scene.materials[0].transmission = 1.0F;
  scene.materials[0].alphaMode = AlphaMode::Opaque;
  EXPECT_EQ(holesOf(scene), AlphaHoles::None) << "alpha is ignored";
  scene.materials[0].alphaMode = AlphaMode::Mask;
  EXPECT_EQ(holesOf(scene), AlphaHoles::Some);
  scene.materials[0].alphaCutoff = 0.0F;
  EXPECT_EQ(holesOf(scene), AlphaHoles::None);
  scene.materials[0].alphaCutoff = 0.5F;
  scene.primitives[0].attributes.assign(3, {.color = glm::vec4(0.4F)});
  EXPECT_EQ(holesOf(scene), AlphaHoles::All);
  scene.materials[0].transmission = 0.0F;
  EXPECT_EQ(holesOf(scene), AlphaHoles::None) << "not transparent: the G-buffer tests it";
}

TEST(AlphaHoles, WhatIsAllHoleNeedsNoPass) {
  const Scene scene = triangle(0, 0);
  EXPECT_EQ(factsOf(scene, false).transparentTriangles, 0U);
  EXPECT_FALSE(factsOf(scene, false).litTransparent);
  EXPECT_EQ(describe(scene).transparentTriangles, 1U) << "counts the scene as it is";
}

TEST(AlphaHoles, UntexturedScenesHaveNone) {
  for (const Scene& scene : {makeSmoke(1), makeBottles(1), makeLayers(64, 1)}) {
    for (const AlphaHoles holes : alphaHolesOf(scene)) EXPECT_EQ(holes, AlphaHoles::None);
  }
}

}  // namespace
}  // namespace macula::scene
