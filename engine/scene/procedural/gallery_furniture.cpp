#include <array>
#include <utility>
#include <vector>

#include "engine/scene/procedural/circle.h"
#include "engine/scene/procedural/gallery_parts.h"
#include "engine/scene/procedural/mesh_builder.h"
#include "engine/scene/procedural/textures.h"

namespace macula::scene::gallery {
namespace {

/// A bench along x with a slatted seat and two leather cushions, 1.8 m long.
Model benchModel(SceneBuilder& builder, const Palette& palette) {
  Primitive wood;
  for (const float x : {-0.75F, 0.75F}) {
    for (const float z : {-0.2F, 0.2F}) {
      addBevelledBox(wood, {x - 0.04F, 0.0F, z - 0.04F}, {x + 0.04F, 0.40F, z + 0.04F}, 0.008F);
    }
    addBevelledBox(wood, {x - 0.03F, 0.12F, -0.2F}, {x + 0.03F, 0.17F, 0.2F}, 0.006F);
  }
  addBevelledBox(wood, {-0.75F, 0.13F, -0.02F}, {0.75F, 0.16F, 0.02F}, 0.006F);
  for (int i = 0; i < 6; ++i) {
    const float z = -0.24F + 0.096F * static_cast<float>(i);
    addBevelledBox(wood, {-0.9F, 0.385F, z - 0.04F}, {0.9F, 0.42F, z + 0.04F}, 0.008F);
  }
  Primitive cushions;
  for (const float x : {-0.44F, 0.44F}) {
    addBevelledBox(cushions, {x - 0.42F, 0.421F, -0.26F}, {x + 0.42F, 0.50F, 0.26F}, 0.025F);
    for (const float button : {-0.2F, 0.2F}) {
      addSphere(cushions, {x + button, 0.5F, 0.0F}, 0.014F, 12);
    }
  }
  return {builder.shape(std::move(wood), palette.wood),
          builder.shape(std::move(cushions), palette.leather)};
}

/// A plinth of stone, `height` metres high and 0.56 m wide.
std::uint32_t plinthShape(SceneBuilder& builder, const Palette& palette, float height) {
  Primitive mesh;
  addBevelledBox(mesh, {-0.32F, 0.0F, -0.32F}, {0.32F, 0.10F, 0.32F}, 0.012F);
  addBevelledBox(mesh, {-0.27F, 0.09F, -0.27F}, {0.27F, height - 0.07F, 0.27F}, 0.01F);
  addBevelledBox(mesh, {-0.31F, height - 0.08F, -0.31F}, {0.31F, height, 0.31F}, 0.012F);
  return builder.shape(std::move(mesh), palette.stone);
}

void addSculptures(SceneBuilder& builder, const Palette& palette) {
  const std::uint32_t plinth = plinthShape(builder, palette, 0.95F);
  const std::int32_t marble =
      builder.material(plainMaterial("white marble", {0.86F, 0.84F, 0.80F, 1.0F}, 0.35F));
  constexpr int kSteps = 384;
  constexpr int kSides = 28;
  const auto knot = [&](int p, int q, float radius, float tube, std::int32_t material) {
    Primitive lying;
    addTorusKnot(lying, p, q, radius, tube, kSteps, kSides);
    // Stood on its edge: a quarter turn about x.
    const glm::mat4 upright{{1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}, {0, 0, 0, 1}};
    Primitive mesh;
    append(mesh, lying, upright);
    return builder.shape(std::move(mesh), material);
  };
  const std::uint32_t bronzeKnot = knot(2, 3, 0.27F, 0.062F, palette.bronze);
  const std::uint32_t marbleKnot = knot(3, 5, 0.26F, 0.045F, marble);
  // The knot's reach is radius * 1.4 + tube; it sinks a little into its plinth.
  const auto set = [&](std::uint32_t shape, const glm::vec3& at, float turns) {
    builder.add(plinth, place(at));
    builder.add(shape, place(at + glm::vec3(0.0F, 1.37F, 0.0F), turns));
  };
  set(bronzeKnot, {-3.1F, 0.0F, 6.0F}, 0.08F);
  set(marbleKnot, {3.0F, 0.0F, -3.4F}, 0.92F);
  set(bronzeKnot, {-2.7F, 0.0F, -9.2F}, 0.1F);
  set(marbleKnot, {2.7F, 0.0F, -9.2F}, 0.9F);

  // A stack of turned discs that narrows upwards.
  std::vector<glm::vec2> profile{{0.0F, 0.0F}};
  for (int i = 0; i < 9; ++i) {
    const float foot = 0.085F * static_cast<float>(i);
    const float reach = 0.24F * (1.0F - 0.07F * static_cast<float>(i));
    for (int k = 0; k <= 8; ++k) {
      const glm::vec2 turned = onCircle(0.5 * k / 8.0);
      profile.emplace_back(0.07F + (reach - 0.07F) * turned.y, foot + 0.0425F * (1.0F - turned.x));
    }
  }
  profile.emplace_back(0.0F, 0.77F);
  Primitive totem;
  addLathe(totem, profile, 64);
  builder.add(plinth, place({3.1F, 0.0F, 3.4F}));
  builder.addOnce(std::move(totem), palette.bronze, place({3.1F, 0.95F, 3.4F}));
}

/// A gilt frame around a canvas in the xy plane that faces +z, its middle at the origin.
void addPainting(SceneBuilder& builder, const Palette& palette, std::int32_t canvas,
                 const glm::vec2& half, const glm::mat4& transform) {
  constexpr float kFrame = 0.11F;
  Primitive frame;
  const auto bar = [&](const glm::vec2& low, const glm::vec2& high) {
    addBevelledBox(frame, {low.x, low.y, 0.0F}, {high.x, high.y, 0.07F}, 0.02F);
  };
  const glm::vec2 out = half + kFrame;
  bar({-out.x, half.y}, {out.x, out.y});
  bar({-out.x, -out.y}, {out.x, -half.y});
  bar({-out.x, -half.y}, {-half.x, half.y});
  bar({half.x, -half.y}, {out.x, half.y});
  builder.addOnce(std::move(frame), palette.brass, transform);
  Primitive picture;
  addQuad(picture, {-half.x, -half.y, 0.03F}, {half.x, -half.y, 0.03F}, {half.x, half.y, 0.03F},
          {-half.x, half.y, 0.03F});
  builder.addOnce(std::move(picture), canvas, transform);
}

void addPaintings(SceneBuilder& builder, const Palette& palette, std::uint64_t seed) {
  constexpr int kMotifs = 6;
  std::array<std::int32_t, kMotifs> canvases{};
  for (int i = 0; i < kMotifs; ++i) {
    Material material = plainMaterial("canvas " + std::to_string(i + 1), glm::vec4(1.0F), 0.8F);
    const auto motif = static_cast<std::uint64_t>(i) + 1;
    material.baseColorTexture.image = builder.image(painting(256, seed * kMotifs + motif));
    canvases[static_cast<std::size_t>(i)] = builder.material(material);
  }
  constexpr float kToRight = 0.25F;  // turns: faces +x, into the hall
  for (int i = 0; i < 5; ++i) {
    const float z = -8.0F + kBay * static_cast<float>(i);
    const glm::vec2 half = i % 2 == 0 ? glm::vec2(1.05F, 0.75F) : glm::vec2(0.7F, 0.95F);
    addPainting(builder, palette, canvases[static_cast<std::size_t>(i)], half,
                place({-kHalfWidth + 0.005F, 2.45F, z}, kToRight));
  }
  addPainting(builder, palette, canvases[kMotifs - 1], {1.7F, 1.05F},
              place({0.0F, 2.7F, -kHalfLength + 0.005F}));
}

/// A ring of twelve lit bulbs in glass globes on a rod; its origin is the middle of the ring.
Model chandelierModel(SceneBuilder& builder, const Palette& palette) {
  constexpr int kBulbs = 12;
  constexpr float kRing = 0.75F;
  Primitive metal;
  Primitive bulbs;
  Primitive globes;
  std::vector<glm::vec3> ring;
  for (int i = 0; i < 72; ++i) {
    const glm::vec2 turned = onCircle(i / 72.0);
    ring.emplace_back(kRing * turned.x, 0.0F, -kRing * turned.y);
  }
  addTube(metal, ring, std::vector<float>(ring.size(), 0.022F), 12, true);
  const std::array<glm::vec3, 2> rod{glm::vec3(0.0F, 0.45F, 0.0F), glm::vec3(0.0F, 1.4F, 0.0F)};
  addTube(metal, rod, std::array{0.018F, 0.018F}, 12, false);
  addSphere(metal, {0.0F, 0.45F, 0.0F}, 0.09F, 24);
  for (int i = 0; i < kBulbs; ++i) {
    const glm::vec2 turned = onCircle(static_cast<double>(i) / kBulbs);
    const glm::vec3 at{kRing * turned.x, 0.0F, -kRing * turned.y};
    const std::array<glm::vec3, 2> stay{at, glm::vec3(0.0F, 0.45F, 0.0F)};
    if (i % 3 == 0) addTube(metal, stay, std::array{0.008F, 0.008F}, 8, false);
    addSphere(bulbs, at + glm::vec3(0.0F, 0.075F, 0.0F), 0.035F, 16);
    addSphere(globes, at + glm::vec3(0.0F, 0.085F, 0.0F), 0.085F, 20);
  }
  Material bulb = plainMaterial("bulb", {1.0F, 0.9F, 0.7F, 1.0F}, 0.5F);
  bulb.emissive = {6.0F, 4.4F, 2.6F};
  const std::int32_t globe = builder.material(glassMaterial("globe", {0.95F, 0.90F, 0.80F, 0.18F}));
  return {builder.shape(std::move(metal), palette.brass),
          builder.shape(std::move(bulbs), builder.material(bulb)),
          builder.shape(std::move(globes), globe)};
}

}  // namespace

void addFurniture(SceneBuilder& builder, const Palette& palette, std::uint64_t seed) {
  const Model bench = benchModel(builder, palette);
  constexpr float kSideways = 0.25F;
  builder.add(bench, place({2.35F, 0.0F, 6.3F}, kSideways));
  builder.add(bench, place({-2.3F, 0.0F, 3.7F}, kSideways));
  builder.add(bench, place({-5.3F, 0.0F, 4.0F}, kSideways));
  builder.add(bench, place({-5.3F, 0.0F, -4.0F}, kSideways));
  builder.add(bench, place({0.0F, 0.0F, -9.0F}));
  addSculptures(builder, palette);
  addPaintings(builder, palette, seed);
  const Model chandelier = chandelierModel(builder, palette);
  builder.add(chandelier, place({0.0F, 4.45F, 4.0F}));
  builder.add(chandelier, place({0.0F, 4.45F, -6.0F}));
}

}  // namespace macula::scene::gallery
