#include "engine/scene/scene_info.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace macula::scene {
namespace {

Scene fourKinds() {
  Scene scene;
  scene.materials.resize(4);
  scene.materials[1].alphaMode = AlphaMode::Mask;
  scene.materials[2].alphaMode = AlphaMode::Blend;
  scene.materials[3].transmission = 0.5F;
  for (std::int32_t material = kNone; material < 4; ++material) {
    Primitive primitive;
    primitive.positions.resize(3);
    primitive.attributes.resize(3);
    // Powers of two: 1, 2, 4, 8, 16 triangles, so that each sum names its parts.
    primitive.indices.resize(3U << static_cast<unsigned>(material + 1));
    primitive.material = material;
    scene.primitives.push_back(primitive);
  }
  for (const std::uint32_t primitive : {0U, 1U, 2U, 2U, 3U, 4U}) {
    scene.instances.push_back({primitive, glm::mat4(1.0F)});
  }
  scene.lights.resize(2);
  scene.images.resize(3);
  scene.warnings = {"w"};
  scene.unsupportedExtensions = {"E"};
  return scene;
}

TEST(SceneInfo, CountsOverInstances) {
  const SceneInfo info = describe(fourKinds());
  EXPECT_EQ(info.triangles, 1U + 2U + 4U + 4U + 8U + 16U);
  EXPECT_EQ(info.draws, 6U);
  EXPECT_EQ(info.maskTriangles, 8U);
  EXPECT_EQ(info.blendTriangles, 8U);
  EXPECT_EQ(info.transmissionTriangles, 16U);
  EXPECT_EQ(info.transparentTriangles, 24U);
  EXPECT_EQ(info.materials.opaque, 2);
  EXPECT_EQ(info.materials.mask, 1);
  EXPECT_EQ(info.materials.blend, 1);
  EXPECT_EQ(info.lights, 2);
  EXPECT_EQ(info.textures, 3);
}

TEST(SceneInfo, BlendWithTransmissionCountsOnce) {
  Scene scene = fourKinds();
  scene.materials[2].transmission = 1.0F;
  const SceneInfo info = describe(scene);
  EXPECT_EQ(info.transparentTriangles, 24U);
  EXPECT_EQ(info.transmissionTriangles, 24U);
}

TEST(SceneInfo, JsonHasTheDocumentedKeys) {
  EXPECT_EQ(toJson(describe(fourKinds())).dump(),
            R"({"triangles":35,"draws":6,"materials":{"opaque":2,"mask":1,"blend":1},)"
            R"("transparent_triangles":24,"lights":2,"textures":3,)"
            R"("extensions_unsupported":["E"],"warnings":["w"]})");
}

}  // namespace
}  // namespace macula::scene
