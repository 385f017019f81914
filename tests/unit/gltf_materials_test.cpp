// Materials, textures and images of glTF files made by hand.
#include <gtest/gtest.h>

#include "tests/unit/gltf_builder.h"

namespace macula::scene {
namespace {

using nlohmann::json;
using test::GltfBuilder;
using test::kF32;
using test::messageOf;
using test::Square;
using test::warns;

// 2 x 1 pixels of 8-bit RGBA: (255,0,0,255) (0,128,64,32).
constexpr const char* kPng =
    "data:image/"
    "png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAYAAAD0In+KAAAAEUlEQVR42mP4z8Dwn6HBQQEADxwC30ynO/"
    "MAAAAASUVORK5CYII=";
// One pixel of 16-bit grey: 0xAB12.
constexpr const char* kPng16 =
    "data:image/"
    "png;base64,"
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABEAAAAABq7kcWAAAAC0lEQVR42mNYLQQAAWsAvmbKAAMAAAAASUVORK5CYII=";

TEST(GltfMaterials, FactorsAndExtensions) {
  GltfBuilder builder;
  builder.root["materials"] = {{{"name", "a"},
                                {"pbrMetallicRoughness",
                                 {{"baseColorFactor", {0.25, 0.5, 0.75, 0.125}},
                                  {"metallicFactor", 0.5},
                                  {"roughnessFactor", 0.25}}},
                                {"emissiveFactor", {1, 0.5, 0}},
                                {"alphaMode", "BLEND"},
                                {"doubleSided", true},
                                {"extensions",
                                 {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}},
                                  {"KHR_materials_unlit", json::object()}}}},
                               {{"alphaMode", "MASK"},
                                {"alphaCutoff", 0.25},
                                {"extensions",
                                 {{"KHR_materials_transmission", {{"transmissionFactor", 0.75}}},
                                  {"KHR_materials_volume",
                                   {{"thicknessFactor", 0.5},
                                    {"attenuationDistance", 2},
                                    {"attenuationColor", {0.5, 0.25, 1}}}}}}},
                               json::object()};
  const Scene scene = builder.load();
  const Material& a = scene.materials.at(0);
  EXPECT_EQ(a.name, "a");
  EXPECT_EQ(a.baseColor, glm::vec4(0.25, 0.5, 0.75, 0.125));
  EXPECT_EQ(a.metallic, 0.5F);
  EXPECT_EQ(a.roughness, 0.25F);
  EXPECT_EQ(a.emissive, glm::vec3(4, 2, 0));
  EXPECT_EQ(a.alphaMode, AlphaMode::Blend);
  EXPECT_TRUE(a.doubleSided);
  EXPECT_TRUE(a.unlit);
  const Material& b = scene.materials.at(1);
  EXPECT_EQ(b.alphaMode, AlphaMode::Mask);
  EXPECT_EQ(b.alphaCutoff, 0.25F);
  EXPECT_EQ(b.transmission, 0.75F);
  EXPECT_EQ(b.thickness, 0.5F);
  EXPECT_EQ(b.attenuationDistance, 2.0F);
  EXPECT_EQ(b.attenuationColor, glm::vec3(0.5, 0.25, 1));
  const Material& defaults = scene.materials.at(2);
  EXPECT_EQ(defaults.baseColor, glm::vec4(1.0F));
  EXPECT_EQ(defaults.metallic, 1.0F);
  EXPECT_EQ(defaults.alphaMode, AlphaMode::Opaque);
  EXPECT_FALSE(defaults.isTransparent());
}

