#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "engine/scene/procedural/gallery_parts.h"
#include "engine/scene/procedural/in_ball.h"
#include "engine/scene/procedural/leaf.h"
#include "engine/scene/procedural/mesh_builder.h"
#include "engine/scene/procedural/textures.h"

namespace macula::scene::gallery {
namespace {

/// A clay pot filled with earth, 0.5 m high.
Model potModel(SceneBuilder& builder, const Palette& palette) {
  const std::vector<glm::vec2> outline{{0.0F, 0.02F},   {0.19F, 0.0F},  {0.21F, 0.03F},
                                       {0.27F, 0.38F},  {0.28F, 0.42F}, {0.305F, 0.43F},
                                       {0.31F, 0.495F}, {0.30F, 0.505F}};
  Primitive pot;
  addVessel(pot, outline, 0.03F, 0.35F, 48);
  Primitive earth;
  const std::vector<glm::vec2> soil{{0.262F, 0.44F}, {0.12F, 0.46F}, {0.0F, 0.465F}};
  addLathe(earth, soil, 32);
  return {builder.shape(std::move(pot), palette.pottery),
          builder.shape(std::move(earth), builder.material(plainMaterial(
                                              "earth", {0.06F, 0.04F, 0.03F, 1.0F}, 1.0F)))};
}

/// Feathered fronds cut out by an image (alpha MASK) on a short trunk.
Model palmModel(SceneBuilder& builder, std::int32_t fronds, std::int32_t bark, Random& random) {
  constexpr int kFronds = 26;
  Primitive leaves;
  Primitive trunk;
  constexpr float kTrunk = 1.25F;
  std::vector<glm::vec3> path;
  std::vector<float> radii;
  for (int i = 0; i <= 14; ++i) {
    const float t = static_cast<float>(i) / 14.0F;
    path.emplace_back(0.05F * t * t, 0.42F + (kTrunk - 0.42F) * t, 0.0F);
    radii.push_back((i % 2 == 0 ? 0.055F : 0.045F) * (1.2F - 0.4F * t));
  }
  addTube(trunk, path, radii, 16, false);
  for (int i = 0; i < kFronds; ++i) {
    const float t = static_cast<float>(i) / kFronds;
    Leaf leaf{};
    leaf.turns = 0.381966F * static_cast<float>(i) + random.range(-0.02F, 0.02F);  // golden angle
    leaf.length = random.range(0.85F, 1.1F) * (1.05F - 0.35F * t);
    leaf.rise = 0.35F + 1.7F * t;
    leaf.droop = 0.85F + 0.25F * t + random.range(0.0F, 0.15F);
    leaf.width = random.range(0.36F, 0.44F);
    leaf.foot = path.back() + glm::vec3(0.0F, 0.05F * t, 0.0F);
    const float tone = random.range(0.68F, 1.0F);
    addLeaf(leaves, leaf, 12, {tone, tone, 0.9F * tone, 1.0F}, [](float) { return 1.0F; });
  }
  return {builder.shape(std::move(leaves), fronds), builder.shape(std::move(trunk), bark)};
}

/// Broad leaves that let light through (alpha BLEND).
std::uint32_t broadLeafShape(SceneBuilder& builder, std::int32_t material, Random& random) {
  constexpr int kLeaves = 34;
  Primitive mesh;
  for (int i = 0; i < kLeaves; ++i) {
    const float t = static_cast<float>(i) / kLeaves;
    Leaf leaf{};
    leaf.turns = 0.381966F * static_cast<float>(i) + random.range(-0.03F, 0.03F);
    leaf.length = random.range(0.5F, 0.75F);
    leaf.rise = 0.5F + 2.2F * t;
    leaf.droop = 0.9F + 0.5F * t;
    leaf.width = random.range(0.20F, 0.27F);
    leaf.foot = {0.0F, 0.45F + 0.45F * t, 0.0F};
    const float tone = random.range(0.6F, 1.0F);
    addLeaf(mesh, leaf, 14, {tone, tone, tone, 1.0F}, [](float s) {
      // A stalk over the first fifth, then a lens.
      if (s < 0.2F) return 0.06F;
      const float along = (s - 0.2F) / 0.8F;
      return 0.06F +
             3.76F * along * (1.0F - along) * (1.0F - 0.3F * along) * (1.0F - s * s * s * s);
    });
  }
  return builder.shape(std::move(mesh), material);
}

void addPlants(SceneBuilder& builder, const Palette& palette, std::uint64_t seed) {
  Random random(seed, 21);
  Material frondMaterial = plainMaterial("fronds", glm::vec4(1.0F), 0.7F);
  frondMaterial.alphaMode = AlphaMode::Mask;
  frondMaterial.doubleSided = true;
  frondMaterial.baseColorTexture.image = builder.image(frond(256, seed));
  frondMaterial.baseColorTexture.sampler.wrapS = Sampler::Wrap::ClampToEdge;
  frondMaterial.baseColorTexture.sampler.wrapT = Sampler::Wrap::ClampToEdge;
  const std::int32_t fronds = builder.material(frondMaterial);
  const std::int32_t bark =
      builder.material(plainMaterial("bark", {0.20F, 0.13F, 0.08F, 1.0F}, 0.95F));
  Material thin = plainMaterial("broad leaves", {0.115F, 0.39F, 0.105F, 0.80F}, 0.45F);
  thin.doubleSided = true;
  const std::int32_t leaves = builder.material(thin);

  const Model pot = potModel(builder, palette);
  const std::array<Model, 2> palms{palmModel(builder, fronds, bark, random),
                                   palmModel(builder, fronds, bark, random)};
  const std::array<std::uint32_t, 2> broad{broadLeafShape(builder, leaves, random),
                                           broadLeafShape(builder, leaves, random)};
  const std::array<glm::vec3, 6> palmPlaces{
      glm::vec3(5.2F, 0.0F, 2.0F),  glm::vec3(-5.2F, 0.0F, 6.4F),   glm::vec3(-5.2F, 0.0F, -2.0F),
      glm::vec3(5.2F, 0.0F, -6.0F), glm::vec3(-3.4F, 0.0F, -10.2F), glm::vec3(3.4F, 0.0F, -10.2F)};
  for (std::size_t i = 0; i < palmPlaces.size(); ++i) {
    builder.add(pot, place(palmPlaces[i]));
    builder.add(palms[i % 2], place(palmPlaces[i], random.unit(), random.range(0.95F, 1.2F)));
  }
  const std::array<glm::vec3, 6> broadPlaces{
      glm::vec3(3.5F, 0.0F, 7.7F),   glm::vec3(-3.3F, 0.0F, -0.1F), glm::vec3(3.3F, 0.0F, -1.5F),
      glm::vec3(-3.4F, 0.0F, -5.3F), glm::vec3(3.4F, 0.0F, -5.3F),  glm::vec3(5.25F, 0.0F, 5.9F)};
  for (std::size_t i = 0; i < broadPlaces.size(); ++i) {
    builder.add(pot, place(broadPlaces[i], 0.0F, 0.85F));
    builder.add(broad[i % 2],
                place(broadPlaces[i] - glm::vec3(0.0F, 0.04F, 0.0F), random.unit(), 1.0F));
  }
}

void addBowl(SceneBuilder& builder, const Palette& palette) {
  const std::vector<glm::vec2> steps{{0.95F, 0.0F},  {0.95F, 0.14F}, {0.93F, 0.16F}, {0.72F, 0.16F},
                                     {0.72F, 0.30F}, {0.70F, 0.32F}, {0.0F, 0.32F}};
  Primitive stone;
  addLathe(stone, steps, 64);
  builder.addOnce(std::move(stone), palette.stone, place(kBowlPlace));
  const std::vector<glm::vec2> outline{{0.0F, 0.34F},  {0.26F, 0.322F}, {0.27F, 0.35F},
                                       {0.12F, 0.42F}, {0.075F, 0.52F}, {0.075F, 0.62F},
                                       {0.14F, 0.70F}, {0.34F, 0.82F},  {0.47F, 0.98F},
                                       {0.50F, 1.02F}, {0.52F, 1.03F},  {0.52F, 1.05F}};
  Primitive bowl;
  addVessel(bowl, outline, 0.03F, 0.42F, 72);
  builder.addOnce(std::move(bowl), palette.bronze, place(kBowlPlace));

  Material ember = plainMaterial("embers", {0.2F, 0.05F, 0.02F, 1.0F}, 0.9F);
  ember.emissive = {5.0F, 1.3F, 0.18F};
  Primitive coals;
  Random random(3);
  for (int i = 0; i < 30; ++i) {
    const glm::vec3 p = inBall(random) * glm::vec3(0.30F, 0.03F, 0.30F);
    addSphere(coals, p + glm::vec3(0.0F, 0.86F, 0.0F), random.range(0.03F, 0.07F), 12);
  }
  builder.addOnce(std::move(coals), builder.material(ember), place(kBowlPlace));
}

void addSmoke(SceneBuilder& builder, std::uint64_t seed) {
  constexpr int kPuffs = 44;
  constexpr float kFoot = 0.98F;
  constexpr float kRise = 2.9F;
  Random random(seed, 31);
  Primitive mesh;
  for (int i = 0; i < kPuffs; ++i) {
    const float t = (static_cast<float>(i) + random.unit()) / kPuffs;
    const glm::vec3 ball = inBall(random);
    const glm::vec3 lean{-0.35F * t * t, kFoot + kRise * t, 0.25F * t * t};
    const glm::vec3 center = kBowlPlace + lean + ball * (0.10F + 0.32F * t);
    const glm::vec3 axis = inBall(random) * glm::vec3(1.0F, 0.5F, 1.0F) + glm::vec3(0, 0, 0.05F);
    const glm::vec3 color = glm::mix(glm::vec3(0.62F, 0.40F, 0.26F), glm::vec3(0.42F, 0.45F, 0.50F),
                                     std::min(2.5F * t, 1.0F));
    addPuff(mesh, center, glm::normalize(axis + glm::vec3(0.0F, 0.01F, 0.0F)), 0.16F + 0.42F * t,
            color, random.range(0.16F, 0.34F) * (1.15F - 0.6F * t));
  }
  builder.addOnce(std::move(mesh), builder.material(smokeMaterial()));
}

}  // namespace

void addPlantsAndSmoke(SceneBuilder& builder, const Palette& palette, std::uint64_t seed) {
  addPlants(builder, palette, seed);
  addBowl(builder, palette);
  addSmoke(builder, seed);
}

}  // namespace macula::scene::gallery
