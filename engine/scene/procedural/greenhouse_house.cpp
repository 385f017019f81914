#include <algorithm>
#include <array>
#include <utility>

#include "engine/core/random.h"
#include "engine/scene/procedural/greenhouse_parts.h"
#include "engine/scene/procedural/mesh_builder.h"
#include "engine/scene/procedural/textures.h"

namespace macula::scene::greenhouse {
namespace {

constexpr float kBar = 0.03F;      // half the thickness of a bar, metres
constexpr int kBarSegments = 6;    // around a bar
constexpr float kPaneGap = 0.04F;  // between a pane and the middle of its bars
const glm::vec3 kRoofStep{kHalfWidth, kRidge - kEaves, 0.0F};  // from eaves to ridge on the left

using Shapes = std::vector<std::uint32_t>;

/// Adds a shape that stands once, and notes it.
void keep(Shapes& shapes, SceneBuilder& builder, Primitive mesh, std::int32_t material) {
  shapes.push_back(builder.shape(std::move(mesh), material));
  builder.add(shapes.back());
}

float bayEdge(int i) {
  return kFront - kBay * static_cast<float>(i);
}

void addBar(Primitive& mesh, const glm::vec3& a, const glm::vec3& b) {
  const std::array<glm::vec3, 2> path{a, b};
  const std::array<float, 2> radii{kBar, kBar};
  addTube(mesh, path, radii, kBarSegments, false);
}

void addFrame(Shapes& shapes, SceneBuilder& builder) {
  Primitive bars;
  for (int i = 0; i <= kBays; ++i) {
    const float z = bayEdge(i);
    for (const float side : {-1.0F, 1.0F}) {
      const glm::vec3 eaves{side * kHalfWidth, kEaves, z};
      addBar(bars, {side * kHalfWidth, kSill, z}, eaves);
      addBar(bars, eaves, {0.0F, kRidge, z});
    }
    addBar(bars, {-kHalfWidth, kEaves, z}, {kHalfWidth, kEaves, z});  // ties
  }
  for (const float side : {-1.0F, 1.0F}) {
    addBar(bars, {side * kHalfWidth, kEaves, kFront}, {side * kHalfWidth, kEaves, kBack});
    const glm::vec3 middle{side * 0.5F * kHalfWidth, 0.5F * (kEaves + kRidge), 0.0F};
    addBar(bars, middle + glm::vec3(0, 0, kFront), middle + glm::vec3(0, 0, kBack));
  }
  addBar(bars, {0.0F, kRidge, kFront}, {0.0F, kRidge, kBack});
  for (int i = -2; i <= 2; ++i) {
    const float x = 0.4F * kHalfWidth * static_cast<float>(i) * 0.9F;
    addBar(bars, {x, kSill, kBack},
           {x, kRidge - (kRidge - kEaves) * (x < 0 ? -x : x) / kHalfWidth, kBack});
  }
  keep(shapes, builder, std::move(bars),
       builder.material(plainMaterial("bars", {0.78F, 0.80F, 0.78F, 1.0F}, 0.5F)));
}

void addGround(Shapes& shapes, SceneBuilder& builder, std::uint64_t seed) {
  Material tiles = plainMaterial("tiles", {0.72F, 0.60F, 0.50F, 1.0F}, 0.75F);
  tiles.baseColorTexture.image = builder.image(marbleTiles(256, seed));
  Primitive floor;
  addQuad(floor, {-kHalfWidth, 0.0F, kFront}, {kHalfWidth, 0.0F, kFront}, {kHalfWidth, 0.0F, kBack},
          {-kHalfWidth, 0.0F, kBack}, glm::vec2(0.0F),
          glm::vec2(2.0F * kHalfWidth, kFront - kBack));
  keep(shapes, builder, std::move(floor), builder.material(tiles));

  Material brick = plainMaterial("brick", {0.36F, 0.15F, 0.10F, 1.0F}, 0.95F);
  brick.baseColorTexture.image = builder.image(plaster(128, seed));
  constexpr float kThick = 0.12F;
  Primitive base;
  addBox(base, {-kHalfWidth - kThick, 0.0F, kBack}, {-kHalfWidth + kThick, kSill, kFront});
  addBox(base, {kHalfWidth - kThick, 0.0F, kBack}, {kHalfWidth + kThick, kSill, kFront});
  addBox(base, {-kHalfWidth, 0.0F, kBack - kThick}, {kHalfWidth, kSill, kBack + kThick});
  keep(shapes, builder, std::move(base), builder.material(brick));
}

void addBenches(Shapes& shapes, SceneBuilder& builder, std::uint64_t seed) {
  Material wood = plainMaterial("benches", {0.80F, 0.74F, 0.66F, 1.0F}, 0.7F);
  wood.baseColorTexture.image = builder.image(woodBoards(256, seed));
  constexpr float kHalfDepth = 0.3F;  // of a tier, metres
  constexpr float kThick = 0.05F;
  Primitive mesh;
  for (const Tier& tier : kTiers) {
    for (const float side : {-1.0F, 1.0F}) {
      const float low = side * tier.x - kHalfDepth;
      addBevelledBox(mesh, {low, tier.height - kThick, kBack + 0.6F},
                     {low + 2.0F * kHalfDepth, tier.height, kFront - 2.6F}, 0.008F);
      for (int i = 2; i < kBays; ++i) {
        const float x = side * (tier.x - 0.22F);
        addBox(mesh, {x - 0.03F, 0.0F, bayEdge(i) - 0.03F},
               {x + 0.03F, tier.height - kThick, bayEdge(i) + 0.03F});
      }
    }
  }
  keep(shapes, builder, std::move(mesh), builder.material(wood));
}

/// A garden behind a hedge, on all sides at some distance: painted with its own light.
void addGarden(SceneBuilder& builder, std::uint64_t seed) {
  constexpr float kAway = 9.0F;  // metres from the house
  constexpr int kSteps = 120;
  constexpr float kTop = 13.0F;
  const std::array<glm::vec3, 5> corners{
      glm::vec3{-kAway, 0.0F, kFront + kAway}, glm::vec3{-kAway, 0.0F, kBack - kAway},
      glm::vec3{kAway, 0.0F, kBack - kAway}, glm::vec3{kAway, 0.0F, kFront + kAway},
      glm::vec3{-kAway, 0.0F, kFront + kAway}};
  const auto at = [&](int step) {
    const float t = 4.0F * static_cast<float>(step) / kSteps;
    const std::size_t side = std::min<std::size_t>(static_cast<std::size_t>(t), 3);
    return glm::mix(corners[side], corners[side + 1], t - static_cast<float>(side));
  };
  Random random(seed, 53);
  Primitive mesh;
  const auto band = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec2& rangeA,
                        const glm::vec2& rangeB, const glm::vec4& below, const glm::vec4& above) {
    // The ranges hold the heights of the lower and the upper edge.
    const std::size_t first = mesh.positions.size();
    addQuad(mesh, a + glm::vec3(0, rangeA.x, 0), b + glm::vec3(0, rangeB.x, 0),
            b + glm::vec3(0, rangeB.y, 0), a + glm::vec3(0, rangeA.y, 0));
    mesh.attributes[first].color = mesh.attributes[first + 1].color = below;
    mesh.attributes[first + 2].color = mesh.attributes[first + 3].color = above;
  };
  float hedge = 1.8F;
  float hill = 4.0F;
  for (int i = 0; i < kSteps; ++i) {
    const glm::vec3 a = at(i);
    const glm::vec3 b = at(i + 1);
    const float nextHedge = glm::clamp(hedge + random.range(-0.35F, 0.35F), 1.4F, 2.4F);
    const float nextHill = glm::clamp(hill + random.range(-0.4F, 0.4F), 3.0F, 5.2F);
    band(a, b, {-0.2F, hedge}, {-0.2F, nextHedge}, {0.05F, 0.10F, 0.04F, 1.0F},
         {0.13F, 0.26F, 0.09F, 1.0F});
    band(a, b, {hedge, hill}, {nextHedge, nextHill}, {0.30F, 0.42F, 0.34F, 1.0F},
         {0.36F, 0.48F, 0.46F, 1.0F});
    band(a, b, {hill, kTop}, {nextHill, kTop}, {0.80F, 0.86F, 0.88F, 1.0F},
         {0.26F, 0.46F, 0.74F, 1.0F});
    hedge = nextHedge;
    hill = nextHill;
  }
  Material painted;
  painted.name = "garden";
  painted.unlit = true;
  builder.addOnce(std::move(mesh), builder.material(painted));
}

}  // namespace

