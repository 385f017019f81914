// Depths that are equal, that cross, that meet opaque surfaces, and that are very many.
#include <gmock/gmock.h>

#include <algorithm>

#include "engine/scene/procedural/recipes.h"
#include "oit_cases.h"

namespace macula::test {
namespace {

using passes::OitSettings;
using passes::Tail;

constexpr glm::ivec2 kSize{24, 16};
constexpr std::uint64_t kPixels = 24 * 16;

/// Colours are stored as half floats of 11 bits, and so is the image.
constexpr float kHalfSteps = 3e-3F;

void expectEvenly(const std::vector<float>& rgb, glm::vec3 expected, const std::string& what) {
  float worst = 0.0F;
  for (std::size_t i = 0; i < rgb.size(); ++i) {
    worst = std::max(worst, std::abs(rgb[i] - expected[static_cast<int>(i % 3)]));
  }
  EXPECT_LT(worst, kHalfSteps) << what;
}

class Depths : public GlTest {};

TEST_F(Depths, EqualOnesAllCountAndTheLowestIdsAreKept) {
  constexpr int kSheets = 12;
  std::vector<Sheet> list;
  std::vector<glm::vec4> colors;
  for (int i = 0; i < kSheets; ++i) {
    colors.push_back(variedColor(i + 1, 0.2F));
    list.push_back({3.0F, colors.back()});
  }
  const scene::Scene scene = sheets(list);
  for (const OitSettings& oit : completeCases(kSheets)) {
    Bench bench(scene, settingsOf(oit), kSize, device());
    const passes::FrameResult result = bench.draw();
    EXPECT_EQ(result.fragments->generated, kSheets * kPixels) << describe(oit);
    EXPECT_EQ(result.fragments->stored, kSheets * kPixels) << describe(oit);
    EXPECT_TRUE(result.exact) << describe(oit);
    expectEvenly(bench.linear(), over(colors, {}), describe(oit));
  }
  constexpr int kKept = 5;
  const std::vector<glm::vec4> kept(colors.begin(), colors.begin() + kKept);
  for (const OitSettings& oit :
       {OitSettings{.method = "kb-fixed", .kAve = kKept},
        OitSettings{.method = "kb-fixed", .kAve = kKept, .sync = "spinlock"},
        OitSettings{.method = "kb-atomic", .kAve = kKept},
        OitSettings{.method = "kb-plus", .kAve = kKept},
        OitSettings{.method = "kb-plus", .kAve = kKept, .fill = true},
        OitSettings{.method = "peel", .layers = kKept}}) {
    for (const bool reversed : {false, true}) {
      Bench bench(scene, settingsOf(oit), kSize, device(), {.reversed = reversed});
      const passes::FrameResult result = bench.draw();
      EXPECT_EQ(result.fragments->stored, kKept * kPixels) << describe(oit);
      EXPECT_EQ(result.fragments->lost, (kSheets - kKept) * kPixels) << describe(oit);
      EXPECT_FALSE(result.exact) << describe(oit);
      expectEvenly(bench.linear(), over(kept, {}), describe(oit));
    }
  }
}

TEST_F(Depths, ThatCrossAreSortedInEachPixel) {
  const glm::vec4 red(1.0F, 0.0F, 0.0F, 0.6F);
  const glm::vec4 blue(0.0F, 0.0F, 1.0F, 0.6F);
  const scene::Scene scene = sheets({{2.0F, red, 0.5F}, {2.0F, blue, -0.5F}});
  const glm::vec3 redFirst = over({red, blue}, {});
  const glm::vec3 blueFirst = over({blue, red}, {});
  for (const OitSettings& oit : completeCases(2)) {
    Bench bench(scene, settingsOf(oit), kSize, device());
    EXPECT_EQ(bench.draw().fragments->stored, 2 * kPixels) << describe(oit);
    const std::vector<float> rgb = bench.linear();
    for (std::size_t p = 0; p < kPixels; ++p) {
      const bool left = p % static_cast<std::size_t>(kSize.x) < 12;
      // To the left the red sheet comes nearer, to the right the blue one.
      const glm::vec3 expected = left ? redFirst : blueFirst;
      EXPECT_NEAR(rgb[3 * p], expected.r, kHalfSteps) << describe(oit) << " pixel " << p;
      EXPECT_NEAR(rgb[3 * p + 2], expected.b, kHalfSteps) << describe(oit) << " pixel " << p;
    }
  }
}

TEST_F(Depths, BehindInFrontOfAndTouchingAnOpaqueSurface) {
  const glm::vec4 front = variedColor(1, 0.4F);
  const glm::vec4 touching = variedColor(2, 0.4F);
  const glm::vec4 wall(0.3F, 0.6F, 0.9F, 1.0F);
  // A fragment at the very depth of the opaque surface passes: the test is "not behind".
  const scene::Scene scene = sheets({{1.0F, front},
                                     {2.0F, touching},
                                     {2.0F, wall, 0.0F, 0.0F, true},
                                     {3.0F, variedColor(3, 0.9F)}});
  const glm::vec3 expected = over({front, touching}, wall);
  for (const OitSettings& oit : completeCases(4)) {
    Bench bench(scene, settingsOf(oit), kSize, device());
    const passes::FrameResult result = bench.draw();
    EXPECT_EQ(result.fragments->generated, 2 * kPixels) << describe(oit);
    EXPECT_EQ(result.fragments->stored, 2 * kPixels) << describe(oit);
    EXPECT_EQ(result.deepest, 2U) << describe(oit);
    // The wall's base colour is kept in 8 bits.
    EXPECT_LT(largestDifference(bench.linear(),
                                [&] {
                                  std::vector<float> even;
                                  for (std::size_t p = 0; p < kPixels; ++p) {
                                    even.insert(even.end(), {expected.r, expected.g, expected.b});
                                  }
                                  return even;
                                }()),
              6e-3F)
        << describe(oit);
  }
}

TEST_F(Depths, ManyLayersKeepTheNearestAndCountTheRest) {
  constexpr int kLayers = 256;
  constexpr int kSlots = 32;
  const scene::Scene scene = scene::makeLayers(kLayers, 1);
  std::vector<glm::vec4> nearest;
  for (int i = 1; i <= kSlots; ++i) {
    nearest.emplace_back(scene::layerColor(i, kLayers), scene::layerAlpha(i, kLayers));
  }
  for (const OitSettings& oit :
       {OitSettings{.method = "kb-fixed", .kAve = kSlots},
        OitSettings{.method = "kb-fixed", .kAve = kSlots, .sync = "spinlock"},
        OitSettings{.method = "kb-atomic", .kAve = kSlots},
        OitSettings{.method = "kb-plus", .kAve = kSlots},
        OitSettings{.method = "kb-plus", .kAve = kSlots, .fill = true},
        OitSettings{.method = "peel", .layers = kSlots}}) {
    Bench bench(scene, settingsOf(oit), kSize, device());
    const passes::FrameResult result = bench.draw();
    EXPECT_EQ(result.fragments->generated, kLayers * kPixels) << describe(oit);
    EXPECT_EQ(result.fragments->stored, kSlots * kPixels) << describe(oit);
    EXPECT_EQ(result.fragments->lost, (kLayers - kSlots) * kPixels) << describe(oit);
    EXPECT_EQ(result.deepest, static_cast<std::uint32_t>(kLayers)) << describe(oit);
    expectEvenly(bench.linear(), over(nearest, {}), describe(oit));
  }
  for (const OitSettings& oit :
       {OitSettings{.method = "kb-fixed", .kAve = kSlots, .tail = Tail::Mean},
        OitSettings{.method = "kb-fixed", .kAve = kSlots, .tail = Tail::Mean, .fragmentBytes = 8},
        OitSettings{.method = "kb-plus", .kAve = kSlots, .fill = true, .tail = Tail::Mean},
        OitSettings{.method = "kb-atomic", .kAve = kSlots, .tail = Tail::Mean}}) {
    passes::RenderSettings settings = settingsOf(oit);
    settings.background = {0.25F, 0.5F, 0.75F};
    Bench bench(scene, settings, kSize, device());
    const passes::FrameResult result = bench.draw();
    const std::uint64_t single = oit.fragmentBytes == 8 ? kSlots - 2 : kSlots - 1;
    EXPECT_EQ(result.fragments->stored, single * kPixels) << describe(oit);
    EXPECT_EQ(result.fragments->merged, (kLayers - single) * kPixels) << describe(oit);
    EXPECT_EQ(result.fragments->lost, 0U) << describe(oit);
    EXPECT_FALSE(result.exact) << describe(oit);
    // The last layer is opaque: none of the background may show through the tail.
    settings.background = {};
    Bench dark(scene, settings, kSize, device());
    dark.draw();
    EXPECT_LT(largestDifference(bench.linear(), dark.linear()), 1e-3F) << describe(oit);
    EXPECT_TRUE(allFinite(bench.linear())) << describe(oit);
  }
}

TEST_F(Depths, OfTheFirstDrawnAreSortedByStencilRouting) {
  if (device().capabilities.routableSamples.empty()) GTEST_SKIP() << "no multisample targets";
  const int k = device().capabilities.routableSamples.front();
  std::vector<Sheet> list;
  for (int i = 0; i < k + 2; ++i) {
    list.push_back({1.0F + static_cast<float>(i * 5 % (k + 3)), variedColor(i + 1, 0.4F)});
  }
  for (const bool reversed : {false, true}) {
    const OitSettings oit{.method = "kb-stencil", .kAve = static_cast<double>(k)};
    Bench bench(sheets(list), settingsOf(oit), kSize, device(), {.reversed = reversed});
    const passes::FrameResult result = bench.draw();
    EXPECT_EQ(result.fragments->stored, static_cast<std::uint64_t>(k) * kPixels);
    EXPECT_EQ(result.fragments->lost, 2 * kPixels);
    EXPECT_FALSE(result.exact);
    std::vector<Sheet> kept(reversed ? list.begin() + 2 : list.begin(),
                            reversed ? list.end() : list.end() - 2);
    std::sort(kept.begin(), kept.end(),
              [](const Sheet& a, const Sheet& b) { return a.distance < b.distance; });
    std::vector<glm::vec4> colors;
    for (const Sheet& sheet : kept) colors.push_back(sheet.color);
    expectEvenly(bench.linear(), over(colors, {}), reversed ? "reversed" : "as given");
  }
}

TEST_F(Depths, BeyondWhatHalfFloatsCount) {
  constexpr int kDeep = 2100;
  constexpr glm::ivec2 kTiny{3, 2};
  const scene::Scene scene = scene::makeLayers(kDeep, 1);
  for (const OitSettings& oit :
       {OitSettings{.method = "ab-list"}, OitSettings{.method = "kb-fixed", .kAve = 8.0},
        OitSettings{.method = "kb-fixed", .kAve = 8.0, .tail = Tail::Mean},
        OitSettings{.method = "kb-atomic", .kAve = 8.0},
        OitSettings{.method = "kb-plus", .kAve = 8.0},
        OitSettings{.method = "kb-variable", .kAve = 8.0, .fill = true, .tail = Tail::Mean},
        OitSettings{.method = "ab-array", .layers = 16}}) {
    Bench bench(scene, settingsOf(oit), kTiny, device());
    const passes::FrameResult result = bench.draw();
    EXPECT_EQ(result.deepest, static_cast<std::uint32_t>(kDeep)) << describe(oit);
    EXPECT_EQ(result.fragments->generated, std::uint64_t{kDeep} * 6) << describe(oit);
    EXPECT_EQ(result.fragments->generated,
              result.fragments->stored + result.fragments->merged + result.fragments->lost);
    EXPECT_TRUE(allFinite(bench.linear())) << describe(oit);
  }
}

}  // namespace
}  // namespace macula::test
