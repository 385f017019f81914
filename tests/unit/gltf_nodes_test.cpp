// Node hierarchy, skins, lights and cameras of glTF files made by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/gltf_builder.h"

namespace macula::scene {
namespace {

using nlohmann::json;
using test::GltfBuilder;
using test::kF32;
using test::kU8;
using test::messageOf;
using test::Square;
using test::warns;
using Indices = std::vector<std::uint32_t>;

TEST(GltfNodes, HierarchyOfMatrixAndTrs) {
  GltfBuilder builder;
  builder.draw({{"attributes", {{"POSITION", builder.trianglePositions()}}}});
  // Half a turn about z, twice the size, mirrored in y; below a shift by a matrix.
  builder.root["nodes"][0].update(
      {{"translation", {1, 2, 3}}, {"rotation", {0, 0, 1, 0}}, {"scale", {2, -2, 2}}});
  builder.root["nodes"].push_back(
      {{"children", {0}}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 10, 20, 30, 1}}});
  const Scene scene = builder.load();
  ASSERT_EQ(scene.instances.size(), 1U);
  const glm::mat4& m = scene.instances[0].transform;
  // (1,1,1): scaled (2,-2,2), turned (-2,2,2), shifted by (11,22,33).
  const glm::vec4 moved = m * glm::vec4(1, 1, 1, 1);
  EXPECT_NEAR(moved.x, 9.0F, 1e-5F);
  EXPECT_NEAR(moved.y, 24.0F, 1e-5F);
  EXPECT_NEAR(moved.z, 35.0F, 1e-5F);
  EXPECT_LT(glm::determinant(glm::mat3(m)), 0.0F);
}

TEST(GltfNodes, SceneChoice) {
  GltfBuilder builder;
  for (int i = 0; i < 3; ++i) {
    builder.draw({{"attributes", {{"POSITION", i == 0 ? builder.trianglePositions() : 0}}}});
    builder.root["nodes"][static_cast<std::size_t>(i)]["translation"] = {i, 0, 0};
  }
  EXPECT_EQ(builder.load().instances.size(), 3U);  // no scene: all roots
  builder.root["scenes"] = {{{"nodes", {1}}}, {{"nodes", {2, 0}}}};
  EXPECT_EQ(builder.load().instances.at(0).transform[3].x, 1.0F);  // the first
  builder.root["scene"] = 1;
  const Scene scene = builder.load();
  ASSERT_EQ(scene.instances.size(), 2U);
  EXPECT_EQ(scene.instances[0].transform[3].x, 2.0F);
  builder.root["scene"] = 2;
  EXPECT_SAYS(messageOf(builder), "names scene 2 of 2");
  builder.root["scene"] = 0;
  builder.root["scenes"][0]["nodes"] = {7};
  EXPECT_SAYS(messageOf(builder), "names node 7 of 3");
}

TEST(GltfNodes, AHierarchyThatIsNoTreeIsRefused) {
  GltfBuilder builder;
  builder.root["nodes"] = {{{"children", {1}}}, {{"children", {0}}}};
  EXPECT_SAYS(messageOf(builder), "their own ancestors");
  builder.root["nodes"] = {{{"children", {0}}}};
  EXPECT_SAYS(messageOf(builder), "their own ancestors");
  builder.root["nodes"] = {{{"children", {2}}}, {{"children", {2}}}, json::object()};
  EXPECT_SAYS(messageOf(builder), "child of both node 0 and node 1");
  builder.root["nodes"] = {{{"children", {5}}}};
  EXPECT_SAYS(messageOf(builder), "names child 5 of 1");
  builder.root["nodes"] = {{{"scale", {1, 2}}}};
  EXPECT_SAYS(messageOf(builder), "scale has 2 numbers where 3");
  builder.root["nodes"] = {{{"translation", {1e30, 0, 0}}}};
  EXPECT_SAYS(messageOf(builder), "transform is beyond");
}

TEST(GltfNodes, DeepHierarchiesNeedNoStack) {
  GltfBuilder builder;
  constexpr int kDeep = 100000;
  json nodes = json::array();
  for (int i = 1; i < kDeep; ++i) nodes.push_back({{"children", {i}}});
  nodes.push_back({{"mesh", 0}});
  builder.draw({{"attributes", {{"POSITION", builder.trianglePositions()}}}});
  builder.root["nodes"] = std::move(nodes);
  EXPECT_EQ(builder.load().instances.size(), 1U);
}

TEST(GltfSkins, VerticesFollowTheRestPose) {
  Square square;
  square.attributes["JOINTS_0"] = square.attribute<std::uint8_t>(
      {0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0}, kU8, "VEC4", 4);
  square.attributes["WEIGHTS_0"] = square.attribute<float>(
      {1, 0, 0, 0, 0.5F, 0.5F, 0, 0, 2, 2, 0, 0, 1, 0, 0, 0}, kF32, "VEC4", 4);
  square.draw({{"attributes", square.attributes}, {"mode", 5}});
  square.root["nodes"][0].update({{"skin", 0}, {"translation", {500, 0, 0}}});
  square.root["nodes"].push_back({{"translation", {0, 0, 4}}});
  square.root["nodes"].push_back({{"translation", {0, 0, 10}}});
  // Inverse bind: joint 0 none, joint 1 back by 2 along z. So joint 0 moves by 4, joint 1 by 8.
  const int bind = square.attribute<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0,  1,
                                            1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -2, 1},
                                           kF32, "MAT4", 2);
  square.root["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", bind}}};
  const Scene scene = square.load();
  ASSERT_EQ(scene.instances.size(), 1U);
  EXPECT_EQ(scene.instances[0].transform, glm::mat4(1.0F));  // the node's own one does not count
  using Points = std::vector<glm::vec3>;
  EXPECT_EQ(scene.primitives.at(0).positions, (Points{{0, 0, 4}, {1, 0, 6}, {0, 1, 6}, {1, 1, 8}}));
  EXPECT_EQ(scene.primitives[0].attributes[3].normal, glm::vec3(0, 0, 1));
  square.root["skins"][0]["joints"] = {1};
  EXPECT_SAYS(messageOf(square), "vertex 1 names joint 1 of 1");
  square.root["skins"][0]["joints"] = {1, 9};
  EXPECT_SAYS(messageOf(square), "skin 0: names node 9 of 3");
  square.root["skins"][0]["joints"] = {0, 1, 2};
  EXPECT_SAYS(messageOf(square), "has 2 elements where 3 are needed");
}

