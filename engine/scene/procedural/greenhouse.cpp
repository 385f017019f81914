#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <utility>
#include <vector>

#include "engine/core/random.h"
#include "engine/scene/procedural/depth_counter.h"
#include "engine/scene/procedural/greenhouse_parts.h"
#include "engine/scene/procedural/mesh_builder.h"
#include "engine/scene/procedural/recipes.h"

namespace macula::scene {
namespace {

using namespace greenhouse;

constexpr int kDepthLimit = 106;     // the depth that the scene promises
constexpr int kCountingSize = 1024;  // pixels; the size at which the depth is promised
constexpr float kTanHalfFov = 0.44F;
constexpr float kStep = 0.32F;       // metres from plant to plant along a tier
constexpr int kColumns = 46;         // plants along a tier
constexpr float kFirstPlant = 2.2F;  // z of the nearest
constexpr float kPotHeight = 0.2F;
constexpr float kFootGap = 0.001F;  // between pots and boards, which else would share a plane

/// Pots of clay, and of tinted glass in which the light stands. Roots are at kPotHeight.
std::vector<std::uint32_t> addPotShapes(SceneBuilder& builder) {
  const std::vector<glm::vec2> outline{{0.0F, 0.004F},  {0.08F, 0.0F},   {0.09F, 0.01F},
                                       {0.12F, 0.165F}, {0.135F, 0.17F}, {0.138F, 0.205F},
                                       {0.132F, 0.21F}};
  constexpr float kWall = 0.012F;
  constexpr float kSoil = 0.18F;  // the earth's height, as the thickness of the bottom
  constexpr int kSegments = 14;
  const std::array<Material, 5> materials{
      plainMaterial("clay", {0.52F, 0.22F, 0.11F, 1.0F}, 0.9F),
      plainMaterial("pale clay", {0.56F, 0.40F, 0.28F, 1.0F}, 0.9F),
      glassMaterial("blue pots", {0.08F, 0.20F, 0.62F, 0.42F}),
      glassMaterial("green pots", {0.08F, 0.45F, 0.32F, 0.38F}),
      glassMaterial("amber pots", {0.75F, 0.34F, 0.06F, 0.40F})};
  std::vector<std::uint32_t> shapes;
  for (const Material& material : materials) {
    Primitive mesh;
    addVessel(mesh, outline, kWall, kSoil, kSegments);
    shapes.push_back(builder.shape(std::move(mesh), builder.material(material)));
  }
  return shapes;
}

/// A bell jar, as set over tender plants.
std::uint32_t addJarShape(SceneBuilder& builder) {
  const std::vector<glm::vec2> profile{
      {0.24F, 0.0F},   {0.235F, 0.30F}, {0.215F, 0.45F}, {0.16F, 0.57F}, {0.08F, 0.635F},
      {0.025F, 0.65F}, {0.02F, 0.67F},  {0.035F, 0.69F}, {0.02F, 0.71F}, {0.0F, 0.715F}};
  Primitive mesh;
  addLathe(mesh, profile, 40);
  return builder.shape(std::move(mesh),
                       builder.material(glassMaterial("jars", {0.75F, 0.90F, 0.86F, 0.16F})));
}

/// Sets plants out where the promised depth allows.
class Gardener {
 public:
  Gardener(SceneBuilder& builder, const Camera& camera)
      : builder_(builder), counter_(camera, kTanHalfFov, kCountingSize) {}

  /// Adds a translucent shape if the depth allows. @return whether it was added
  bool set(std::uint32_t shape, const glm::mat4& transform) {
    if (!counter_.addWithin(builder_.mesh(shape), transform, kDepthLimit)) return false;
    builder_.add(shape, transform);
    return true;
  }
  void setOpaque(std::uint32_t shape, const glm::mat4& transform) {
    counter_.occlude(builder_.mesh(shape), transform);
    builder_.add(shape, transform);
  }
  /// Notes what stands already.
  void noteOpaque(const std::vector<std::uint32_t>& shapes) {
    for (const std::uint32_t shape : shapes) {
      counter_.occlude(builder_.mesh(shape), glm::mat4(1.0F));
    }
  }
  void note(const std::vector<std::uint32_t>& shapes) {
    for (const std::uint32_t shape : shapes) {
      counter_.addWithin(builder_.mesh(shape), glm::mat4(1.0F), kDepthLimit);
    }
  }

