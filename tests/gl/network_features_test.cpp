// What networks see: the features that shaders gather against a CPU mirror, first checked by hand.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <stdexcept>

#include "engine/scene/procedural/recipes.h"
#include "network_mirror.h"
#include "oit_cases.h"
#include "passes/oit/learned/read_features.h"
#include "shared/network.h"

namespace macula::test {
namespace {

using passes::OitSettings;
using testing::DoubleNear;
using testing::ElementsAre;

TEST(NetworkMirror, ThesisFeaturesAsByHand) {
  // Three pixels, one of them empty, far plane at 10 m.
  MirrorFrame frame;
  frame.size = {3, 1};
  frame.farPlane = 10.0;
  frame.pixels = {{{2.0, {0.5, 0.25, 0.0, 0.5}}, {4.0, {0.0, 0.25, 0.5, 0.5}}},
                  {},
                  {{5.0, {0.1, 0.2, 0.3, 0.4}}}};
  frame.behind.resize(3);
  const auto features = thesisFeatures(frame, 2);
  // 3 fragments: shares 2/3 and 1/3 of them, times 2 covered pixels; 2 of 3 slots.
  EXPECT_THAT(features[0], ElementsAre(DoubleNear(4.0 / 3.0, 1e-12), DoubleNear(2.0 / 3.0, 1e-12),
                                       0.2, 0.4, 0.2, 0.5, 0.25, 0.25, 0.25, 0.5, 0.25, 0.0));
  EXPECT_THAT(features[1], testing::Each(0.0));
  EXPECT_THAT(features[2], ElementsAre(DoubleNear(2.0 / 3.0, 1e-12), DoubleNear(2.0 / 3.0, 1e-12),
                                       0.5, 0.5, 0.2, 0.5, 0.1, 0.2, 0.3, 0.1, 0.2, 0.3));
}

TEST(NetworkMirror, LearnedFeaturesAsByHand) {
  // A red and a green layer, each halving what passes, in the first and the last slice; blue
  // behind.
  const MirrorSlices slices =
      slicesOf({{1.0, {0.5, 0.0, 0.0, 0.5}}, {3.0, {0.0, 0.5, 0.0, 0.5}}}, true);
  EXPECT_EQ(slices.nearestBoundary, 1.0);
  const auto x = plainLearnedFeatures(slices, {0.0, 0.0, 1.0});
  EXPECT_EQ(x[0], 2.0);
  // Exact: (1/2, 1/4, 1/4). Both as one layer of their mean: 3/4 (1/2, 1/2, 0) + 1/4 (0, 0, 1) =
  // (0.375, 0.375, 0.25). Square roots: (0.70711, 0.5, 0.5) less (0.61237, 0.61237, 0.5).
  EXPECT_NEAR(x[1], 0.094734 * 0.094734 + 0.112372 * 0.112372, 1e-6);
  for (std::size_t i = 2; i < kPasses; ++i) EXPECT_NEAR(x[i], 0.0, 1e-12) << "nothing is mixed";
  for (std::size_t i = 0; i < LEARNED_SLICES; ++i) {
    const bool first = i == 0;
    const bool last = i == LEARNED_SLICES - 1;
    EXPECT_EQ(x[kPasses + i], last ? 0.25 : 0.5) << i;
    EXPECT_EQ(x[kShares + i], first || last ? 0.5 : 0.0) << i;
    EXPECT_EQ(x[kThickness + i], first || last ? 1.0 : 0.0) << i;
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(x[kColors + 3 * i + c], (first && c == 0) || (last && c == 1) ? 1.0 : 0.0) << i;
    }
  }
  EXPECT_EQ(x[kBehind + 2], 1.0);
}

TEST(NetworkMirror, SlicesAreThinnerTowardsTheEye) {
  // Of the way from 1 m to 2 m, a quarter becomes 0.5 / 1.25 = 0.4: the fourth of eight slices.
  const MirrorSlices slices =
      slicesOf({{1.0, {0, 0, 0, 0.5}}, {1.25, {0, 0, 0, 0.75}}, {2.0, {0, 0, 0, 0.5}}}, false);
  EXPECT_EQ(slices.slices[0].tau, 1.0);
  EXPECT_EQ(slices.slices[3].tau, 2.0);
  EXPECT_EQ(slices.slices[7].fragments, 1.0);
  EXPECT_NEAR(slices.nearestBoundary, 0.2, 1e-12);
}

passes::RenderSettings readBack(passes::RenderSettings settings) {
  settings.readBack = true;
  return settings;
}

/// One view, drawn by all fragments, by none, and for a network.
class View {
 public:
  View(const scene::Scene& scene, const OitSettings& oit, glm::ivec2 size,
       passes::DeviceContext& device)
      : exact_(scene, linearSettings("ab-sbuffer"), size, device),
        opaque_(scene, linearSettings("ab-sbuffer"), size, device),
        seen_(scene, readBack(settingsOf(oit)), size, device) {
    opaque_.renderer.showTransparency(false);
    for (Bench* bench : {&exact_, &opaque_, &seen_}) bench->draw();
    frame = frameOf(exact_, opaque_);
    features = passes::readFeatures(seen_.renderer, opaque_.renderer, device.programs);
  }
  [[nodiscard]] std::uint64_t slots() const { return seen_.renderer.plan().slots; }

