// Groups of the medleys that are flat: puffs, leaves, sheets, confetti.
#include <algorithm>
#include <array>
#include <utility>

#include "engine/scene/procedural/in_ball.h"
#include "engine/scene/procedural/medley_parts.h"
#include "engine/scene/procedural/mesh_builder.h"
#include "engine/scene/procedural/pixels.h"
#include "engine/scene/procedural/textures.h"

namespace macula::scene::medley {
namespace {

constexpr int kImageSize = 64;        // pixels a side
constexpr std::size_t kQuad = 2;      // triangles
constexpr float kSeenShare = 0.5F;    // of its area that a thing turned at random shows
constexpr float kAboveFloor = 0.02F;  // metres, so that nothing shares the floor's plane

/// A square of half-width `half` that faces along `axis` (unit length), turned at random.
void addFacing(Primitive& mesh, const glm::vec3& center, const glm::vec3& axis, float half,
               const glm::vec4& color, Random& random) {
  const glm::vec3 u = half * perpendicular(axis, random);
  const glm::vec3 v = glm::cross(axis, u);
  const std::size_t first = mesh.positions.size();
  addQuad(mesh, center - u - v, center + u - v, center + u + v, center - u + v);
  paint(mesh, color, first);
}

/// White, its alpha falling to 0 at the rim, mottled.
Image softImage(std::uint32_t seed) {
  return drawImage("soft", kImageSize, kImageSize, [seed](float u, float v) {
    const glm::vec2 p = 2.0F * glm::vec2(u, v) - 1.0F;
    const float fade = std::max(1.0F - glm::dot(p, p), 0.0F);
    return glm::vec4(glm::vec3(1.0F), fade * (0.5F + 0.8F * fractal(u, v, 4, seed)));
  });
}

/// A petal: a disc drawn out to a tip, darker along its middle, cut out.
Image petalImage(std::uint32_t seed) {
  return drawImage("petal", kImageSize, kImageSize, [seed](float u, float v) {
    const float side = std::abs(2.0F * u - 1.0F);
    const float outline = 3.2F * v * (1.0F - v) * (0.55F + 0.45F * v);
    const float shade = side < 0.06F ? 0.6F : 0.8F + 0.2F * fractal(u, v, 6, seed);
    return glm::vec4(glm::vec3(shade), side < outline ? 1.0F : 0.0F);
  });
}

/// Stripes of two alphas.
Image stripeImage(std::uint32_t stripes, float faint) {
  return drawImage("stripes", kImageSize, kImageSize, [=](float u, float v) {
    const bool solid = triangleWave(static_cast<float>(stripes) * (u + 0.5F * v)) < 0.5F;
    return glm::vec4(glm::vec3(1.0F), solid ? 1.0F : faint);
  });
}

}  // namespace

void addPuffs(Group& group) {
  Random& random = group.random;
  enum Form : std::uint32_t { Cloud, Plume, Fog, Forms };
  const std::uint32_t form = random.below(Forms);
  const float radius = group.size * random.range(0.16F, 0.4F);
  // A few puffs are to be seen as well as many.
  const Alphas alphas = group.alphas(std::clamp(0.6F / group.layers, 0.02F, 0.15F), 0.3F);
  const bool dishes = random.below(4) == 0;
  constexpr std::size_t kDish = 216;  // triangles of addPuff
  const float spread = group.size * group.size * (form == Cloud ? 2.2F : 2.6F);
  const int count = group.pieces(2.0F * radius * radius, spread, dishes ? kDish : kQuad);
  const glm::vec3 middle = group.foot + glm::vec3(0.0F, group.size, 0.0F);
  const glm::vec3 lean = inBall(random) * glm::vec3(0.6F, 0.0F, 0.6F);
  Primitive mesh;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 ball = group.scatter();
    const float t = random.unit();
    glm::vec3 center = middle + group.size * ball * glm::vec3(1.0F, 0.7F, 1.0F);
    if (form == Plume) {
      center = group.foot + group.size * (glm::vec3(0.0F, 2.2F * t, 0.0F) + lean * (t * t) +
                                          ball * (0.12F + 0.55F * t));
    } else if (form == Fog) {
      center = group.foot + group.size * (ball * glm::vec3(1.9F, 0.35F, 1.3F));
      center.y += 0.5F * radius + 0.35F * group.size;
    }
    // Towards the camera, but not so strictly that an orbit sees them edge-on all at once.
    const glm::vec3 towards = glm::normalize(group.stage.camera().position - center);
    const glm::vec3 axis = glm::normalize(towards + 0.85F * inBall(random));
    const float shade = 0.7F + 0.3F * (0.5F + 0.5F * ball.y);
    const glm::vec3 color = shade * group.palette.color(random);
    const float alpha = alphas.pick(random);
    const float half = radius * random.range(0.7F, 1.3F);
    Primitive puff;
    if (dishes) {
      addPuff(puff, center, axis, half, color, alpha);
    } else {
      addFacing(puff, center, axis, half, glm::vec4(color, alpha), random);
    }
    group.stage.add(mesh, puff);
  }
  Material material = group.material("puffs");
  material.unlit = true;
  if (!dishes) {
    material.baseColorTexture.image = group.stage.builder().image(softImage(random.next()));
  }
  group.finish(std::move(mesh), material);
}

