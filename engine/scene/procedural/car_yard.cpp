// Where the car stands: a paved yard, a lattice roof over half of it, a tree.
#include <cmath>
#include <utility>
#include <vector>

#include "engine/core/random.h"
#include "engine/scene/procedural/car_parts.h"
#include "engine/scene/procedural/circle.h"
#include "engine/scene/procedural/in_ball.h"
#include "engine/scene/procedural/leaf.h"
#include "engine/scene/procedural/mesh_builder.h"

namespace macula::scene::car {
namespace {

constexpr float kWallHeight = 4.2F;  // metres

void addGroundAndWalls(SceneBuilder& builder, const Palette& palette) {
  constexpr float kCobblesPerMetre = 0.62F;
  constexpr float kBricksPerMetre = 1.45F;
  Primitive ground;
  addQuad(ground, {-kYard, 0.0F, kYard}, {kYard, 0.0F, kYard}, {kYard, 0.0F, -kYard},
          {-kYard, 0.0F, -kYard}, glm::vec2(0.0F), glm::vec2(2.0F * kYard * kCobblesPerMetre));
  builder.addOnce(std::move(ground), palette.cobbles);
  // One-sided: a camera behind a wall looks through it into the yard.
  Primitive walls;
  Primitive coping;
  for (int i = 0; i < 4; ++i) {
    const glm::mat4 turned = place({0, 0, 0}, 0.25F * static_cast<float>(i));
    Primitive wall;
    addQuad(wall, {-kYard, 0.0F, -kYard}, {kYard, 0.0F, -kYard}, {kYard, kWallHeight, -kYard},
            {-kYard, kWallHeight, -kYard}, glm::vec2(0.0F),
            glm::vec2(2.0F * kYard, kWallHeight) * kBricksPerMetre);
    append(walls, wall, turned);
    Primitive stones;  // a plinth of stone along the foot
    constexpr int kStones = 9;
    for (int k = 0; k < kStones; ++k) {
      const float width = 2.0F * kYard / kStones;
      const float x = -kYard + width * static_cast<float>(k);
      addQuad(stones, {x + 0.01F, 0.0F, -kYard + 0.08F}, {x + width - 0.01F, 0.0F, -kYard + 0.08F},
              {x + width - 0.01F, 0.38F, -kYard + 0.06F}, {x + 0.01F, 0.38F, -kYard + 0.06F});
      addQuad(stones, {x + 0.01F, 0.38F, -kYard + 0.06F},
              {x + width - 0.01F, 0.38F, -kYard + 0.06F}, {x + width - 0.01F, 0.42F, -kYard},
              {x + 0.01F, 0.42F, -kYard});
    }
    append(coping, stones, turned);
  }
  builder.addOnce(std::move(walls), palette.bricks);
  builder.addOnce(std::move(coping), palette.stone);
}

/// Beams from wall to wall, and over the car's tail rafters and slats that cross: their shadow is a
/// lattice.
void addPergola(SceneBuilder& builder, const Palette& palette) {
  constexpr float kRight = 0.5F;  // where the slats end; x and z in metres
  constexpr float kBack = -0.9F;
  constexpr float kFront = 3.3F;
  constexpr float kTop = 2.8F;
  constexpr int kRafters = 12;
  constexpr int kSlats = 24;
  Primitive wood;
  for (const float z : {kBack, kFront}) {
    addBevelledBox(wood, {-kYard, kTop, z - 0.05F}, {kYard, kTop + 0.16F, z + 0.05F}, 0.012F);
  }
  for (int i = 0; i <= kRafters; ++i) {
    const float x = glm::mix(-kYard + 0.1F, kRight, static_cast<float>(i) / kRafters);
    addBox(wood, {x - 0.03F, kTop + 0.16F, kBack - 0.3F}, {x + 0.03F, kTop + 0.26F, kFront + 0.3F});
  }
  for (int i = 0; i <= kSlats; ++i) {
    const float z = glm::mix(kBack - 0.2F, kFront + 0.2F, static_cast<float>(i) / kSlats);
    addBox(wood, {-kYard, kTop + 0.26F, z - 0.018F}, {kRight + 0.25F, kTop + 0.29F, z + 0.018F});
  }
  builder.addOnce(std::move(wood), palette.timber);
}

/// A branch that forks until its twigs carry leaves.
class Tree {
 public:
  explicit Tree(std::uint64_t seed) : random_(seed, 31) {}

  void grow(const glm::vec3& foot, const glm::vec3& heading, float length, float radius,
            int forks) {
    const int kSteps = forks > 0 ? 3 : 2;
    std::vector<glm::vec3> path{foot};
    std::vector<float> radii{radius};
    glm::vec3 direction = heading;
    for (int i = 1; i <= kSteps; ++i) {
      direction = glm::normalize(direction + 0.22F * inBall(random_));
      path.push_back(path.back() + direction * (length / static_cast<float>(kSteps)));
      radii.push_back(radius * (1.0F - 0.35F * static_cast<float>(i) / static_cast<float>(kSteps)));
    }
    addTube(wood, path, radii, forks > 2 ? 8 : (forks > 0 ? 5 : 3), false);
    if (forks == 0) {
      addLeaves(path);
      return;
    }
    const int children = forks > 2 ? 4 : 3;
    const float turn = random_.unit();
    for (int i = 0; i < children; ++i) {
      const glm::vec2 around =
          onCircle(turn + static_cast<float>(i) / static_cast<float>(children));
      const glm::vec3 side = glm::normalize(glm::cross(
          direction, std::abs(direction.y) < 0.9F ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0)));
      const glm::vec3 out = side * around.x + glm::cross(direction, side) * around.y;
      grow(path.back(), glm::normalize(direction + 0.85F * out + glm::vec3(0.0F, 0.12F, 0.0F)),
           length * random_.range(0.62F, 0.78F), radii.back() * 0.66F, forks - 1);
    }
  }

  Primitive wood;
  Primitive leaves;

 private:
  void addLeaves(const std::vector<glm::vec3>& path) {
    constexpr int kLeaves = 9;
    for (int i = 0; i < kLeaves; ++i) {
      const float t = static_cast<float>(i) / kLeaves * static_cast<float>(path.size() - 1);
      const auto k = static_cast<std::size_t>(t);
      const glm::vec3 foot =
          glm::mix(path[k], path[k + 1], t - static_cast<float>(k)) + 0.05F * inBall(random_);
      const float tone = random_.unit();
      const glm::vec4 color{glm::mix(0.045F, 0.20F, tone), glm::mix(0.13F, 0.28F, tone), 0.03F,
                            1.0F};
      addLeaf(leaves,
              {random_.unit(), random_.range(0.11F, 0.17F), random_.range(-0.3F, 0.7F), 2.0F,
               random_.range(0.07F, 0.10F), foot},
              2, color, [](float s) { return 4.0F * s * (1.0F - s) * (1.3F - 0.6F * s) + 0.02F; });
    }
  }

  Random random_;
};

}  // namespace

void addYard(SceneBuilder& builder, const Palette& palette, std::uint64_t seed) {
  addGroundAndWalls(builder, palette);
  addPergola(builder, palette);
  Tree tree(seed);
  tree.grow({4.0F, 0.0F, 1.35F}, glm::normalize(glm::vec3(-0.12F, 1.0F, 0.0F)), 1.75F, 0.15F, 4);
  builder.addOnce(std::move(tree.wood), palette.bark);
  builder.addOnce(std::move(tree.leaves), palette.leaves);
}

}  // namespace macula::scene::car