  MirrorFrame frame;
  std::vector<float> features;

 private:
  Bench exact_, opaque_, seen_;
};

class Features : public GlTest {
 protected:
  static std::vector<scene::Scene> scenes() {
    return {unlit(scene::makeLayers(5, 1)), unlit(scene::makeMedley(2)), unlit(tangle(240, 5))};
  }
};

/// Lit models, some double-sided, some mirrored. @param textured with a white texture, which
/// changes nothing but where their colours are found: at fragments, not at vertices
scene::Scene turnedModels(bool textured) {
  scene::Scene scene = scene::makeMedley(1);
  // From one side, so that the two sides of a surface differ.
  scene.lights = {{.type = scene::LightType::Directional,
                   .intensity = 10.0F,
                   .direction = {-0.6F, 0.0F, -0.8F}}};
  for (scene::Primitive& primitive : scene.primitives) {
    for (scene::VertexAttributes& vertex : primitive.attributes) vertex.color = glm::vec4(1.0F);
  }
  for (std::size_t i = 0; i < scene.instances.size(); i += 2) {
    glm::mat4& transform = scene.instances[i].transform;
    transform = glm::scale(transform, glm::vec3(-1.0F, 1.0F, 1.0F));
  }
  const auto image = static_cast<std::int32_t>(scene.images.size());
  if (textured) {
    scene.images.push_back(
        {.name = "white", .width = 1, .height = 1, .rgba = {255, 255, 255, 255}});
  }
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    scene.materials[i].doubleSided = i % 3 != 0;
    scene.materials[i].unlit = false;
    scene.materials[i].metallic = 0.0F;
    scene.materials[i].baseColorTexture.image = textured ? image : scene::kNone;
  }
  return scene;
}

TEST_F(Features, AreTheSameFromVerticesAsFromFragments) {
  const glm::ivec2 size(64, 48);
  for (const OitSettings& way :
       {OitSettings{.method = "kb-learned", .kAve = 3.0}, learnedUtility(3.0)}) {
    const View plain(turnedModels(false), way, size, device());
    const View textured(turnedModels(true), way, size, device());
    ASSERT_EQ(plain.features.size(), textured.features.size());
    const std::size_t features = plain.features.size() / 64 / 48;
    std::size_t covered = 0;
    for (std::size_t i = 0; i < plain.features.size(); ++i) {
      if (plain.features[i / features * features] > 0.0F) ++covered;
      // Interpolated light times a colour, or interpolated products: they round apart, and
      // logarithms of errors of some millionths tell.
      ASSERT_NEAR(plain.features[i], textured.features[i], 0.02)
          << describe(way) << " feature " << i % features << " of pixel " << i / features;
    }
    EXPECT_GT(covered, plain.features.size() / 10);
  }
}

TEST_F(Features, OfTheThesisAsByHand) {
  const View view(sheets({{5.0F, {0.0F, 0.5F, 1.0F, 0.25F}}, {2.0F, {1.0F, 0.5F, 0.25F, 0.5F}}}),
                  {.method = "kb-learned", .kAve = 3.0}, {8, 6}, device());
  ASSERT_EQ(view.features.size(), 8U * 6U * THESIS_FEATURES);
  EXPECT_DOUBLE_EQ(view.frame.farPlane, 50.0);
  // Every pixel has the two; 3 of 2 slots; 2 and 5 of 50 m.
  const std::array<double, 12> expected{1.0,  1.5,    0.04,   0.1, 0.04, 0.1,
                                        0.25, 0.1875, 0.1875, 0.5, 0.25, 0.125};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(view.features[i], expected[i], i < 9 ? 1e-5 : 0.51 / 255.0) << "feature " << i;
  }
}