std::vector<std::uint32_t> addHouse(SceneBuilder& builder, std::uint64_t seed) {
  Shapes shapes;
  addGarden(builder, seed);
  addGround(shapes, builder, seed);
  addFrame(shapes, builder);
  addBenches(shapes, builder, seed);
  return shapes;
}

std::vector<std::uint32_t> addPanes(SceneBuilder& builder, std::uint64_t seed) {
  // Old glass: no two panes quite alike; some are whitewashed against the sun.
  const std::array<glm::vec4, 4> tints{
      glm::vec4{0.62F, 0.80F, 0.76F, 0.14F}, glm::vec4{0.70F, 0.82F, 0.70F, 0.20F},
      glm::vec4{0.60F, 0.74F, 0.86F, 0.17F}, glm::vec4{0.88F, 0.90F, 0.88F, 0.34F}};
  std::array<Primitive, 4> panes;
  Random random(seed, 54);
  const auto pane = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                        const glm::vec3& d) {
    addQuad(panes[random.below(static_cast<std::uint32_t>(panes.size()))], a, b, c, d);
  };
  for (int i = 0; i < kBays; ++i) {
    const float near = bayEdge(i) - kPaneGap;
    const float far = bayEdge(i + 1) + kPaneGap;
    for (const float side : {-1.0F, 1.0F}) {
      const float x = side * kHalfWidth;
      pane({x, kSill, far}, {x, kSill, near}, {x, kEaves, near}, {x, kEaves, far});
      // The roof's panes reach from the eaves to the purlin and from there to the ridge.
      for (const float low : {0.0F, 0.5F}) {
        const glm::vec3 step = kRoofStep * glm::vec3(-side, 1.0F, 1.0F);
        const glm::vec3 foot = glm::vec3(x, kEaves, 0.0F) + step * (low + 0.01F);
        const glm::vec3 head = glm::vec3(x, kEaves, 0.0F) + step * (low + 0.49F);
        const glm::vec3 atNear{0.0F, 0.0F, near};
        const glm::vec3 atFar{0.0F, 0.0F, far};
        pane(foot + atNear, foot + atFar, head + atFar, head + atNear);
      }
    }
  }
  // The far end, and screens that part the beds beside the aisle.
  const auto wall = [&](float z, float x0, float x1, float top) {
    pane({x0, kSill, z}, {x1, kSill, z}, {x1, top, z}, {x0, top, z});
  };
  for (int i = 0; i < 4; ++i) {
    const float x0 = -kHalfWidth + 0.5F * kHalfWidth * static_cast<float>(i);
    wall(kBack, x0, x0 + 0.5F * kHalfWidth, kEaves);
  }
  for (int i = 3; i < kBays; i += 2) {
    wall(bayEdge(i), -kHalfWidth, -0.75F, kEaves);
    wall(bayEdge(i), 0.75F, kHalfWidth, kEaves);
  }
  std::vector<std::uint32_t> shapes;
  for (std::size_t i = 0; i < panes.size(); ++i) {
    const std::int32_t glass =
        builder.material(glassMaterial("pane " + std::to_string(i + 1), tints[i]));
    shapes.push_back(builder.shape(std::move(panes[i]), glass));
    builder.add(shapes.back());
  }
  return shapes;
}

}  // namespace macula::scene::greenhouse
