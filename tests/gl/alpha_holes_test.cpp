// Fragments whose alpha is 0 are not there: for every method a card with holes is what the pieces
// between them would be, and all passes agree on which fragments there are.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "engine/scene/gltf_loader.h"
#include "oit_cases.h"

namespace macula::test {
namespace {

using passes::Cull;
using passes::OitSettings;
using passes::Predictor;
using passes::Tail;

constexpr int kTexels = 8;       // a side of a card's image
constexpr int kTexelPixels = 6;  // a side of a texel in the image of the frame
constexpr int kSide = kTexels * kTexelPixels;
constexpr int kCards = 15;
constexpr int kSolidEvery = 5;  // so many cards to one that is solid at a texel
constexpr float kAlpha = 0.5F;

/// Whether a card is solid at a texel, counted from the lower left of the frame.
bool isSolid(int card, int x, int y) {
  return (card + x + 2 * y) % kSolidEvery == 0;
}

float distanceOf(int card) {
  return 2.0F + 0.5F * static_cast<float>(card);
}

/// Half of what the camera of emptyScene() sees at a distance.
float halfSideAt(float distance) {
  return distance * std::tan(0.5F * scene::Camera{}.verticalFov);
}

scene::Material cardMaterial(int card) {
  scene::Material material;
  material.unlit = true;
  material.doubleSided = true;
  material.metallic = 0.0F;
  material.baseColor = variedColor(card + 1, kAlpha);
  material.alphaMode = scene::AlphaMode::Blend;
  return material;
}

/// Adds texels of a card, from..to in both directions, as two triangles.
void addQuad(scene::Primitive& mesh, float distance, glm::ivec2 from, glm::ivec2 to) {
  const float half = halfSideAt(distance);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const glm::ivec2 c : {from, glm::ivec2(to.x, from.y), glm::ivec2(from.x, to.y), to}) {
    const glm::vec2 uv = glm::vec2(c) / static_cast<float>(kTexels);
    mesh.positions.emplace_back((2.0F * uv - 1.0F) * half, -distance);
    mesh.attributes.emplace_back();
    mesh.attributes.back().uv0 = uv;
  }
  for (const std::uint32_t i : {0U, 1U, 2U, 2U, 1U, 3U}) mesh.indices.push_back(first + i);
}

void addInstance(scene::Scene& scene, scene::Primitive mesh) {
  scene.instances.push_back({static_cast<std::uint32_t>(scene.primitives.size()), glm::mat4(1)});
  scene.primitives.push_back(std::move(mesh));
}

void addBackground(scene::Scene& scene) {
  addRectangle(scene, 20.0F, glm::vec2(-30.0F), glm::vec2(30.0F), {0.2F, 0.4F, 0.8F, 1.0F}, true);
}

/// Cards that fill the view, solid or clear by the alpha of their images.
scene::Scene cards() {
  scene::Scene scene = emptyScene();
  for (int card = 0; card < kCards; ++card) {
    scene::Image image;
    image.width = image.height = kTexels;
    for (int y = 0; y < kTexels; ++y) {
      for (int x = 0; x < kTexels; ++x) {
        image.rgba.insert(image.rgba.end(), {255, 255, 255});
        image.rgba.push_back(isSolid(card, x, y) ? 255 : 0);
      }
    }
    scene::Primitive mesh;
    mesh.material = card;
    scene.materials.push_back(cardMaterial(card));
    scene::TextureRef& texture = scene.materials.back().baseColorTexture;
    texture.image = card;
    texture.sampler.nearest = true;
    texture.sampler.mipmaps = false;
    scene.images.push_back(std::move(image));
    addQuad(mesh, distanceOf(card), {0, 0}, {kTexels, kTexels});
    addInstance(scene, std::move(mesh));
  }
  addBackground(scene);
  return scene;
}

/// The same with no image: only what is solid, as geometry.
scene::Scene pieces() {
  scene::Scene scene = emptyScene();
  for (int card = 0; card < kCards; ++card) {
    scene::Primitive mesh;
    mesh.material = card;
    scene.materials.push_back(cardMaterial(card));
    for (int y = 0; y < kTexels; ++y) {
      for (int x = 0; x < kTexels; ++x) {
        if (isSolid(card, x, y)) addQuad(mesh, distanceOf(card), {x, y}, {x + 1, y + 1});
      }
    }
    addInstance(scene, std::move(mesh));
  }
  addBackground(scene);
  return scene;
}

constexpr std::uint64_t kSolidFragments = std::uint64_t{kSide} * kSide * kCards / kSolidEvery;

/// What a pixel shows, computed here. Rows from the top, as the frame is read.
glm::vec3 expectedAt(int x, int row) {
  const int texelX = x / kTexelPixels;
  const int texelY = (kSide - 1 - row) / kTexelPixels;
  std::vector<glm::vec4> nearestFirst;
  for (int card = 0; card < kCards; ++card) {
    if (isSolid(card, texelX, texelY)) nearestFirst.push_back(cardMaterial(card).baseColor);
  }
  return over(nearestFirst, {0.2F, 0.4F, 0.8F});
}

/// One of each way to insert, given room for so many a pixel. Fewer than completeCases(): each
/// compiles shaders of its own.
std::vector<OitSettings> insertionsWithRoom(int layers) {
  const double k = layers;
  return {{.method = "ab-list"},
          {.method = "ab-sbuffer"},
          {.method = "ab-array", .layers = layers},
          {.method = "peel", .layers = layers},
          {.method = "kb-racy", .kAve = k},
          {.method = "kb-atomic", .kAve = k},
          {.method = "kb-fixed", .kAve = k, .sync = "spinlock"},
          {.method = "kb-plus", .kAve = k, .fill = true, .fragmentBytes = 8},
          {.method = "kb-variable", .kAve = k, .fill = true, .tail = Tail::Mean}};
}

TEST_F(GlTest, HolesTakeNoSlot) {
  const scene::Scene scene = cards();
  for (const OitSettings& oit : insertionsWithRoom(kCards / kSolidEvery)) {
    Bench bench(scene, settingsOf(oit), {kSide, kSide}, device());
    const passes::FrameResult result = bench.draw();
    EXPECT_EQ(result.fragments->generated, kSolidFragments) << describe(oit);
    EXPECT_EQ(result.fragments->stored, kSolidFragments) << describe(oit);
    const std::vector<float> image = bench.linear();
    // Halves hold 11 bits; packed alphas 8, of three layers.
    const float tolerance = oit.fragmentBytes == 8 ? 6e-3F : 2e-3F;
    float largest = 0.0F;
    for (int row = 0; row < kSide; ++row) {
      for (int x = 0; x < kSide; ++x) {
        const glm::vec3 expected = expectedAt(x, row);
        for (int c = 0; c < 3; ++c) {
          const float shown = image[static_cast<std::size_t>(3 * (row * kSide + x) + c)];
          largest = std::max(largest, std::abs(shown - expected[c]));
        }
      }
    }
    EXPECT_LE(largest, tolerance) << describe(oit);
  }
}

/// Options under which not everything is kept, so that holes would change who is.
std::vector<OitSettings> crowdedCases() {
  constexpr double kAve = 1.5;
  std::vector<OitSettings> all;
  for (const int bytes : {16, 8}) {
    all.push_back({.method = "kb-fixed", .kAve = 2, .tail = Tail::Mean, .fragmentBytes = bytes});
    all.push_back({.method = "kb-plus", .kAve = kAve, .fragmentBytes = bytes});
    all.push_back({.method = "kb-variable", .kAve = kAve, .fragmentBytes = bytes});
    for (const Predictor predictor : {Predictor::Transmittance, Predictor::Error}) {
      all.push_back({.method = "kb-variable",
                     .kAve = kAve,
                     .fill = true,
                     .tail = Tail::Mean,
                     .importance = predictor,
                     .fragmentBytes = bytes});
    }
    all.push_back(learnedUtility(kAve, bytes));
    all.push_back({.method = "kb-learned", .kAve = kAve, .fragmentBytes = bytes});
  }
  all.push_back({.method = "blend"});
  all.push_back({.method = "wboit"});
  all.push_back({.method = "peel", .layers = 2});
  all.push_back({.method = "ab-array", .layers = 2});
  all.push_back({.method = "kb-atomic", .kAve = 2});
  all.push_back({.method = "kb-atomic", .kAve = 3, .tail = Tail::Mean});
  all.push_back({.method = "kb-fixed", .kAve = 1, .sync = "spinlock"});
  all.push_back({.method = "kb-fixed", .kAve = 1, .cull = Cull::Occupancy});
  all.push_back({.method = "kb-variable", .kAve = kAve, .cull = Cull::Occupancy});
  all.push_back({.method = "kb-variable",
                 .kAve = kAve,
                 .fill = true,
                 .count = passes::CountSource::Predicted});
  return all;
}

TEST_F(GlTest, CardsWithHolesAreAsTheirPieces) {
  const scene::Scene whole = cards();
  const scene::Scene cut = pieces();
  std::vector<OitSettings> all = crowdedCases();
  const auto& samples = device().capabilities.routableSamples;
  if (!samples.empty()) {
    const int least = *std::min_element(samples.begin(), samples.end());
    all.push_back({.method = "kb-stencil", .kAve = static_cast<double>(least)});
  }
  for (const OitSettings& oit : all) {
    Bench holed(whole, settingsOf(oit), {kSide, kSide}, device());
    Bench plain(cut, settingsOf(oit), {kSide, kSide}, device());
    for (int i = 0; i < 2; ++i) {  // the second one has a history
      const passes::FrameResult a = holed.draw();
      const passes::FrameResult b = plain.draw();
      EXPECT_EQ(countUnlike(holed.linear(), plain.linear()), 0U) << describe(oit) << " frame " << i;
      ASSERT_EQ(a.fragments.has_value(), b.fragments.has_value());
      if (!a.fragments) continue;
      EXPECT_EQ(a.fragments->generated, kSolidFragments) << describe(oit);
      EXPECT_EQ(b.fragments->generated, kSolidFragments) << describe(oit);
      EXPECT_EQ(a.fragments->stored, b.fragments->stored) << describe(oit);
      EXPECT_EQ(a.fragments->merged, b.fragments->merged) << describe(oit);
    }
  }
}

/// Tilted lit cards under filtered images with round holes, near enough to be magnified and far
/// enough for mip levels.
scene::Scene tiltedCards() {
  scene::Scene scene = emptyScene();
  constexpr int kImage = 32;
  scene::Image image;
  image.width = image.height = kImage;
  for (int i = 0; i < kImage * kImage; ++i) {
    const glm::ivec2 p(i % 8 - 4, i / kImage % 8 - 4);
    const bool hole = p.x * p.x + p.y * p.y < 10;
    image.rgba.insert(image.rgba.end(), {200, 255, 150});
    image.rgba.push_back(hole ? 0 : 180);
  }
  scene.images.push_back(std::move(image));
  for (int card = 0; card < 12; ++card) {
    scene::Primitive mesh;
    mesh.material = card;
    scene.materials.push_back(cardMaterial(card));
    scene::Material& material = scene.materials.back();
    material.unlit = card % 3 == 0;
    material.baseColorTexture.image = 0;
    addQuad(mesh, 2.0F, {0, 0}, {kTexels, kTexels});
    for (std::size_t i = 0; i < 4; ++i) {
      glm::vec3& p = mesh.positions[i];
      p.z -= 0.4F * static_cast<float>(card) + (i % 2 == 0 ? 0.0F : 6.0F) + p.y;
      mesh.attributes[i].uv0 *= static_cast<float>(1 + card % 4);
      // Corners without alpha, and a card that lets light through where its image is.
      if (card % 4 == 1) mesh.attributes[i].color.a = i == 0 ? 0.0F : 1.0F;
    }
    if (card % 5 == 2) {
      material.transmission = 0.8F;
      material.alphaMode = card == 2 ? scene::AlphaMode::Mask : scene::AlphaMode::Blend;
      material.alphaCutoff = 0.2F;
    }
    addInstance(scene, std::move(mesh));
  }
  addBackground(scene);
  scene::addDefaultLights(scene);
  return scene;
}

TEST_F(GlTest, AllPassesAgreeOnFilteredHoles) {
  constexpr glm::ivec2 kSize{96, 72};
  const scene::Scene scene = tiltedCards();
  Bench exact(scene, linearSettings("ab-sbuffer"), kSize, device());
  const passes::FrameResult reference = exact.draw();
  EXPECT_TRUE(reference.exact);
  EXPECT_EQ(reference.fragments->stored, reference.fragments->generated);
  EXPECT_GT(reference.deepest, 8U);
  EXPECT_LE(reference.deepest, 12U);
  // The ranges are those of the count pass, the fill is the capture's.
  const auto ranges = exact.words(passes::kFragmentRange, 2);
  const auto fill = exact.words(passes::kFragmentFill, 1);
  std::size_t unlike = 0;
  for (std::size_t p = 0; p < fill.size(); ++p) unlike += ranges[2 * p + 1] == fill[p] ? 0U : 1U;
  EXPECT_EQ(unlike, 0U);
  const std::vector<float> image = exact.linear();
  for (const OitSettings& oit : insertionsWithRoom(12)) {
    Bench bench(scene, settingsOf(oit), kSize, device());
    const passes::FrameResult result = bench.draw();
    EXPECT_EQ(result.fragments->generated, reference.fragments->generated) << describe(oit);
    EXPECT_EQ(result.fragments->stored, reference.fragments->generated) << describe(oit);
    // Packed alphas hold 8 bits, of up to twelve layers.
    const float tolerance = oit.fragmentBytes == 8 ? 2e-2F : 4e-3F;
    EXPECT_LE(largestDifference(bench.linear(), image), tolerance) << describe(oit);
  }
}

TEST_F(GlTest, WhatIsAllHoleIsNotDrawn) {
  std::vector<Sheet> list;
  for (int i = 0; i < 6; ++i) {
    list.push_back({.distance = 2.0F + static_cast<float>(i), .color = variedColor(i, 0.5F)});
  }
  const Sheet wall{.distance = 9.0F, .color = {0.0F, 0.0F, 1.0F, 1.0F}, .opaque = true};
  list.push_back(wall);
  scene::Scene scene = sheets(list);
  for (const std::size_t i : {0U, 2U}) scene.materials[i].baseColor.a = 0.0F;
  // Of one sheet a triangle, of another both, by their corners.
  for (const std::size_t corner : {0U, 1U, 2U}) scene.primitives[1].attributes[corner].color.a = 0;
  for (auto& vertex : scene.primitives[3].attributes) vertex.color.a = 0;
  const scene::Scene left = sheets({list[1], list[4], list[5], wall});
  Bench bench(scene, linearSettings("kb-fixed", 3), {16, 16}, device());
  Bench reference(left, linearSettings("ab-sbuffer"), {16, 16}, device());
  const std::uint64_t generated = bench.draw().fragments->generated;
  EXPECT_LT(generated, 3U * 16U * 16U) << "a triangle is missing";
  EXPECT_GT(generated, 2U * 16U * 16U) << "the other one is there";
  reference.draw();
  // The half view in which all corners have alpha.
  for (auto& vertex : scene.primitives[1].attributes) vertex.color.a = 1;
  Bench restored(scene, linearSettings("kb-fixed", 3), {16, 16}, device());
  EXPECT_EQ(restored.draw().fragments->generated, 3U * 16U * 16U);
  EXPECT_LE(largestDifference(restored.linear(), reference.linear()), 2e-3F);
  for (scene::Material& material : scene.materials) {
    if (material.isTransparent()) material.baseColor.a = 0.0F;
  }
  Bench nothing(scene, linearSettings("kb-fixed", 3), {16, 16}, device());
  EXPECT_EQ(nothing.draw().fragments->generated, 0U);
  EXPECT_EQ(nothing.gpu.facts().transparentTriangles, 0U);
  EXPECT_EQ(nothing.linear().at(2), 1.0F);
}

const std::filesystem::path kCases =
    std::filesystem::path(MACULA_SOURCE_DIR) / "../shared/data/cases/alpha-zero";

TEST_F(GlTest, CardsOfTheSharedCaseShowBothVisibleLayers) {
  if (!std::filesystem::exists(kCases)) GTEST_SKIP() << kCases << " is absent; nothing compared";
  const scene::Scene scene = scene::loadGltf(kCases / "cards.gltf");
  for (const char* method :
       {"kb-racy", "kb-atomic", "kb-fixed", "kb-plus", "kb-variable", "kb-learned", "peel"}) {
    OitSettings oit{.method = method, .kAve = 2, .layers = 2};
    // Importance alone may leave a pixel one slot.
    oit.fill = oit.method == "kb-variable" || oit.method == "kb-learned";
    Bench bench(scene, settingsOf(oit), {200, 200}, device());
    bench.draw();
    const std::vector<float> image = bench.linear();
    const std::size_t middle = 3 * (100 * 200 + 100);
    EXPECT_NEAR(image[middle], 0.5F, 1e-3F) << method;
    EXPECT_NEAR(image[middle + 1], 0.25F, 1e-3F) << method;
    EXPECT_NEAR(image[middle + 2], 0.25F, 1e-3F) << method;
  }
}

/// Root mean squared error of linear values against the exact image.
double errorOf(const scene::Scene& scene, const OitSettings& oit, passes::DeviceContext& device) {
  constexpr glm::ivec2 kSize{128, 128};
  Bench exact(scene, linearSettings("ab-sbuffer"), kSize, device);
  Bench bench(scene, settingsOf(oit), kSize, device);
  exact.draw();
  bench.draw();
  const std::vector<float> a = exact.linear();
  const std::vector<float> b = bench.linear();
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    sum += difference * difference;
  }
  return std::sqrt(sum / static_cast<double>(a.size()));
}

TEST_F(GlTest, LeavesOfTheSharedCaseAreAsNearAsDiscs) {
  if (!std::filesystem::exists(kCases)) GTEST_SKIP() << kCases << " is absent; nothing compared";
  const scene::Scene leaves = scene::loadGltf(kCases / "leaf_cards.gltf");
  const scene::Scene discs = scene::loadGltf(kCases / "leaf_discs.gltf");
  for (const double kAve : {4.0, 1.0}) {
    const OitSettings plain{.method = "kb-variable", .kAve = kAve};
    OitSettings best{.method = "kb-variable", .kAve = kAve, .fill = true, .tail = Tail::Mean};
    best.importance = Predictor::Error;
    for (const OitSettings& oit : {plain, best}) {
      const double error = errorOf(leaves, oit, device());
      note(describe(oit), error);
      EXPECT_LE(error, 1.1 * errorOf(discs, oit, device()) + 1e-4) << describe(oit);
    }
  }
}

}  // namespace
}  // namespace macula::test
