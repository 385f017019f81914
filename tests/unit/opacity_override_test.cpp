#include "engine/scene/material_override.h"

#include <gtest/gtest.h>

#include <string>

#include "engine/core/error.h"
#include "engine/scene/glb_writer.h"
#include "engine/scene/load.h"
#include "engine/scene/scene_facts.h"
#include "passes/render_settings.h"

namespace macula::scene {
namespace {

constexpr float kOpacity = 0.25F;  // exact in binary: products can be compared as they are

/// A triangle each with an opaque, a cut-out, a blended and a transmissive material, and one with
/// none. Opaque and cut-out share an image with holes; every alpha is somewhere below 1.
Scene mixed() {
  Scene scene;
  scene.images.push_back({"holes", 2, 1, {10, 20, 30, 0, 40, 50, 60, 128}});
  scene.materials.resize(4);
  for (Material& material : scene.materials) material.baseColor.a = 0.5F;
  scene.materials[0].baseColorTexture.image = 0;
  scene.materials[1].alphaMode = AlphaMode::Mask;
  scene.materials[1].baseColorTexture.image = 0;
  scene.materials[2].alphaMode = AlphaMode::Blend;
  scene.materials[3].transmission = 1.0F;
  for (const std::int32_t material : {0, 1, 2, 3, kNone}) {
    Primitive primitive;
    primitive.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    primitive.attributes.resize(3);
    primitive.attributes[0].color = {0.5F, 0.5F, 0.5F, 0.75F};
    primitive.indices = {0, 1, 2};
    primitive.material = material;
    scene.instances.push_back({static_cast<std::uint32_t>(scene.primitives.size()), {}});
    scene.primitives.push_back(primitive);
  }
  return scene;
}

TEST(OpacityOverride, OneChangesNothingAtAll) {
  Scene scene = mixed();
  overrideOpacity(scene, 1.0F);
  EXPECT_EQ(glbBytes(scene), glbBytes(mixed()));
  EXPECT_EQ(scene.primitives[4].material, kNone);
}

TEST(OpacityOverride, BelowOneEverySurfaceIsTransparent) {
  Scene scene = mixed();
  EXPECT_EQ(factsOf(scene, false).transparentTriangles, 2U);
  overrideOpacity(scene, kOpacity);
  EXPECT_EQ(factsOf(scene, false).transparentTriangles, 5U);
  EXPECT_EQ(factsOf(scene, false).opaqueTriangles, 0U);
  ASSERT_EQ(scene.materials.size(), 5U) << "surfaces without a material got one";
  for (const Material& material : scene.materials) {
    EXPECT_EQ(material.alphaMode, AlphaMode::Blend);
  }
  EXPECT_EQ(scene.materials[1].baseColor.a, 0.5F * kOpacity);
  EXPECT_EQ(scene.materials[2].baseColor.a, 0.5F * kOpacity);
  EXPECT_EQ(scene.materialOf(scene.primitives[4]).baseColor, glm::vec4(1, 1, 1, kOpacity));
}

TEST(OpacityOverride, AlphaThatWasIgnoredStaysIgnored) {
  Scene scene = mixed();
  overrideOpacity(scene, kOpacity);
  for (const std::size_t opaque : {0U, 3U, 4U}) {
    EXPECT_EQ(scene.materialOf(scene.primitives[opaque]).baseColor.a, kOpacity) << opaque;
    EXPECT_EQ(scene.primitives[opaque].attributes[0].color, glm::vec4(0.5F, 0.5F, 0.5F, 1.0F));
  }
  EXPECT_EQ(scene.primitives[1].attributes[0].color.a, 0.75F) << "cut-outs read it";
  EXPECT_EQ(scene.primitives[2].attributes[0].color.a, 0.75F);

  // The opaque one has an image of its own; the cut-out's keeps its holes.
  ASSERT_EQ(scene.images.size(), 2U);
  EXPECT_EQ(scene.materials[1].baseColorTexture.image, 0);
  EXPECT_EQ(scene.images[0].rgba, mixed().images[0].rgba);
  EXPECT_EQ(scene.materials[0].baseColorTexture.image, 1);
  EXPECT_EQ(scene.images[1].rgba, (std::vector<std::uint8_t>{10, 20, 30, 255, 40, 50, 60, 255}));
}

TEST(OpacityOverride, ImagesWithoutAlphaAreShared) {
  Scene scene = mixed();
  for (const std::size_t i : {3U, 7U}) scene.images[0].rgba[i] = 255;
  overrideOpacity(scene, kOpacity);
  EXPECT_EQ(scene.images.size(), 1U);
  EXPECT_EQ(scene.materials[0].baseColorTexture.image, 0);
}

TEST(OpacityOverride, IsASettingAboveZero) {
  passes::RenderSettings values;
  settings::Registry registry;
  passes::registerSettings(registry, values);
  EXPECT_EQ(values.opacity, 1.0F);
  registry.setText("scene.opacity", "0.25", "test");
  EXPECT_EQ(values.opacity, kOpacity);
  for (const char* wrong : {"0", "-0.5", "1.5", "nan"}) {
    EXPECT_THROW(registry.setText("scene.opacity", wrong, "test"), InputError) << wrong;
  }
  EXPECT_EQ(values.opacity, kOpacity);
}

}  // namespace
}  // namespace macula::scene