TEST(GltfSkins, MirroringJointsKeepFrontFaces) {
  Square square;
  square.attributes["JOINTS_0"] =
      square.attribute<std::uint8_t>(std::vector<std::uint8_t>(16, 0), kU8, "VEC4", 4);
  square.attributes["WEIGHTS_0"] = square.attribute<std::uint8_t>(
      {255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0}, kU8, "VEC4", 4, true);
  square.draw({{"attributes", square.attributes}});
  square.root["nodes"][0]["skin"] = 0;
  square.root["nodes"].push_back({{"scale", {-1, 1, 1}}});
  // No inverse bind matrices: identity.
  square.root["skins"] = {{{"joints", {1}}}};
  const Primitive p = square.load().primitives.at(0);
  EXPECT_EQ(p.positions[1], glm::vec3(-1, 0, 0));
  EXPECT_EQ(p.indices, (Indices{0, 2, 1}));
  EXPECT_EQ(p.attributes[0].normal, glm::vec3(0, 0, 1));
}

TEST(GltfLights, AreInWorldSpace) {
  GltfBuilder builder;
  builder.root["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "directional"}, {"color", {1, 0.5, 0.25}}, {"intensity", 3}},
      {{"type", "point"}, {"range", 7}},
      {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.25}, {"outerConeAngle", 0.5}}}}};
  const auto light = [](int index) { return json{{"KHR_lights_punctual", {{"light", index}}}}; };
  const double half = std::sqrt(0.5);
  builder.root["nodes"] = {
      // A quarter turn about x takes -z to +y; scale does not count.
      {{"rotation", {half, 0, 0, half}}, {"scale", {3, 3, 3}}, {"extensions", light(0)}},
      {{"translation", {1, 2, 3}}, {"extensions", light(1)}},
      {{"translation", {0, 0, 5}}, {"extensions", light(2)}}};
  const Scene scene = builder.load();
  ASSERT_EQ(scene.lights.size(), 3U);
  EXPECT_EQ(scene.lights[0].type, LightType::Directional);
  EXPECT_NEAR(glm::distance(scene.lights[0].direction, glm::vec3(0, 1, 0)), 0.0F, 1e-6F);
  EXPECT_EQ(scene.lights[0].color, glm::vec3(1, 0.5, 0.25));
  EXPECT_EQ(scene.lights[0].intensity, 3.0F);
  EXPECT_EQ(scene.lights[1].type, LightType::Point);
  EXPECT_EQ(scene.lights[1].position, glm::vec3(1, 2, 3));
  EXPECT_EQ(scene.lights[1].range, 7.0F);
  EXPECT_EQ(scene.lights[1].color, glm::vec3(1.0F));
  EXPECT_EQ(scene.lights[2].type, LightType::Spot);
  EXPECT_EQ(scene.lights[2].direction, glm::vec3(0, 0, -1));
  EXPECT_EQ(scene.lights[2].innerConeAngle, 0.25F);
  EXPECT_EQ(scene.lights[2].outerConeAngle, 0.5F);
  EXPECT_EQ(scene.ambient, glm::vec3(0.0F));
  builder.root["nodes"][0]["extensions"] = light(3);
  EXPECT_SAYS(messageOf(builder), "node 0: names light 3 of 3");
}

TEST(GltfCameras, AreInWorldSpace) {
  GltfBuilder builder;
  builder.draw({{"attributes", {{"POSITION", builder.trianglePositions()}}}});
  builder.root["cameras"] = {
      {{"type", "perspective"}, {"name", "c"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.25}}}},
      {{"type", "orthographic"},
       {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"zfar", 9}, {"znear", 1}}}}};
  // Half a turn about y looks along +z.
  builder.root["nodes"].push_back(
      {{"camera", 0}, {"translation", {0, 0, -20}}, {"rotation", {0, 1, 0, 0}}});
  builder.root["nodes"].push_back({{"camera", 1}});
  const Scene scene = builder.load();
  ASSERT_EQ(scene.cameras.size(), 1U);
  const Camera& camera = scene.cameras[0];
  EXPECT_EQ(camera.name, "c");
  EXPECT_EQ(camera.position, glm::vec3(0, 0, -20));
  const glm::vec3 ahead = glm::normalize(camera.target - camera.position);
  EXPECT_NEAR(glm::distance(ahead, glm::vec3(0, 0, 1)), 0.0F, 1e-6F);
  EXPECT_EQ(camera.up, glm::vec3(0, 1, 0));
  EXPECT_EQ(camera.verticalFov, 0.5F);
  EXPECT_EQ(camera.nearPlane, 0.25F);
  EXPECT_GT(camera.farPlane, 20.0F);  // no zfar: behind the scene
  EXPECT_LT(camera.farPlane, 30.0F);
  EXPECT_TRUE(warns(scene, "camera 1: is orthographic"));
}

}  // namespace
}  // namespace macula::scene
