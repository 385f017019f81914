// Layers of equal weight, exact by every method that has room for them all.
#include "engine/scene/procedural/recipes.h"
#include "oit_cases.h"

namespace macula::test {
namespace {

class CompleteMethods : public GlTest, public testing::WithParamInterface<int> {};

TEST_P(CompleteMethods, CompositeAllLayers) {
  const int n = GetParam();
  constexpr glm::ivec2 kSize{19, 13};
  const auto fragments = static_cast<std::uint64_t>(n) * 19 * 13;
  const glm::vec3 expected = scene::layersComposite(n);
  const scene::GpuScene gpu(scene::makeLayers(n, 1), nullptr);
  const scene::Camera camera = scene::makeLayers(1, 1).cameras.front();
  float worst = 0.0F;
  for (const passes::OitSettings& oit : completeCases(n)) {
    if (oit.sync == "ordered" && !device().ordered.passed) continue;
    const passes::RenderSettings settings = settingsOf(oit);
    passes::FrameRenderer renderer(settings, device());
    renderer.resize(kSize);
    renderer.setScene(gpu);
    for (int frame = 0; frame < 2; ++frame) {
      const passes::FrameResult result = renderer.render(camera, glm::vec2(0.5F));
      EXPECT_EQ(result.fragments->generated, fragments) << describe(oit);
      EXPECT_EQ(result.fragments->stored, fragments) << describe(oit);
      EXPECT_TRUE(result.exact) << describe(oit);
      EXPECT_EQ(result.deepest, static_cast<std::uint32_t>(n)) << describe(oit);
    }
    std::vector<float> rgb;
    renderer.readLinear(rgb);
    for (std::size_t i = 0; i < rgb.size(); ++i) {
      const float difference = std::abs(rgb[i] - expected[static_cast<int>(i % 3)]);
      ASSERT_LT(difference, 1e-3F) << describe(oit);
      worst = std::max(worst, difference);
    }
  }
  note("largest difference", worst);
}

INSTANTIATE_TEST_SUITE_P(Depths, CompleteMethods, testing::Values(1, 2, 16, 17, 64, 130));

}  // namespace
}  // namespace macula::test
