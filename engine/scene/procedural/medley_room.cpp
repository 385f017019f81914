// Floor, walls and opaque things of the medleys.
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "engine/scene/procedural/medley_parts.h"
#include "engine/scene/procedural/mesh_builder.h"
#include "engine/scene/procedural/pixels.h"
#include "engine/scene/procedural/textures.h"

namespace macula::scene::medley {
namespace {

constexpr float kHalfRoom = 2.9F;    // metres
constexpr float kWallBehind = 2.4F;  // metres
constexpr float kWallHeight = 4.5F;  // metres
constexpr float kHalfGround = 9.0F;  // metres, where there are no walls
constexpr int kImageSize = 128;      // pixels a side
constexpr float kDark = 0.12F;       // share of the light that dark rooms reflect

enum RoomKind : std::uint32_t { Walled, OneWall, Ground, DarkRoom, DarkGround, Nothing };
constexpr std::array kRooms{Walled, Walled,   OneWall,  OneWall,    Ground,
                            Ground, DarkRoom, DarkRoom, DarkGround, Nothing};

/// A picture for floor or wall; a plain colour where `chosen` is beyond the pictures.
Image picture(std::uint32_t chosen, Random& random) {
  const std::uint64_t seed = random.next();
  const Palette palette(random);
  const glm::vec3 a = palette.color(random);
  const glm::vec3 b = palette.color(random);
  switch (chosen) {
    case 0:
      return drawImage("checker", kImageSize, kImageSize, [=](float u, float v) {
        return glm::vec4((u < 0.5F) != (v < 0.5F) ? a : b, 1.0F);
      });
    case 1:
      return drawImage("gradient", kImageSize, kImageSize, [=](float /*u*/, float v) {
        return glm::vec4(glm::mix(a, b, triangleWave(0.5F * v)), 1.0F);
      });
    case 2:
      return marbleTiles(kImageSize, seed);
    case 3:
      return woodBoards(kImageSize, seed);
    default:
      return plaster(kImageSize, seed);
  }
}

Material surface(Stage& stage, const char* name, bool dark, bool lit, Random& random) {
  constexpr std::uint32_t kPictures = 5;
  const std::uint32_t chosen = random.below(kPictures + 2);
  const Palette palette(random);
  Material material = plainMaterial(name, glm::vec4(1.0F), random.range(0.35F, 0.9F));
  if (chosen < kPictures) {
    material.baseColorTexture.image = stage.builder().image(picture(chosen, random));
  } else {
    material.baseColor = glm::vec4(palette.color(random), 1.0F);
  }
  if (dark) material.baseColor = glm::vec4(kDark * glm::vec3(material.baseColor), 1.0F);
  material.unlit = !lit;
  return material;
}

Primitive floorOf(float half, float repeats) {
  Primitive floor;
  addQuad(floor, {-half, 0.0F, half}, {half, 0.0F, half}, {half, 0.0F, -half}, {-half, 0.0F, -half},
          glm::vec2(0.0F), glm::vec2(repeats));
  return floor;
}

/// One-sided walls: an orbit passes through them and sees the things still.
Primitive wallsOf(bool sides, float repeats) {
  const float x = kHalfRoom;
  const float back = -kWallBehind;
  const float top = kWallHeight;
  Primitive walls;
  const glm::vec2 none(0.0F);
  const glm::vec2 uv(repeats);
  addQuad(walls, {-x, 0, back}, {x, 0, back}, {x, top, back}, {-x, top, back}, none, uv);
  if (!sides) return walls;
  addQuad(walls, {-x, 0, x}, {-x, 0, back}, {-x, top, back}, {-x, top, x}, none, uv);
  addQuad(walls, {x, 0, back}, {x, 0, x}, {x, top, x}, {x, top, back}, none, uv);
  return walls;
}

Primitive sky() {
  const float half = 2.0F * kHalfGround;
  Primitive quad;
  addQuad(quad, {-half, 0, -kHalfGround}, {half, 0, -kHalfGround}, {half, half, -kHalfGround},
          {-half, half, -kHalfGround});
  return quad;
}

Material skyMaterial(Stage& stage, Random& random) {
  const Palette palette(random);
  const glm::vec3 high = palette.color(random);
  const glm::vec3 low = glm::mix(palette.color(random), glm::vec3(0.8F), 0.5F);
  Material material = plainMaterial("sky", glm::vec4(1.0F), 1.0F);
  material.unlit = true;
  material.baseColorTexture.image =
      stage.builder().image(drawImage("sky", 1, kImageSize, [=](float /*u*/, float v) {
        return glm::vec4(glm::mix(high, low, v * v), 1.0F);
      }));
  material.baseColorTexture.sampler.wrapT = Sampler::Wrap::ClampToEdge;
  return material;
}

Primitive solidOf(Random& random) {
  const float r = random.range(0.12F, 0.38F);
  const float height = random.range(0.3F, 1.6F);
  Primitive mesh;
  switch (random.below(4)) {
    case 0:
      addBevelledBox(mesh, {-r, 0.0F, -r}, {r, height, r}, 0.02F);
      break;
    case 1:
      addSphere(mesh, {0.0F, r, 0.0F}, r, 32);
      break;
    case 2:
      addFlutedShaft(mesh, 0.7F * r, height, 10, 4);
      break;
    default:
      addTorusKnot(mesh, 2, 3, r, 0.25F * r, 72, 10);
      for (glm::vec3& p : mesh.positions) p.y += 0.8F * r;  // off the floor
      break;
  }
  return mesh;
}

}  // namespace

void addRoom(Stage& stage, Random& random, bool lit) {
  const RoomKind kind = kRooms[random.below(static_cast<std::uint32_t>(kRooms.size()))];
  const bool dark = kind == DarkRoom || kind == DarkGround;
  const bool walled = kind == Walled || kind == OneWall || kind == DarkRoom;
  const float repeats = 2.0F + static_cast<float>(random.below(6));
  if (kind != Nothing) {
    const Material floor = surface(stage, "floor", dark, lit, random);
    stage.addOpaque(floorOf(walled ? kHalfRoom : kHalfGround, walled ? repeats : 3.0F * repeats),
                    stage.builder().material(floor));
  }
  if (walled) {
    const Material wall = surface(stage, "walls", dark, lit, random);
    stage.addOpaque(wallsOf(kind != OneWall, 1.0F + static_cast<float>(random.below(4))),
                    stage.builder().material(wall));
  }
  if (kind == Ground) stage.addOpaque(sky(), stage.builder().material(skyMaterial(stage, random)));
  const std::uint32_t solids = 2 + random.below(4);
  const Palette palette(random);
  for (std::uint32_t i = 0; i < solids; ++i) {
    const glm::vec4 color(palette.color(random), 1.0F);
    const float roughness = random.range(0.15F, 0.9F);
    const float metallic = random.below(4) == 0 ? 1.0F : 0.0F;
    Material material = plainMaterial("solid", color, roughness, metallic);
    material.unlit = !lit;
    const glm::vec3 at{random.range(-1.5F, 1.5F), 0.0F, random.range(-1.5F, 1.2F)};
    const float scale = at.z > 0.2F ? 0.55F : 1.0F;  // in front, large ones would hide the rest
    Primitive mesh;
    const float turns = random.unit();
    append(mesh, solidOf(random), place(at, turns, scale));
    stage.addOpaque(std::move(mesh), stage.builder().material(material));
  }
}

}  // namespace macula::scene::medley