TEST_F(Features, OfTheThesisEqualTheMirror) {
  for (const scene::Scene& scene : scenes()) {
    const View view(scene, {.method = "kb-learned", .kAve = 2.0}, {64, 64}, device());
    const auto mirror = thesisFeatures(view.frame, view.slots());
    ASSERT_EQ(view.features.size(), 12 * mirror.size());
    std::size_t covered = 0;
    std::size_t unsure = 0;
    for (std::size_t p = 0; p < mirror.size(); ++p) {
      const auto& fragments = view.frame.pixels[p];
      covered += fragments.empty() ? 0U : 1U;
      // The colour takes the last 8 of a depth's 24 bits: which of such neighbours is the nearest
      // is not told.
      const bool close = fragments.size() > 1 &&
                         fragments[1].distance < fragments[0].distance * (1.0 + 1.0 / 32768.0);
      unsure += close ? 1U : 0U;
      for (std::size_t i = 0; i < 12; ++i) {
        if (i >= 9 && close) continue;
        // Depths and counts in single precision; colours of the mirror are half floats, those
        // summed have steps of 1/4096, that of the nearest has 8 bits.
        const double tolerance = i < 6 ? 1e-5 : i < 9 ? 1e-3 : 0.5 / 255.0 + 1e-3;
        const double expected = i < 9 ? mirror[p][i] : std::min(mirror[p][i], 1.0);
        ASSERT_NEAR(view.features[12 * p + i], expected, tolerance * std::max(1.0, expected))
            << scene.name << " pixel " << p << " feature " << i;
      }
    }
    EXPECT_GT(covered, 800U) << scene.name;
    EXPECT_LT(unsure, covered / 50) << scene.name;
  }
}

/// Largest difference of each kind of feature from the mirror's.
struct LearnedDifference {
  std::size_t compared = 0;
  std::size_t unsure = 0;  ///< pixels with a fragment at the boundary of two slices
  std::size_t beyond = 0;  ///< values off by more than the tolerance
  double largest = 0.0;
};

LearnedDifference differenceOf(const View& view, const std::vector<glm::vec4>& colors,
                               double tolerance) {
  LearnedDifference d;
  for (std::size_t p = 0; p < view.frame.pixels.size(); ++p) {
    auto fragments = view.frame.pixels[p];
    const float* first = view.features.data() + LEARNED_FEATURES * p;
    if (fragments.empty()) {
      EXPECT_TRUE(std::all_of(first, first + LEARNED_FEATURES, [](float x) { return x == 0.0F; }));
      continue;
    }
    // The true colour in place of the half float that was stored.
    for (MirrorFragment& fragment : fragments) {
      for (const glm::vec4& color : colors) {
        const glm::dvec4 premultiplied(glm::dvec3(color) * static_cast<double>(color.a), color.a);
        if (glm::length(premultiplied - fragment.color) < 2e-3) fragment.color = premultiplied;
      }
    }
    const MirrorSlices slices = slicesOf(fragments, true);
    // Distances in single precision: an error of 1e-6 of a few metres, over the pixel's depth.
    const double depth = fragments.back().distance - fragments.front().distance;
    if (slices.nearestBoundary < 1e-4 + 1e-5 * fragments.back().distance / std::max(depth, 1e-9) &&
        fragments.size() > 1) {
      ++d.unsure;
      continue;
    }
    const auto expected = plainLearnedFeatures(slices, view.frame.behind[p]);
    const auto found = plainOf(first);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const double off = std::abs(found[i] - expected[i]) / std::max(1.0, expected[i]);
      ++d.compared;
      d.beyond += off <= tolerance ? 0U : 1U;  // NaN is beyond
      d.largest = std::max(d.largest, off);
    }
  }
  return d;
}

TEST_F(Features, OfMaculaAsByHand) {
  // The red and the green layer of the mirror's test, before white.
  const View view(sheets({{2.0F, {1.0F, 0.0F, 0.0F, 0.5F}},
                          {6.0F, {0.0F, 1.0F, 0.0F, 0.5F}},
                          {9.0F, {1.0F, 1.0F, 1.0F, 1.0F}, 0.0F, 0.0F, true}}),
                  learnedUtility(2.0), {8, 6}, device());
  const auto x = plainOf(view.features.data());
  EXPECT_NEAR(x[0], 2.0, 1e-6);
  // Exact (3/4, 1/2, 1/4); as one layer 3/4 (1/2, 1/2, 0) + 1/4 = (0.625, 0.625, 0.25); their
  // square roots (0.866025, 0.707107, 0.5) and (0.790569, 0.790569, 0.5).
  EXPECT_NEAR(x[1], 0.075456 * 0.075456 + 0.083462 * 0.083462, 1e-5);
  EXPECT_NEAR(x[2], 0.0, 1e-6);
  constexpr std::size_t kLast = LEARNED_SLICES - 1;
  EXPECT_NEAR(x[kPasses], 0.5, 1e-6);
  EXPECT_NEAR(x[kPasses + kLast], 0.25, 1e-6);
  EXPECT_NEAR(x[kShares + kLast], 0.5, 1e-6);
  EXPECT_NEAR(x[kThickness], 1.0, 1e-6);
  EXPECT_NEAR(x[kColors], 1.0, 1e-6);
  EXPECT_NEAR(x[kColors + 3 * kLast + 1], 1.0, 1e-6);
  for (std::size_t i = kBehind; i < x.size(); ++i) EXPECT_NEAR(x[i], 1.0, 2e-3) << "white";
}

