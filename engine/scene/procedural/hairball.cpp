#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <utility>

#include "engine/core/random.h"
#include "engine/scene/procedural/circle.h"
#include "engine/scene/procedural/depth_counter.h"
#include "engine/scene/procedural/in_ball.h"
#include "engine/scene/procedural/mesh_builder.h"
#include "engine/scene/procedural/recipes.h"
#include "engine/scene/procedural/ribbon.h"
#include "engine/scene/procedural/scene_builder.h"
#include "engine/scene/procedural/textures.h"

namespace macula::scene {
namespace {

constexpr int kDepthLimit = 180;     // the depth that the scene promises
constexpr int kCountingSize = 1024;  // pixels; the size at which the depth is promised
constexpr float kTanHalfFov = 0.3F;
const glm::vec3 kCenter{0.0F, 1.12F, 0.0F};  // of the ball, metres
constexpr int kStrands = 14500;        // tried; those that would exceed the limit are left out
constexpr std::size_t kPoints = 18;    // along a strand
constexpr float kThickness = 0.0050F;  // half the width of a strand, metres

/// A unit vector in a direction of equal chance.
glm::vec3 randomDirection(Random& random) {
  for (;;) {
    const glm::vec3 p = inBall(random);
    const float length = glm::length(p);
    if (length > 0.1F) return p / length;
  }
}

/// A strand wound around the centre on a wavering great circle. It begins at the radius `inner` and
/// ends at `outer`; the change comes late, so that loose ends stand off the ball.
struct Winding {
  glm::vec3 axis{0.0F};  ///< of the circle
  float inner = 0.0F;    ///< metres
  float outer = 0.0F;
  float start = 0.0F;  ///< turns
  float sweep = 0.0F;  ///< turns
  float waver = 0.0F;  ///< out of the plane, share of the radius
  float roll = 0.0F;   ///< of the ribbon about its path, as a tangent; 0 faces outwards
};

std::array<RibbonPoint, kPoints> pointsOf(const Winding& winding) {
  const glm::vec3& axis = winding.axis;
  const glm::vec3 other = std::abs(axis.y) < 0.9F ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 u = glm::normalize(glm::cross(axis, other));
  const glm::vec3 v = glm::cross(axis, u);
  std::array<RibbonPoint, kPoints> points;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(kPoints - 1);
    const float turns = winding.start + winding.sweep * t;
    const glm::vec2 around = onCircle(turns);
    const float wave = winding.waver * onCircle(2.7F * turns + winding.start).y;
    const glm::vec3 out = glm::normalize(u * around.x + v * around.y + axis * wave);
    points[i].center = kCenter + out * glm::mix(winding.inner, winding.outer, t * t * t);
    points[i].side = axis + out * winding.roll;
    // Thin at both ends, as a cut hair is not but a spun one is.
    points[i].halfWidth = kThickness * (0.25F + 3.0F * t * (1.0F - t));
  }
  return points;
}

void addBall(SceneBuilder& builder, const Camera& camera, std::uint64_t seed) {
  // Linear; the yarn is spun of a few dyes.
  const std::array<glm::vec3, 4> dyes{
      glm::vec3{0.72F, 0.20F, 0.07F}, glm::vec3{0.85F, 0.52F, 0.16F},
      glm::vec3{0.10F, 0.36F, 0.42F}, glm::vec3{0.62F, 0.58F, 0.50F}};
  DepthCounter counter(camera, kTanHalfFov, kCountingSize);
  Random random(seed, 41);
  Primitive ball;
  for (int i = 0; i < kStrands; ++i) {
    Winding winding;
    winding.axis = randomDirection(random);
    const float u = random.unit();
    winding.inner = 0.10F + 0.76F * u;
    const bool loose = random.below(5) == 0;
    winding.outer = winding.inner + (loose ? random.range(0.05F, 0.3F) : 0.0F);
    winding.start = random.unit();
    winding.sweep = random.range(0.7F, 1.1F) * 0.2F / winding.inner;
    winding.waver = random.range(0.0F, 0.35F);
    winding.roll = random.range(-1.2F, 1.2F);
    const float tone = random.range(0.55F, 1.1F);
    const float alpha = random.range(0.15F, 0.5F);
    const glm::vec3 dye = dyes[random.below(static_cast<std::uint32_t>(dyes.size()))];
    Primitive strand;
    addRibbon(strand, pointsOf(winding), {glm::min(dye * tone, glm::vec3(1.0F)), alpha});
    if (counter.addWithin(strand, glm::mat4(1.0F), kDepthLimit)) {
      append(ball, strand, glm::mat4(1.0F));
    }
  }
  Material wool = plainMaterial("wool", glm::vec4(1.0F), 0.5F);
  wool.alphaMode = AlphaMode::Blend;
  wool.doubleSided = true;
  builder.addOnce(std::move(ball), builder.material(wool));
}

void addStand(SceneBuilder& builder, std::uint64_t seed) {
  Material floor = plainMaterial("floor", glm::vec4(1.0F), 0.5F);
  floor.baseColorTexture.image = builder.image(woodBoards(256, seed));
  Primitive ground;
  constexpr float kHalf = 4.0F;        // metres
  constexpr float kRepeats = 5.0F;     // of the boards
  constexpr float kWallBehind = 2.6F;  // metres
  constexpr float kWallHeight = 5.0F;  // metres
  addQuad(ground, {-kHalf, 0.0F, kHalf}, {kHalf, 0.0F, kHalf}, {kHalf, 0.0F, -kHalf},
          {-kHalf, 0.0F, -kHalf}, glm::vec2(0.0F), glm::vec2(kRepeats));
  builder.addOnce(std::move(ground), builder.material(floor));

  // One-sided, so that an orbit passing through it still sees the ball.
  Primitive wall;
  addQuad(wall, {-kHalf, 0.0F, -kWallBehind}, {kHalf, 0.0F, -kWallBehind},
          {kHalf, kWallHeight, -kWallBehind}, {-kHalf, kWallHeight, -kWallBehind});
  builder.addOnce(std::move(wall),
                  builder.material(plainMaterial("wall", {0.10F, 0.13F, 0.17F, 1.0F}, 0.9F)));
}

}  // namespace

Scene makeHairball(std::uint64_t seed) {
  SceneBuilder builder("hairball");
  Camera camera;
  camera.name = "scene";
  camera.position = {0.9F, 1.75F, 3.8F};
  camera.target = kCenter;
  camera.verticalFov = 2.0F * std::atan(kTanHalfFov);
  camera.farPlane = 20.0F;
  builder.camera(camera);
  camera.name = "orbit";
  builder.camera(camera);

  addStand(builder, seed);
  addBall(builder, camera, seed);

  builder.light(sun({-0.55F, -0.75F, -0.45F}, {1.0F, 0.94F, 0.85F}, 3.0F));
  builder.light(pointLight({-2.2F, 1.6F, 1.2F}, {0.5F, 0.68F, 1.0F}, 5.0F, 10.0F));
  builder.light(pointLight({1.9F, 1.2F, -1.7F}, {1.0F, 0.6F, 0.3F}, 4.0F, 10.0F));
  builder.light(spotLight({0.0F, 4.0F, -1.5F}, kCenter, {1.0F, 0.97F, 0.92F}, 9.0F, 0.5F));
  builder.ambient({0.13F, 0.14F, 0.16F});
  return std::move(builder).finish();
}

}  // namespace macula::scene
