// The tail against its CPU mirror, and at the ends of the ranges of alpha and colour.
#include <gmock/gmock.h>

#include <algorithm>

#include "engine/measure/fragment_image.h"
#include "engine/scene/procedural/recipes.h"
#include "oit_cases.h"
#include "passes/oit/statistics/read_fragments.h"
#include "shared/oit_constants.h"

namespace macula::test {
namespace {

using passes::OitSettings;
using passes::Predictor;
using passes::Tail;

class Tails : public GlTest {};

/// Slots of each pixel, as measure::Tail::Mean counts them (one of them for the tail), rows from
/// the top.
std::vector<std::uint32_t> slotsFromTop(const Bench& bench, glm::ivec2 size) {
  const passes::OitPlan& plan = bench.renderer.plan();
  const auto width = static_cast<std::size_t>(size.x);
  std::vector<std::uint32_t> slots(width * static_cast<std::size_t>(size.y));
  // A dense tail comes beside the slots; one of 8-byte fragments takes two of them.
  const std::uint32_t constant = plan.layers + (plan.denseTail() ? 1U : 0U) + 1U - plan.tailSlots();
  std::fill(slots.begin(), slots.end(), constant);
  if (!plan.method->hasRanges()) return slots;
  const auto ranges = bench.words(passes::kFragmentRange, 2);
  for (std::size_t p = 0; p < slots.size(); ++p) {
    const std::size_t fromTop = (slots.size() / width - 1 - p / width) * width + p % width;
    const std::uint32_t range = ranges[2 * p + 1];
    slots[fromTop] = (range & ~RANGE_TAIL) + ((range & RANGE_TAIL) != 0 ? 1U : 0U);
  }
  return slots;
}

TEST_F(Tails, EqualTheirMirror) {
  constexpr glm::ivec2 kSize{72, 56};
  const scene::Scene scene = unlit(tangle(900, 7));
  Bench exact(scene, linearSettings("ab-sbuffer"), kSize, device());
  Bench opaque(scene, linearSettings("ab-sbuffer"), kSize, device());
  opaque.renderer.showTransparency(false);
  exact.draw();
  opaque.draw();
  const measure::FragmentImage fragments = passes::readFragments(exact.renderer, opaque.renderer);
  ASSERT_NO_THROW(measure::requireConsistent(fragments));
  std::vector<OitSettings> cases{
      {.method = "kb-fixed", .kAve = 3.0, .tail = Tail::Mean},
      {.method = "kb-fixed", .kAve = 1.0, .tail = Tail::Mean},
      {.method = "kb-fixed", .kAve = 3.0, .sync = "spinlock", .tail = Tail::Mean},
      {.method = "kb-plus", .kAve = 2.0, .fill = true, .tail = Tail::Mean},
      {.method = "kb-plus", .kAve = 2.0, .tail = Tail::Mean},
      {.method = "kb-atomic", .kAve = 3.0, .tail = Tail::Mean}};
  for (const double kAve : {1.0, 2.0, 5.0}) {
    for (const Predictor importance :
         {Predictor::Published, Predictor::Transmittance, Predictor::Error}) {
      cases.push_back({.method = "kb-variable",
                       .kAve = kAve,
                       .fill = true,
                       .tail = Tail::Mean,
                       .importance = importance});
    }
  }
  float worst = 0.0F;
  for (const OitSettings& oit : cases) {
    Bench bench(scene, settingsOf(oit), kSize, device());
    const passes::FrameResult result = bench.draw();
    EXPECT_GT(result.fragments->merged, fragments.pixels()) << "tails take part";
    const auto slots = slotsFromTop(bench, kSize);
    std::vector<float> mirror;
    for (std::size_t p = 0; p < fragments.pixels(); ++p) {
      const glm::vec3 c = measure::composite(fragments, p, slots[p], measure::Tail::Mean);
      mirror.insert(mirror.end(), {c.r, c.g, c.b});
    }
    const float difference = largestDifference(bench.linear(), mirror);
    EXPECT_LT(difference, 2e-3F) << describe(oit);
    worst = std::max(worst, difference);
  }
  note("cases", static_cast<double>(cases.size()));
  note("largest difference", worst);
}

/// Every way to draw, with so few slots that most layers are left out.
std::vector<OitSettings> scarceCases() {
  std::vector<OitSettings> all{{.method = "blend"},
                               {.method = "wboit"},
                               {.method = "peel", .layers = 2},
                               {.method = "ab-sbuffer"},
                               {.method = "ab-list"},
                               {.method = "ab-array", .layers = 2},
                               {.method = "kb-atomic", .kAve = 2.0},
                               {.method = "kb-atomic", .kAve = 2.0, .tail = Tail::Mean}};
  for (const OitSettings& oit : sortedCases(2.0)) {
    if (oit.sync == "spinlock") all.push_back(oit);
  }
  return all;
}

constexpr glm::ivec2 kTiny{8, 6};
constexpr int kLayers = 256;

std::vector<Sheet> stack(float alpha, float brightness) {
  std::vector<Sheet> list;
  for (int i = 0; i < kLayers; ++i) {
    // Brightness grows along the stack, up to the given.
    list.push_back({1.0F + 0.02F * static_cast<float>(i), variedColor(i, alpha), 0.0F,
                    brightness * static_cast<float>(i + 1) / kLayers});
  }
  return list;
}

TEST_F(Tails, EmptyLayersChangeNothing) {
  const scene::Scene scene = sheets(stack(0.0F, 1e4F));
  for (const OitSettings& oit : scarceCases()) {
    passes::RenderSettings settings = settingsOf(oit);
    settings.background = {0.25F, 0.5F, 0.75F};
    Bench bench(scene, settings, kTiny, device());
    bench.draw();
    const std::vector<float> rgb = bench.linear();
    for (std::size_t i = 0; i < rgb.size(); ++i) {
      ASSERT_EQ(rgb[i], settings.background[static_cast<int>(i % 3)]) << describe(oit);
    }
  }
}

TEST_F(Tails, LeaveEmptyLayersOut) {
  std::vector<Sheet> mixed = stack(0.05F, 0.0F);
  std::vector<Sheet> solid;
  for (std::size_t i = 0; i < mixed.size(); ++i) {
    if (i % 2 == 0) mixed[i].color.a = 0.0F;
    if (i % 2 == 1) solid.push_back(mixed[i]);
  }
  // One slot, or two of 8 bytes: everything is in the tail.
  for (const OitSettings& oit :
       {OitSettings{.method = "kb-fixed", .kAve = 1.0, .tail = Tail::Mean},
        OitSettings{.method = "kb-fixed", .kAve = 2.0, .tail = Tail::Mean, .fragmentBytes = 8},
        OitSettings{.method = "kb-plus", .kAve = 1.0, .fill = true, .tail = Tail::Mean}}) {
    Bench all(sheets(mixed), settingsOf(oit), kTiny, device());
    Bench some(sheets(solid), settingsOf(oit), kTiny, device());
    all.draw();
    some.draw();
    EXPECT_EQ(countUnlike(all.linear(), some.linear()), 0U) << describe(oit);
  }
}

TEST_F(Tails, StayFiniteWithOpaqueAndBrightLayers) {
  int images = 0;
  for (const float alpha : {1.0F, 0.999F, 0.5F, 0.004F}) {
    for (const float brightness : {0.0F, 1e4F, 1e6F}) {
      const scene::GpuScene gpu(sheets(stack(alpha, brightness)), nullptr);
      for (const OitSettings& oit : scarceCases()) {
        const passes::RenderSettings settings = settingsOf(oit);
        passes::FrameRenderer renderer(settings, device());
        renderer.resize(kTiny);
        renderer.setScene(gpu);
        renderer.render(scene::Camera{}, glm::vec2(0.5F));
        std::vector<float> rgb;
        renderer.readLinear(rgb);
        EXPECT_TRUE(allFinite(rgb)) << describe(oit) << " alpha " << alpha << " " << brightness;
        EXPECT_GE(*std::min_element(rgb.begin(), rgb.end()), 0.0F) << describe(oit);
        ++images;
      }
    }
  }
  note("images", images);
}

TEST_F(Tails, CountAsSlotsInTheHeatMap) {
  // Eight layers and four slots for each pixel, one of them the tail: k is the same everywhere.
  const scene::Scene scene = scene::makeLayers(8, 1);
  passes::RenderSettings settings = settingsOf({.method = "kb-plus", .kAve = 4.0, .fill = true});
  settings.heatmap.map = "k";
  settings.heatmap.range = 8.0;
  Bench bare(scene, settings, kTiny, device());
  settings.oit.tail = Tail::Mean;
  Bench tailed(scene, settings, kTiny, device());
  settings.heatmap.range = 4.0;
  Bench hottest(scene, settings, kTiny, device());
  bare.draw();
  EXPECT_EQ(tailed.draw().layers->mean, 4.0);
  hottest.draw();
  EXPECT_EQ(tailed.shown(), bare.shown());
  EXPECT_NE(tailed.shown(), hottest.shown()) << "four of eight is not the end of the scale";
}

TEST_F(Tails, AreNoBrighterOrDarkerThanTheirLayers) {
  // One slot, or two of 8 bytes: nothing but the tail.
  std::vector<OitSettings> tails{
      {.method = "kb-fixed", .kAve = 1.0, .tail = Tail::Mean},
      {.method = "kb-fixed", .kAve = 2.0, .tail = Tail::Mean, .fragmentBytes = 8},
      {.method = "kb-plus", .kAve = 1.0, .fill = true, .tail = Tail::Mean},
      {.method = "kb-variable", .kAve = 1.0, .fill = true, .tail = Tail::Mean},
      {.method = "kb-variable", .kAve = 2.0, .fill = true, .tail = Tail::Mean, .fragmentBytes = 8}};
  for (const float alpha : {1.0F, 0.5F}) {
    for (const float brightness : {0.0F, 1e4F}) {
      std::vector<Sheet> list = stack(alpha, brightness);
      list.erase(list.begin(), list.begin() + kLayers / 2);  // brightness from half on
      glm::vec3 least(1e9F);
      glm::vec3 most(0.0F);
      for (const Sheet& sheet : list) {
        least = glm::min(least, glm::vec3(sheet.color) + sheet.brightness);
        most = glm::max(most, glm::vec3(sheet.color) + sheet.brightness);
      }
      const scene::Scene scene = sheets(list);
      for (const OitSettings& oit : tails) {
        Bench bench(scene, settingsOf(oit), kTiny, device());
        const passes::FrameResult result = bench.draw();
        EXPECT_EQ(result.fragments->merged, result.fragments->generated) << describe(oit);
        // Shared exponents hold nine bits of the brightest channel.
        const float step = (oit.fragmentBytes == 8 ? 1.0F / 256 : 1.0F / 1024) * most.r + 1e-3F;
        const std::vector<float> rgb = bench.linear();
        for (std::size_t i = 0; i < rgb.size(); ++i) {
          const int c = static_cast<int>(i % 3);
          ASSERT_GE(rgb[i], least[c] - step) << describe(oit) << " alpha " << alpha;
          ASSERT_LE(rgb[i], most[c] + step) << describe(oit) << " alpha " << alpha;
        }
      }
    }
  }
}

}  // namespace
}  // namespace macula::test