TEST_F(Features, OfMaculaEqualTheMirrorWhereColoursAreKnown) {
  std::vector<Sheet> list;
  std::vector<glm::vec4> colors;
  // Tilted, so that order and slices differ from pixel to pixel.
  for (int i = 0; i < 9; ++i) {
    const float step = static_cast<float>(i);
    colors.push_back(variedColor(i + 3, 0.15F + 0.09F * step));
    list.push_back({2.0F + 0.7F * step, colors.back(), i % 2 == 0 ? 0.3F : -0.2F});
  }
  list.push_back({16.0F, {0.5F, 0.6F, 0.7F, 1.0F}, 0.0F, 0.0F, true});
  const View view(sheets(list), learnedUtility(2.0), {64, 48}, device());
  // Slices hold steps of 1/1024, and rounding goes the other way where a value lies between two:
  // for the thinnest sheet, of optical depth 0.23, 0.4 % of its colour.
  constexpr double kTolerance = 5e-3;
  const LearnedDifference d = differenceOf(view, colors, kTolerance);
  EXPECT_EQ(d.beyond, 0U) << "largest " << d.largest;
  EXPECT_GT(d.compared, 32U * 64U * 48U * 9U / 10U);
  EXPECT_LT(d.unsure, 64U * 48U / 20U);
  note("largest difference", d.largest);
}

TEST_F(Features, OfMaculaEqualTheMirror) {
  for (const scene::Scene& scene : scenes()) {
    const View view(scene, learnedUtility(2.0), {64, 64}, device());
    // The mirror's colours are half floats here, so that sums are rounded to another step of
    // 1/1024: of a slice of optical depth 0.05, 2 % of its colour.
    constexpr double kTolerance = 0.02;
    const LearnedDifference d = differenceOf(view, {}, kTolerance);
    EXPECT_GT(d.compared, 32U * 800U) << scene.name;
    EXPECT_EQ(d.beyond, 0U) << scene.name << ", largest " << d.largest;
    EXPECT_LT(d.unsure, view.frame.pixels.size() / 20) << scene.name;
    note(scene.name + ": largest difference", d.largest);
  }
}

TEST_F(Features, AreThoseOfPixelsWhateverTheTile) {
  const scene::Scene scene = unlit(tangle(240, 5));
  for (const OitSettings& oit : {OitSettings{.method = "kb-learned"}, learnedUtility(4.0)}) {
    passes::RenderSettings settings = readBack(settingsOf(oit));
    Bench one(scene, settings, {47, 33}, device());
    settings.importance.networkTile = 4;
    Bench four(scene, settings, {47, 33}, device());
    Bench opaque(scene, linearSettings("ab-sbuffer"), {47, 33}, device());
    opaque.renderer.showTransparency(false);
    for (Bench* bench : {&one, &four, &opaque}) bench->draw();
    EXPECT_EQ(passes::readFeatures(one.renderer, opaque.renderer, device().programs),
              passes::readFeatures(four.renderer, opaque.renderer, device().programs));
  }
}

TEST_F(Features, OfOtherFramesAreRefused) {
  const scene::Scene scene = unlit(tangle(50, 1));
  passes::RenderSettings atHalfRate = settingsOf({.method = "kb-learned"});
  atHalfRate.lod.resize = 2.0;
  atHalfRate.lod.transparency = true;
  Bench opaque(scene, linearSettings("ab-sbuffer"), {32, 32}, device());
  Bench small(scene, linearSettings("ab-sbuffer"), {16, 32}, device());
  Bench plain(scene, linearSettings("kb-variable"), {32, 32}, device());
  Bench resized(scene, atHalfRate, {32, 32}, device());
  Bench good(scene, settingsOf({.method = "kb-learned"}), {32, 32}, device());
  Bench shared(scene, settingsOf(learnedUtility(2.0)), {32, 32}, device());
  for (Bench* bench : {&opaque, &small, &plain, &resized, &good, &shared}) bench->draw();
  const auto read = [&](Bench& bench, const Bench& behind) {
    static_cast<void>(passes::readFeatures(bench.renderer, behind.renderer, device().programs));
  };
  EXPECT_THROW(read(plain, opaque), std::invalid_argument);
  EXPECT_THROW(read(resized, opaque), std::invalid_argument);
  EXPECT_THROW(read(good, small), std::invalid_argument);
  EXPECT_THROW(read(shared, opaque), std::invalid_argument) << "its slices may be overwritten";
  EXPECT_NO_THROW(read(good, opaque));
}

}  // namespace
}  // namespace macula::test