void addLeaves(Group& group) {
  Random& random = group.random;
  const bool falling = random.below(2) == 0;
  const float half = group.size * random.range(0.05F, 0.14F);
  const Alphas alphas = group.alphas(0.3F, 0.95F);
  const float spread = group.size * group.size * (falling ? 4.0F : 2.2F);
  const int count = group.pieces(4.0F * kSeenShare * half * half, spread, kQuad);
  const glm::vec3 extent = falling ? glm::vec3(1.3F, 1.2F, 1.0F) : glm::vec3(0.9F, 1.0F, 0.9F);
  const glm::vec3 middle = group.foot + glm::vec3(0.0F, extent.y * group.size + half, 0.0F);
  Primitive mesh;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 ball = group.scatter();
    // A bush's leaves face outwards.
    const glm::vec3 axis = glm::normalize(direction(random) + (falling ? 0.0F : 1.2F) * ball);
    const glm::vec4 color{group.palette.color(random), alphas.pick(random)};
    Primitive leaf;
    addFacing(leaf, middle + group.size * extent * ball, axis, half * random.range(0.7F, 1.4F),
              color, random);
    group.stage.add(mesh, leaf);
  }
  Material material = group.material("leaves");
  const std::uint32_t seed = random.next();
  material.baseColorTexture.image = group.stage.builder().image(
      random.below(2) == 0 ? frond(kImageSize, seed) : petalImage(seed));
  group.finish(std::move(mesh), material);
}

void addSheets(Group& group) {
  Random& random = group.random;
  enum Form : std::uint32_t { Parallel, Crossing, Fan, Forms };
  const std::uint32_t form = random.below(Forms);
  constexpr float kMostSheets = 26.0F;
  const int count = static_cast<int>(std::clamp(group.layers, 3.0F, kMostSheets));
  const Alphas alphas = group.alphas(0.05F, 0.9F);
  const float turn = random.range(-0.08F, 0.08F);  // turns; parallel ones face the camera broadly
  Primitive mesh;
  for (int i = 0; i < count; ++i) {
    const float t = (static_cast<float>(i) + 0.5F) / static_cast<float>(count);  // front to back
    const glm::vec2 half =
        group.size * glm::vec2{random.range(0.6F, 1.5F), random.range(0.5F, 1.1F)};
    const glm::vec3 shift = inBall(random) * group.size * glm::vec3(0.35F, 0.0F, 0.12F);
    glm::vec3 foot = group.foot + shift;
    float turns = turn;
    if (form == Parallel) foot.z += group.size * (1.0F - 2.0F * t);
    if (form == Crossing) turns = random.range(-0.25F, 0.25F);
    if (form == Fan) turns = glm::mix(-0.24F, 0.24F, t);
    const float low = kAboveFloor + group.size * random.range(0.0F, 0.3F);
    Primitive flat;
    addQuad(flat, {-half.x, low, 0}, {half.x, low, 0}, {half.x, low + 2.0F * half.y, 0},
            {-half.x, low + 2.0F * half.y, 0});
    paint(flat, glm::vec4{group.palette.color(random), alphas.pick(random)});
    Primitive sheet;
    append(sheet, flat, place(foot, turns));
    group.stage.add(mesh, sheet);
  }
  Material material = group.material("sheets");
  if (random.below(3) == 0) {
    const std::uint32_t stripes = 2 + random.below(7);
    material.baseColorTexture.image =
        group.stage.builder().image(stripeImage(stripes, random.range(0.1F, 0.6F)));
  }
  group.finish(std::move(mesh), material);
}

void addConfetti(Group& group) {
  Random& random = group.random;
  const float side = group.size * random.range(0.08F, 0.35F);
  const Alphas alphas = group.alphas(0.05F, 1.0F);
  const glm::vec3 extent{random.range(0.8F, 1.5F), random.range(0.6F, 1.1F), 1.0F};
  const float over = 3.0F * extent.x * extent.y * group.size * group.size;
  const int count = group.pieces(0.5F * kSeenShare * side * side, over, 1);
  const glm::vec3 middle = group.foot + glm::vec3(0.0F, extent.y * group.size + side, 0.0F);
  Primitive mesh;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 center = middle + group.size * extent * group.scatter();
    const std::array<glm::vec3, 3> corners{center + side * inBall(random),
                                           center + side * inBall(random),
                                           center + side * inBall(random)};
    const glm::vec4 color{group.palette.color(random), alphas.pick(random)};
    const glm::vec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const float area = glm::length(across);
    if (area < 1e-3F * side * side) continue;  // a line, without a normal to speak of
    Primitive scrap;
    for (const glm::vec3& corner : corners) {
      scrap.indices.push_back(addVertex(scrap, corner, across / area, glm::vec2(0.0F), color));
    }
    group.stage.add(mesh, scrap);
  }
  group.finish(std::move(mesh), group.material("confetti"));
}

}  // namespace macula::scene::medley
