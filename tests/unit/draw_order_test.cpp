#include "engine/scene/draw_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "passes/render_settings.h"

namespace macula::scene {
namespace {

/// Triangles across the z axis at these heights, facing +z; the camera stands at z = 10.
Scene stack(const std::vector<float>& heights, AlphaMode mode) {
  Scene scene;
  scene.materials.resize(1);
  scene.materials[0].alphaMode = mode;
  Primitive mesh;
  for (const float z : heights) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {{-1, -1, z}, {1, -1, z}, {0, 2, z}});
    mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2});
  }
  mesh.attributes.resize(mesh.positions.size());
  mesh.material = 0;
  scene.primitives.push_back(mesh);
  scene.instances.push_back({0, glm::mat4(1.0F)});
  Camera camera;
  camera.position = {0, 0, 10};
  scene.cameras.push_back(camera);
  return scene;
}

std::vector<float> heightsOf(const Primitive& mesh) {
  std::vector<float> heights;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    // A triangle stays whole, its corners in their order.
    EXPECT_EQ(mesh.indices[i] % 3, 0U);
    EXPECT_EQ(mesh.indices[i + 1], mesh.indices[i] + 1);
    EXPECT_EQ(mesh.indices[i + 2], mesh.indices[i] + 2);
    heights.push_back(mesh.positions[mesh.indices[i]].z);
  }
  return heights;
}

glm::mat4 movedBy(float z) {
  glm::mat4 m(1.0F);
  m[3].z = z;
  return m;
}

using Heights = std::vector<float>;

TEST(TransparentOrder, SortsTrianglesByDistance) {
  const Heights given{1, 5, 3, -2, 4};
  Scene scene = stack(given, AlphaMode::Blend);
  orderTransparent(scene, TransparentOrder::File, 1);
  EXPECT_EQ(heightsOf(scene.primitives[0]), given);
  orderTransparent(scene, TransparentOrder::NearFirst, 1);
  EXPECT_EQ(heightsOf(scene.primitives[0]), (Heights{5, 4, 3, 1, -2}));
  orderTransparent(scene, TransparentOrder::FarFirst, 1);
  EXPECT_EQ(heightsOf(scene.primitives[0]), (Heights{-2, 1, 3, 4, 5}));
}

TEST(TransparentOrder, MeasuresInTheWorld) {
  Scene scene = stack({1, 5, 3}, AlphaMode::Blend);
  // Turned about y by half a turn: what was near is far.
  scene.instances[0].transform[0].x = scene.instances[0].transform[2].z = -1.0F;
  orderTransparent(scene, TransparentOrder::NearFirst, 1);
  EXPECT_EQ(heightsOf(scene.primitives[0]), (Heights{1, 3, 5}));
}

TEST(TransparentOrder, LeavesOpaqueOnesAlone) {
  const Heights given{1, 5, 3};
  for (const TransparentOrder order :
       {TransparentOrder::NearFirst, TransparentOrder::FarFirst, TransparentOrder::Random}) {
    Scene scene = stack(given, AlphaMode::Opaque);
    scene.instances.push_back({0, movedBy(3.0F)});
    orderTransparent(scene, order, 1);
    EXPECT_EQ(heightsOf(scene.primitives[0]), given);
    EXPECT_EQ(scene.instances[1].transform, movedBy(3.0F));
  }
}

TEST(TransparentOrder, SortsInstancesAmongTheirPlaces) {
  Scene scene = stack({0}, AlphaMode::Blend);
  scene.materials.emplace_back();
  Primitive opaque = scene.primitives[0];
  opaque.material = 1;
  scene.primitives.push_back(opaque);
  scene.instances = {{0, movedBy(-4)}, {1, movedBy(9)}, {0, movedBy(2)}, {0, movedBy(1)}};
  orderTransparent(scene, TransparentOrder::NearFirst, 1);
  EXPECT_EQ(scene.instances[0].transform, movedBy(2));
  EXPECT_EQ(scene.instances[1].primitive, 1U) << "opaque ones keep theirs";
  EXPECT_EQ(scene.instances[2].transform, movedBy(1));
  EXPECT_EQ(scene.instances[3].transform, movedBy(-4));
}

TEST(TransparentOrder, SortsASharedPrimitiveForItsNearestInstance) {
  Scene scene = stack({1, 5, 3}, AlphaMode::Blend);
  glm::mat4 turned(1.0F);
  turned[0].x = turned[2].z = -1.0F;
  turned[3].z = 12.0F;  // its triangles stand at 11, 7 and 9: nearer than 1, 5 and 3
  scene.instances.push_back({0, turned});
  orderTransparent(scene, TransparentOrder::NearFirst, 1);
  // Distances from 10 of the centroids: 1 for 1, 3 for 5, 1 for 3; ties keep their order.
  EXPECT_EQ(heightsOf(scene.primitives[0]), (Heights{1, 3, 5}));
}

TEST(TransparentOrder, RandomIsAPermutationBySeed) {
  Heights given;
  for (int i = 0; i < 200; ++i) given.push_back(0.01F * static_cast<float>(i));
  const auto shuffled = [&](std::uint64_t seed) {
    Scene scene = stack(given, AlphaMode::Blend);
    orderTransparent(scene, TransparentOrder::Random, seed);
    return heightsOf(scene.primitives[0]);
  };
  Heights once = shuffled(1);
  EXPECT_EQ(once, shuffled(1));
  EXPECT_NE(once, shuffled(2));
  EXPECT_NE(once, given);
  std::sort(once.begin(), once.end());
  EXPECT_EQ(once, given);
}

TEST(TransparentOrder, WorksWithoutACameraAndWithoutTriangles) {
  Scene empty;
  orderTransparent(empty, TransparentOrder::NearFirst, 1);
  EXPECT_TRUE(empty.instances.empty());
  Scene scene = stack({-1, 1}, AlphaMode::Blend);
  scene.cameras.clear();
  orderTransparent(scene, TransparentOrder::NearFirst, 1);
  EXPECT_EQ(heightsOf(scene.primitives[0]), (Heights{1, -1})) << "the orbit begins in front, at +z";
}

TEST(TransparentOrder, IsASetting) {
  passes::RenderSettings values;
  settings::Registry registry;
  passes::registerSettings(registry, values);
  registry.setText("scene.order", "near-first", "test");
  EXPECT_EQ(values.order, TransparentOrder::NearFirst);
  registry.setText("scene.order", "far-first", "test");
  EXPECT_EQ(values.order, TransparentOrder::FarFirst);
  registry.setText("scene.order", "random", "test");
  EXPECT_EQ(values.order, TransparentOrder::Random);
}

}  // namespace
}  // namespace macula::scene
