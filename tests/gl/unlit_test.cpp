// KHR_materials_unlit: a surface shows its base colour alone, wherever its colour is looked at.
#include "gl_fixture.h"
#include "oit_cases.h"

namespace macula::test {
namespace {

using passes::OitSettings;
using passes::Predictor;

constexpr glm::ivec2 kSize{24, 16};

/// An opaque sheet behind two that blend. @param emission of all materials
/// @param textured with an emissive texture, white
scene::Scene emitting(float emission, bool textured) {
  scene::Scene scene =
      sheets({{.distance = 9.0F, .color = {0.2F, 0.4F, 0.1F, 1.0F}, .opaque = true},
              {.distance = 5.0F, .color = {0.6F, 0.1F, 0.3F, 0.5F}},
              {.distance = 3.0F, .color = {0.1F, 0.2F, 0.9F, 0.25F}}});
  if (textured) {
    scene.images.push_back(
        {.name = "white", .width = 1, .height = 1, .rgba = {255, 255, 255, 255}});
  }
  for (scene::Material& material : scene.materials) {
    material.emissive = glm::vec3(emission, 0.5F * emission, 0.7F * emission);
    if (textured) material.emissiveTexture.image = 0;
  }
  return scene;
}

class Unlit : public GlTest {};

TEST_F(Unlit, ShowsItsBaseColourAlone) {
  const glm::vec3 wanted =
      over({{0.1F, 0.2F, 0.9F, 0.25F}, {0.6F, 0.1F, 0.3F, 0.5F}}, {0.2F, 0.4F, 0.1F});
  for (const bool textured : {false, true}) {
    for (const char* method : {"ab-sbuffer", "blend", "peel", "kb-fixed"}) {
      Bench bench(emitting(1.0F, textured), linearSettings(method), kSize, device());
      bench.draw();
      const std::vector<float> rgb = bench.linear();
      for (int c = 0; c < 3; ++c) {
        // Base colours of opaque surfaces are bytes.
        EXPECT_NEAR(rgb[static_cast<std::size_t>(c)], wanted[c], 2e-3F)
            << method << ' ' << textured;
      }
    }
  }
}

TEST_F(Unlit, IsPredictedByItsBaseColourAlone) {
  const OitSettings slices{.method = "kb-variable", .fill = true, .importance = Predictor::Error};
  const OitSettings colors{.method = "kb-learned", .kAve = 1.0, .fill = true};
  for (const bool textured : {false, true}) {
    for (const OitSettings& oit : {slices, colors}) {
      passes::RenderSettings settings = settingsOf(oit);
      settings.readBack = true;
      Bench dark(emitting(0.0F, textured), settings, kSize, device());
      Bench bright(emitting(1.0F, textured), settings, kSize, device());
      dark.draw();
      bright.draw();
      EXPECT_EQ(dark.linear(), bright.linear()) << describe(oit);
      if (oit.method == "kb-learned") {
        EXPECT_EQ(dark.floats(passes::kColorSums, 4), bright.floats(passes::kColorSums, 4));
        EXPECT_EQ(dark.floats(passes::kNearestColor, 4), bright.floats(passes::kNearestColor, 4));
      } else {
        EXPECT_EQ(dark.bufferWords(passes::kSliceSums), bright.bufferWords(passes::kSliceSums));
      }
    }
  }
}

}  // namespace
}  // namespace macula::test
