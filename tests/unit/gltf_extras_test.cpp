// What Macula's own files say in extras, also where it is malformed.
#include <gtest/gtest.h>

#include <limits>
#include <utility>

#include "tests/unit/gltf_builder.h"

namespace macula::scene {
namespace {

using nlohmann::json;
using test::GltfBuilder;
using test::warns;

/// The shadow taps of a light whose extras hold `value`.
int tapsOf(const json& value) {
  GltfBuilder builder;
  builder.root["extensionsUsed"] = {"KHR_lights_punctual"};
  builder.root["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "directional"}, {"extras", {{"macula_shadow_taps", value}}}}};
  builder.root["nodes"] = {{{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}}};
  return builder.load().lights.at(0).shadowTaps;
}

TEST(GltfExtras, ShadowTapsAreOddAndWithinTheirLimits) {
  EXPECT_EQ(tapsOf(9), 9);
  EXPECT_EQ(tapsOf(1), 1);
  EXPECT_EQ(tapsOf(15), 15);
  EXPECT_EQ(tapsOf(4), 5);
  EXPECT_EQ(tapsOf(14), 15);
  EXPECT_EQ(tapsOf(8.75), 9);
  EXPECT_EQ(tapsOf(0), 1);
  EXPECT_EQ(tapsOf(-7), 1);
  EXPECT_EQ(tapsOf(16), kMostShadowTaps);
  EXPECT_EQ(tapsOf(1e300), kMostShadowTaps);
  for (const json& value :
       {json("9"), json(true), json(nullptr), json::array({9}), json::object({{"taps", 9}})}) {
    EXPECT_EQ(tapsOf(value), kUsualShadowTaps) << value;
  }
}

AmbientOcclusion occlusionOf(const json& value) {
  GltfBuilder builder;
  builder.root["scene"] = 0;
  builder.root["scenes"] = {{{"extras", {{"macula_occlusion", value}}}}};
  return builder.load().occlusion;
}

TEST(GltfExtras, OcclusionStaysWithinItsLimits) {
  const AmbientOcclusion asGiven = occlusionOf({{"radius", 0.5}, {"samples", 64}});
  EXPECT_EQ(asGiven.radius, 0.5F);
  EXPECT_EQ(asGiven.samples, 64);
  EXPECT_EQ(occlusionOf({{"radius", 0.5}, {"samples", 1000000}}).samples, kMostOcclusionSamples);
  for (const json& value :
       {json(1), json("x"), json(nullptr), json::array({0.5, 64}), json::object(),
        json{{"radius", 0.5}}, json{{"samples", 64}}, json{{"radius", 0.5}, {"samples", 0}},
        json{{"radius", -0.5}, {"samples", 64}}, json{{"radius", 0.5}, {"samples", -64}},
        json{{"radius", "0.5"}, {"samples", 64}}, json{{"radius", 0.5}, {"samples", 0.9}}}) {
    EXPECT_FALSE(occlusionOf(value).any()) << value;
    EXPECT_EQ(occlusionOf(value).radius, 0.0F) << value;
  }
}

Scene veined(const json& value, int materials = 1, const char* alphaMode = "OPAQUE") {
  GltfBuilder builder;
  builder.root["materials"] = json::array();
  for (int i = 0; i < materials; ++i) {
    builder.root["materials"].push_back(
        {{"alphaMode", alphaMode}, {"extras", {{"macula_veins", value}}}});
  }
  return builder.load();
}

TEST(GltfExtras, VeinsStayWithinTheirLimits) {
  const Veins asGiven = veined({{"color", {0.1, 0.2, 0.3}}, {"scale", 4.5}}).materials[0].veins;
  EXPECT_EQ(asGiven.color, glm::vec3(0.1F, 0.2F, 0.3F));
  EXPECT_EQ(asGiven.scale, 4.5F);
  const Veins bright = veined({{"color", {7, -1, "x"}}, {"scale", 4}}).materials[0].veins;
  EXPECT_EQ(bright.color, glm::vec3(1.0F, 0.0F, 0.0F));
  EXPECT_EQ(veined({{"color", {1, 1}}, {"scale", 4}}).materials[0].veins.color, glm::vec3(0.0F));
  for (const json& value :
       {json(3), json("veins"), json(nullptr), json::array({1, 2}), json::object(),
        json{{"color", {1, 1, 1}}}, json{{"color", {1, 1, 1}}, {"scale", 0}},
        json{{"color", {1, 1, 1}}, {"scale", -3}}, json{{"color", {1, 1, 1}}, {"scale", {3}}}}) {
    const Scene scene = veined(value);
    EXPECT_FALSE(scene.materials[0].veins.any()) << value;
    EXPECT_FALSE(warns(scene, "veins")) << value;
  }
}

TEST(GltfExtras, OnlySoManyMaterialsHaveVeins) {
  const json value{{"color", {0.1, 0.2, 0.3}}, {"scale", 4.5}};
  EXPECT_FALSE(warns(veined(value, kMostVeins), "veins"));
  const Scene scene = veined(value, kMostVeins + 1);
  EXPECT_TRUE(scene.materials[kMostVeins - 1].veins.any());
  EXPECT_FALSE(scene.materials[kMostVeins].veins.any());
  EXPECT_TRUE(
      warns(scene, "material 8: its veins are not drawn, because 8 materials before it have some"));
}

TEST(GltfExtras, TransparentMaterialsHaveNoVeins) {
  const Scene scene = veined({{"color", {0, 0, 0}}, {"scale", 4}}, 1, "BLEND");
  EXPECT_FALSE(scene.materials[0].veins.any());
  EXPECT_TRUE(warns(scene, "material 0: its veins are not drawn, because it is transparent"));
}

}  // namespace
}  // namespace macula::scene