 private:
  SceneBuilder& builder_;
  DepthCounter counter_;
};

void fillTiers(SceneBuilder& builder, Gardener& gardener, std::uint64_t seed) {
  const std::vector<std::uint32_t> plants = addPlantShapes(builder, seed);
  const std::vector<std::uint32_t> pots = addPotShapes(builder);
  constexpr std::uint32_t kClayPots = 2;  // the first ones; they are opaque
  const std::uint32_t jar = addJarShape(builder);
  Random random(seed, 55);
  const auto any = [&](const std::vector<std::uint32_t>& shapes) {
    return random.below(static_cast<std::uint32_t>(shapes.size()));
  };
  // From front to back: where the promised depth is used up, pots stay empty.
  for (int column = 0; column < kColumns; ++column) {
    for (const Tier& tier : kTiers) {
      for (const float side : {-1.0F, 1.0F}) {
        const float x = side * tier.x + random.range(-0.07F, 0.07F);
        const float z =
            kFirstPlant - kStep * static_cast<float>(column) + random.range(-0.07F, 0.07F);
        const glm::vec3 foot{x, tier.height + kFootGap, z};
        const std::uint32_t pot = any(pots);
        const std::uint32_t plant = any(plants);
        const float turn = random.unit();
        const float scale = random.range(1.15F, 1.7F);
        const bool covered = random.below(9) == 0;
        if (pot < kClayPots) {
          gardener.setOpaque(pots[pot], place(foot, turn));
        } else if (!gardener.set(pots[pot], place(foot, turn))) {
          continue;
        }
        gardener.set(plants[plant], place(foot + glm::vec3(0.0F, kPotHeight, 0.0F), turn, scale));
        if (covered) gardener.set(jar, place(foot, 0.0F, 1.1F));
      }
    }
  }
}

void hangBaskets(SceneBuilder& builder, Gardener& gardener, std::uint64_t seed) {
  const std::vector<std::uint32_t> vines = addHangingShapes(builder, seed);
  Primitive bowl;
  addVessel(bowl,
            std::vector<glm::vec2>{{0.0F, 0.0F}, {0.1F, 0.01F}, {0.16F, 0.07F}, {0.18F, 0.14F}},
            0.012F, 0.09F, 20);
  Primitive cord;
  const std::array<glm::vec3, 2> path{glm::vec3(0.0F), glm::vec3(0.0F, 1.0F, 0.0F)};
  addTube(cord, path, std::array<float, 2>{0.006F, 0.006F}, 5, false);
  const std::uint32_t bowlShape = builder.shape(
      std::move(bowl), builder.material(plainMaterial("baskets", {0.25F, 0.16F, 0.09F, 1}, 0.9F)));
  const std::uint32_t cordShape = builder.shape(
      std::move(cord), builder.material(plainMaterial("cords", {0.30F, 0.27F, 0.22F, 1}, 0.9F)));
  Random random(seed, 56);
  for (int i = 3; i < 2 * kBays - 1; ++i) {  // every half bay
    // The rows alternate; distances from the middle of the aisle.
    const float row = i % 2 == 0 ? 1.35F : 2.3F;
    const float roof = kEaves + (kRidge - kEaves) * (1.0F - row / kHalfWidth);
    for (const float side : {-1.0F, 1.0F}) {
      const float drop = random.range(0.55F, 0.95F);
      const glm::vec3 hung{side * row, roof - drop, kFront - 0.5F * kBay * static_cast<float>(i)};
      gardener.setOpaque(bowlShape, place(hung));
      glm::mat4 stretched = place(hung + glm::vec3(0.0F, 0.1F, 0.0F));
      stretched[1] *= drop - 0.1F;
      gardener.setOpaque(cordShape, stretched);
      gardener.set(
          vines[random.below(static_cast<std::uint32_t>(vines.size()))],
          place(hung + glm::vec3(0.0F, 0.14F, 0.0F), random.unit(), random.range(1.2F, 1.6F)));
    }
  }
}

}  // namespace

Scene makeGreenhouse(std::uint64_t seed) {
  SceneBuilder builder("greenhouse");
  Camera camera;
  camera.name = "scene";
  camera.position = {0.25F, 1.5F, 4.3F};
  camera.target = {0.0F, 1.5F, -1.0F};
  camera.verticalFov = 2.0F * std::atan(kTanHalfFov);
  camera.farPlane = 60.0F;
  builder.camera(camera);
  const Camera view = camera;
  // A small circle in the aisle, so that an orbit looks across to all sides.
  camera.name = "orbit";
  camera.position = {0.0F, 1.6F, -1.6F};
  camera.target = {0.0F, 1.5F, -2.0F};
  builder.camera(camera);

  Gardener gardener(builder, view);
  gardener.noteOpaque(addHouse(builder, seed));
  gardener.note(addPanes(builder, seed));
  hangBaskets(builder, gardener, seed);
  fillTiers(builder, gardener, seed);

  builder.light(sun({-0.45F, -0.8F, -0.3F}, {1.0F, 0.95F, 0.84F}, 3.2F));
  builder.light(pointLight({0.0F, 2.6F, -3.0F}, {1.0F, 0.8F, 0.5F}, 3.0F, 8.0F));
  builder.light(pointLight({0.0F, 2.6F, -9.0F}, {1.0F, 0.8F, 0.5F}, 3.0F, 8.0F));
  builder.light(
      spotLight({0.0F, 3.6F, 2.0F}, {0.0F, 0.8F, -1.0F}, {0.9F, 0.96F, 1.0F}, 6.0F, 0.7F));
  builder.ambient({0.24F, 0.27F, 0.29F});
  return std::move(builder).finish();
}

}  // namespace macula::scene