TEST(GltfMaterials, TexturesSamplersAndUvSets) {
  GltfBuilder builder;
  builder.root["images"] = {
      {{"uri", kPng16}}, {{"uri", kPng}, {"name", "two"}}, {{"uri", "gone.png"}}};
  builder.root["samplers"] = {
      {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}, {"minFilter", 9729}}};
  builder.root["textures"] = {{{"source", 1}, {"sampler", 0}}, {{"source", 0}}, {{"source", 2}}};
  builder.root["materials"] = {{{"pbrMetallicRoughness",
                                 {{"baseColorTexture", {{"index", 0}, {"texCoord", 1}}},
                                  {"metallicRoughnessTexture", {{"index", 1}}}}},
                                {"normalTexture", {{"index", 2}, {"scale", 0.5}}},
                                {"occlusionTexture", {{"index", 1}, {"strength", 0.25}}},
                                {"emissiveTexture", {{"index", 0}, {"texCoord", 2}}}}};
  const Scene scene = builder.load();
  ASSERT_EQ(scene.images.size(), 3U);
  EXPECT_EQ(scene.images[1].width, 2);
  EXPECT_EQ(scene.images[1].height, 1);
  EXPECT_EQ(scene.images[1].rgba, (std::vector<std::uint8_t>{255, 0, 0, 255, 0, 128, 64, 32}));
  EXPECT_EQ(scene.images[0].rgba, (std::vector<std::uint8_t>{0xAB, 0xAB, 0xAB, 255}));
  EXPECT_EQ(scene.images[2].rgba, (std::vector<std::uint8_t>{255, 255, 255, 255}));
  const Material& m = scene.materials.at(0);
  EXPECT_EQ(m.baseColorTexture.image, 1);
  EXPECT_EQ(m.baseColorTexture.uvSet, 1);
  EXPECT_EQ(m.baseColorTexture.sampler.wrapS, Sampler::Wrap::ClampToEdge);
  EXPECT_EQ(m.baseColorTexture.sampler.wrapT, Sampler::Wrap::MirroredRepeat);
  EXPECT_TRUE(m.baseColorTexture.sampler.nearest);
  EXPECT_FALSE(m.baseColorTexture.sampler.mipmaps);
  EXPECT_EQ(m.metallicRoughnessTexture.image, 0);
  EXPECT_EQ(m.metallicRoughnessTexture.sampler.wrapS, Sampler::Wrap::Repeat);
  EXPECT_TRUE(m.metallicRoughnessTexture.sampler.mipmaps);
  EXPECT_EQ(m.normalTexture.image, kNone);
  EXPECT_EQ(m.normalScale, 0.5F);
  EXPECT_EQ(m.occlusionStrength, 0.25F);
  EXPECT_EQ(m.emissiveTexture.uvSet, 0);
  EXPECT_TRUE(warns(scene, "image 2 (gone.png): not drawn"));
  EXPECT_TRUE(warns(scene, "texture coordinates 2"));
  builder.root["textures"][0]["source"] = 8;
  EXPECT_SAYS(messageOf(builder), "texture 0: names image 8 of 3");
}

TEST(GltfMaterials, ImagesBeyondTheLimitsAreLeftOut) {
  GltfBuilder builder;
  builder.root["images"] = {{{"uri", kPng}}};
  builder.root["textures"] = {{{"source", 0}}};
  builder.root["materials"] = {{{"emissiveTexture", {{"index", 0}}}}};
  GltfLimits side;
  side.imageSide = 1;
  EXPECT_TRUE(warns(builder.load(side), "2 x 1 pixels are more than 1 a side"));
  GltfLimits bytes;
  bytes.imageBytes = 7;
  EXPECT_TRUE(warns(builder.load(bytes), "exceed 7 bytes"));
  EXPECT_EQ(builder.load().warnings, std::vector<std::string>{"the scene holds no triangles"});
  // A header that promises 16384 x 16384 pixels, and nothing behind it.
  std::vector<std::uint8_t> liar = {0x89, 'P', 'N', 'G', 13,  10, 26, 10,   0, 0, 0,
                                    13,   'I', 'H', 'D', 'R', 0,  0,  0x40, 0, 0, 0,
                                    0x40, 0,   8,   6,   0,   0,  0,  0,    0, 0, 0};
  builder.root["images"] = {{{"bufferView", builder.view(liar)}, {"mimeType", "image/png"}}};
  EXPECT_TRUE(warns(builder.load(), "it is damaged"));
  builder.root["bufferViews"][0]["byteLength"] = 4096;
  EXPECT_TRUE(warns(builder.load(), "reaches beyond"));
}

TEST(GltfMaterials, NormalTexturesBringTangents) {
  Square square;
  square.attributes["TEXCOORD_0"] =
      square.attribute<float>({0, 1, 0, 0, 1, 1, 1, 0}, kF32, "VEC2", 4);
  square.root["images"] = {{{"uri", kPng}}};
  square.root["textures"] = {{{"source", 0}}};
  square.root["materials"] = {{{"normalTexture", {{"index", 0}}}}};
  square.draw({{"attributes", square.attributes}, {"material", 0}, {"mode", 5}});
  // u grows with y, v shrinks with x: cross(normal, tangent) = -x is down, so w turns it.
  const Scene scene = square.load();
  for (const VertexAttributes& v : scene.primitives.at(0).attributes) {
    EXPECT_EQ(v.tangent, glm::vec4(0, 1, 0, -1));
  }
}

}  // namespace
}  // namespace macula::scene
