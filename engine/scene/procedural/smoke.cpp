#include <cmath>
#include <glm/glm.hpp>
#include <utility>
#include <vector>

#include "engine/core/random.h"
#include "engine/scene/procedural/depth_counter.h"
#include "engine/scene/procedural/in_ball.h"
#include "engine/scene/procedural/mesh_builder.h"
#include "engine/scene/procedural/recipes.h"
#include "engine/scene/procedural/scene_builder.h"
#include "engine/scene/procedural/textures.h"

namespace macula::scene {
namespace {

constexpr int kDepthLimit = 16;      // maximum depth of the smoke scene of Vasilakis 2017, Table 2
constexpr int kCountingSize = 1024;  // pixels; the size at which the depth is promised
constexpr int kAttempts = 420;       // puffs tried; those that would exceed the limit are left out
constexpr float kTanHalfFov = 0.42F;
constexpr float kPlumeFoot = 0.8F;    // metres above the floor
constexpr float kPlumeHeight = 2.6F;  // metres

/// Centre of the plume at a height of t (0 foot, 1 top): it leans with the draught.
glm::vec3 plumeCenter(float t) {
  return {0.55F * t * t - 0.25F * t * (1.0F - t), kPlumeFoot + kPlumeHeight * t, 0.2F * t};
}

/// Grey, lit from the fire below and bluish above.
glm::vec3 smokeColor(float t, float tone) {
  const glm::vec3 warm{0.95F, 0.48F, 0.20F};
  const glm::vec3 cool{0.42F, 0.47F, 0.56F};
  const float glow = (1.0F - t) * (1.0F - t) * (1.0F - t) * (1.0F - t);
  return glm::mix(cool * (0.55F + 0.6F * tone), warm, glow);
}

void addBrazier(SceneBuilder& builder) {
  const std::int32_t iron =
      builder.material(plainMaterial("iron", {0.11F, 0.10F, 0.10F, 1.0F}, 0.55F, 0.6F));
  const std::vector<glm::vec2> bowl{{0.0F, 0.0F},   {0.34F, 0.0F},  {0.34F, 0.04F}, {0.12F, 0.10F},
                                    {0.08F, 0.20F}, {0.08F, 0.36F}, {0.20F, 0.44F}, {0.38F, 0.58F},
                                    {0.46F, 0.74F}, {0.49F, 0.75F}, {0.47F, 0.78F}, {0.42F, 0.75F},
                                    {0.32F, 0.66F}, {0.0F, 0.62F}};
  Primitive mesh;
  addLathe(mesh, bowl, 64);
  builder.addOnce(std::move(mesh), iron);

  Material ember = plainMaterial("embers", {0.25F, 0.06F, 0.02F, 1.0F}, 0.9F);
  ember.emissive = {4.0F, 1.1F, 0.15F};
  Primitive coals;
  Random random(7);
  for (int i = 0; i < 24; ++i) {
    const glm::vec3 p = inBall(random) * glm::vec3(0.28F, 0.03F, 0.28F);
    addSphere(coals, p + glm::vec3(0.0F, 0.68F, 0.0F), random.range(0.03F, 0.07F), 10);
  }
  builder.addOnce(std::move(coals), builder.material(ember));
}

void addPlume(SceneBuilder& builder, const Camera& camera, std::uint64_t seed) {
  DepthCounter counter(camera, kTanHalfFov, kCountingSize);
  Random random(seed, 1);
  Primitive plume;
  for (int i = 0; i < kAttempts; ++i) {
    const float t = random.unit();
    const glm::vec3 spread = inBall(random) * (0.12F + 0.75F * t);
    const glm::vec3 center = plumeCenter(t) + spread * glm::vec3(1.0F, 0.5F, 1.0F);
    // Mostly towards the sides, so that from every level direction some puffs are seen broadly.
    const glm::vec3 axis = inBall(random) * glm::vec3(1.0F, 0.55F, 1.0F);
    const float length = glm::length(axis);
    const float radius = random.range(0.75F, 1.25F) * (0.2F + 0.42F * t);
    const float alpha = random.range(0.1F, 0.4F);
    const float tone = random.unit();
    if (length < 0.1F) continue;  // no direction to speak of
    Primitive puff;
    addPuff(puff, center, axis / length, radius, smokeColor(t, tone), alpha);
    if (counter.addWithin(puff, glm::mat4(1.0F), kDepthLimit)) {
      append(plume, puff, glm::mat4(1.0F));
    }
  }
  builder.addOnce(std::move(plume), builder.material(smokeMaterial()));
}

}  // namespace

Scene makeSmoke(std::uint64_t seed) {
  SceneBuilder builder("smoke");

  Camera camera;
  camera.name = "scene";
  camera.position = {0.6F, 1.8F, 6.2F};
  camera.target = {0.1F, 2.0F, 0.0F};
  camera.verticalFov = 2.0F * std::atan(kTanHalfFov);
  camera.farPlane = 40.0F;
  builder.camera(camera);
  camera.name = "orbit";
  builder.camera(camera);

  Material floor = plainMaterial("floor", glm::vec4(1.0F), 0.6F);
  floor.baseColorTexture.image = builder.image(marbleTiles(256, seed));
  Primitive ground;
  constexpr float kHalf = 6.0F;     // metres
  constexpr float kRepeats = 6.0F;  // of the tiles
  addQuad(ground, {-kHalf, 0.0F, kHalf}, {kHalf, 0.0F, kHalf}, {kHalf, 0.0F, -kHalf},
          {-kHalf, 0.0F, -kHalf}, glm::vec2(0.0F), glm::vec2(kRepeats));
  builder.addOnce(std::move(ground), builder.material(floor));
  addBrazier(builder);
  addPlume(builder, camera, seed);

  builder.light(sun({-0.5F, -0.8F, -0.35F}, {0.85F, 0.9F, 1.0F}, 2.0F));
  builder.light(pointLight({0.0F, 1.1F, 0.0F}, {1.0F, 0.45F, 0.15F}, 5.0F, 8.0F));
  builder.ambient({0.10F, 0.11F, 0.13F});
  return std::move(builder).finish();
}

}  // namespace macula::scene
