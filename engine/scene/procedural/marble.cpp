#include <array>
#include <utility>
#include <vector>

#include "engine/scene/procedural/circle.h"
#include "engine/scene/procedural/marble_parts.h"
#include "engine/scene/procedural/mesh_builder.h"
#include "engine/scene/procedural/recipes.h"

namespace macula::scene {
namespace marble {
namespace {

constexpr float kRoomRadius = 4.0F;  // metres
constexpr float kRoomHeight = 4.4F;
constexpr int kBays = 12;

Material veined(const char* name, const glm::vec3& color, const glm::vec3& veins, float scale,
                float roughness) {
  Material material = plainMaterial(name, glm::vec4(color, 1.0F), roughness);
  material.veins = {veins, scale};
  return material;
}

void addPlinth(SceneBuilder& builder) {
  const std::int32_t stone = builder.material(
      veined("plinth", {0.035F, 0.085F, 0.065F}, {0.52F, 0.60F, 0.50F}, 2.2F, 0.28F));
  const std::vector<glm::vec2> profile{
      {0.86F, 0.0F},    {0.86F, 0.09F},       {0.84F, 0.105F},   {0.78F, 0.105F}, {0.78F, 0.14F},
      {0.745F, 0.155F}, {0.715F, 0.18F},      {0.70F, 0.21F},    {0.61F, 0.215F}, {0.585F, 0.24F},
      {0.58F, 0.275F},  {0.595F, 0.31F},      {0.63F, 0.33F},    {0.66F, 0.335F}, {0.67F, 0.35F},
      {0.67F, 0.385F},  {0.655F, kPlinthTop}, {0.0F, kPlinthTop}};
  Primitive mesh;
  addLathe(mesh, profile, 72);
  builder.addOnce(std::move(mesh), stone);

  // Beads around the neck of the plinth.
  const std::int32_t gold =
      builder.material(plainMaterial("gilt", {0.62F, 0.40F, 0.12F, 1.0F}, 0.30F, 0.5F));
  constexpr int kBeads = 40;
  Primitive bead;
  addSphere(bead, glm::vec3(0.0F), 0.026F, 8);
  const std::uint32_t shape = builder.shape(std::move(bead), gold);
  for (int i = 0; i < kBeads; ++i) {
    const glm::vec2 c = 0.59F * onCircle(static_cast<double>(i) / kBeads);
    builder.add(shape, place({c.x, 0.258F, c.y}));
  }
}

/// A round room seen from within: its wall faces inwards, so that a camera outside looks through.
void addRoom(SceneBuilder& builder) {
  const std::int32_t floor =
      builder.material(veined("floor", {0.30F, 0.27F, 0.24F}, {0.70F, 0.64F, 0.55F}, 1.0F, 0.35F));
  const std::int32_t inlay =
      builder.material(veined("inlay", {0.12F, 0.035F, 0.03F}, {0.55F, 0.36F, 0.28F}, 1.8F, 0.30F));
  const std::int32_t wall =
      builder.material(veined("wall", {0.42F, 0.38F, 0.33F}, {0.22F, 0.17F, 0.14F}, 0.6F, 0.6F));
  const std::int32_t panel =
      builder.material(veined("panel", {0.16F, 0.20F, 0.24F}, {0.46F, 0.50F, 0.52F}, 1.0F, 0.32F));

  const auto ring = [](float inner, float outer, float y) {
    Primitive mesh;
    addLathe(mesh, std::vector<glm::vec2>{{outer, y}, {inner, y}}, 72);
    return mesh;
  };
  builder.addOnce(ring(0.84F, 1.15F, 0.0F), floor);
  builder.addOnce(ring(1.15F, 1.32F, 0.0F), inlay);
  builder.addOnce(ring(1.32F, kRoomRadius, 0.0F), floor);
  Primitive around;
  addLathe(around,
           std::vector<glm::vec2>{{kRoomRadius, kRoomHeight},
                                  {kRoomRadius, 0.34F},
                                  {kRoomRadius - 0.03F, 0.33F},
                                  {kRoomRadius - 0.05F, 0.28F},
                                  {kRoomRadius - 0.05F, 0.0F}},
           72);
  // Half columns between the panels, with a foot and a head.
  for (int i = 0; i < kBays; ++i) {
    const double turns = (static_cast<double>(i) + 0.5) / kBays;
    const glm::vec2 c = (kRoomRadius - 0.02F) * onCircle(turns);
    Primitive column;
    addFlutedShaft(column, 0.19F, 2.3F, 12, 1);
    append(around, column, place({c.x, 0.42F, c.y}));
    Primitive foot;
    addLathe(foot,
             std::vector<glm::vec2>{
                 {0.28F, 0.0F}, {0.28F, 0.34F}, {0.24F, 0.36F}, {0.245F, 0.40F}, {0.20F, 0.43F}},
             14);
    addLathe(foot,
             std::vector<glm::vec2>{{0.16F, 2.68F},
                                    {0.20F, 2.72F},
                                    {0.21F, 2.79F},
                                    {0.28F, 2.85F},
                                    {0.28F, 2.96F},
                                    {0.0F, 2.96F}},
             14);
    append(around, foot, place({c.x, 0.0F, c.y}));
    // A panel between this column and the next, with a frame.
    const glm::vec2 middle = onCircle(static_cast<double>(i) / kBays);
    const glm::vec3 out{middle.x, 0.0F, middle.y};
    const glm::vec3 right{-middle.y, 0.0F, middle.x};
    const glm::vec3 at = out * (kRoomRadius - 0.10F);
    constexpr float kHalf = 0.66F;
    const auto corner = [&](float side, float y) {
      return at + right * (side * kHalf) + glm::vec3(0.0F, y, 0.0F);
    };
    Primitive slab;
    addQuad(slab, corner(-1.0F, 0.62F), corner(1.0F, 0.62F), corner(1.0F, 2.6F),
            corner(-1.0F, 2.6F));
    builder.addOnce(std::move(slab), panel);
    addTube(around,
            std::vector<glm::vec3>{corner(-1.0F, 0.62F), corner(-1.0F, 2.6F), corner(1.0F, 2.6F),
                                   corner(1.0F, 0.62F)},
            std::vector<float>(4, 0.035F), 8, true);
  }
  builder.addOnce(std::move(around), wall);
}

}  // namespace
}  // namespace marble

Scene makeMarble(std::uint64_t seed) {
  SceneBuilder builder("marble");
  Material stone =
      marble::veined("dragon", {0.66F, 0.62F, 0.55F}, {0.10F, 0.14F, 0.13F}, 2.0F, 0.27F);
  const std::int32_t body = builder.material(stone);
  // The same stone, seen from both sides where it is thin.
  stone.name = "wings";
  stone.doubleSided = true;
  const std::int32_t wings = builder.material(stone);
  Primitive dragon;
  Primitive skin;
  Primitive eyes;
  marble::addDragon(dragon, skin, seed);
  marble::addHead(dragon, eyes, marble::headFrame());
  builder.addOnce(std::move(dragon), body);
  builder.addOnce(std::move(skin), wings);
  builder.addOnce(std::move(eyes),
                  builder.material(plainMaterial("eyes", {0.55F, 0.12F, 0.02F, 1.0F}, 0.15F)));
  Primitive ball;
  addSphere(ball, glm::vec3(marble::kBall), marble::kBall.w, 40);
  builder.addOnce(std::move(ball),
                  builder.material(marble::veined("ball", {0.10F, 0.16F, 0.34F},
                                                  {0.75F, 0.66F, 0.40F}, 4.0F, 0.25F)));
  marble::addPlinth(builder);
  marble::addRoom(builder);

  builder.light(sun({-0.42F, -0.78F, -0.55F}, {1.0F, 0.95F, 0.86F}, 2.6F));
  builder.light(pointLight({-2.0F, 2.3F, 1.9F}, {0.62F, 0.78F, 1.0F}, 5.0F, 9.0F));
  builder.light(pointLight({1.7F, 1.0F, 1.9F}, {1.0F, 0.70F, 0.42F}, 3.0F, 9.0F));
  builder.light(pointLight({0.3F, 2.6F, -1.6F}, {1.0F, 0.86F, 0.70F}, 3.5F, 9.0F));
  builder.ambient({0.17F, 0.18F, 0.20F});

  Camera camera;
  camera.name = "scene";
  camera.position = {0.55F, 1.45F, 3.55F};
  camera.target = {-0.06F, 1.0F, 0.0F};
  camera.verticalFov = 0.57F;  // 33 degrees: from wing to wing
  camera.farPlane = 20.0F;
  builder.camera(camera);
  camera.name = "orbit";
  builder.camera(camera);
  return std::move(builder).finish();
}

}  // namespace macula::scene
