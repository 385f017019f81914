// Groups of the medleys that have a shape: glass, strands, shells.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/scene/procedural/circle.h"
#include "engine/scene/procedural/in_ball.h"
#include "engine/scene/procedural/medley_parts.h"
#include "engine/scene/procedural/mesh_builder.h"
#include "engine/scene/procedural/patch.h"
#include "engine/scene/procedural/ribbon.h"

namespace macula::scene::medley {
namespace {

constexpr float kAboveFloor = 0.002F;  // metres, so that nothing shares the floor's plane
constexpr int kSegments = 16;          // around a vessel

/// A hollow vessel of height 1 whose belly is drawn at random.
Primitive vessel(Random& random) {
  const std::array<glm::vec2, 4> belly{
      glm::vec2{0.0F, random.range(0.14F, 0.32F)}, glm::vec2{0.35F, random.range(0.14F, 0.42F)},
      glm::vec2{0.7F, random.range(0.10F, 0.36F)}, glm::vec2{1.0F, random.range(0.10F, 0.3F)}};
  constexpr int kRings = 6;
  std::vector<glm::vec2> outer{{0.0F, 0.01F}, {0.85F * belly[0].y, 0.0F}, {belly[0].y, 0.03F}};
  for (int i = 1; i <= kRings; ++i) {
    const float y = static_cast<float>(i) / kRings;
    outer.emplace_back(curveAt(belly, y), y);
  }
  constexpr float kWall = 0.02F;
  constexpr float kBottom = 0.05F;
  Primitive mesh;
  addVessel(mesh, outer, kWall, kBottom, kSegments);
  return mesh;
}

Primitive box(Random& random) {
  const float x = random.range(0.15F, 0.4F);
  const float z = random.range(0.1F, 0.4F);
  Primitive mesh;
  addBevelledBox(mesh, {-x, 0.0F, -z}, {x, random.range(0.4F, 1.0F), z}, 0.02F);
  return mesh;
}

Primitive ball(Random& random) {
  const float radius = random.range(0.25F, 0.45F);
  Primitive mesh;
  addSphere(mesh, {0.0F, radius, 0.0F}, radius, 20);
  return mesh;
}

/// A quadratic curve (Bezier) that a strand follows.
struct Curve {
  glm::vec3 a, b, c;
  [[nodiscard]] glm::vec3 at(float t) const {
    const float s = 1.0F - t;
    return s * s * a + 2.0F * s * t * b + t * t * c;
  }
};

enum StrandForm : std::uint32_t { Tuft, Tassel, Wound, Stream, StrandForms };

/// In units of the group's size, about its foot.
Curve strandOf(StrandForm form, float stray, Random& random) {
  const glm::vec3 p = inBall(random);
  const glm::vec3 q = inBall(random);
  const glm::vec3 level(1.0F, 0.0F, 1.0F);
  switch (form) {
    case Tuft: {
      const glm::vec3 foot = 0.7F * p * level;
      const float height = random.range(0.9F, 2.0F);
      const glm::vec3 up(0.0F, height, 0.0F);
      return {foot, foot + 0.6F * up + 0.2F * q * level, foot + 0.8F * up + (0.3F + stray) * q};
    }
    case Tassel: {
      const glm::vec3 top = glm::vec3(0.0F, 2.2F, 0.0F) + 0.35F * p * level;
      const glm::vec3 down(0.0F, random.range(1.0F, 2.0F), 0.0F);
      return {top, top - 0.5F * down + 0.3F * stray * q, top - down + stray * q * level};
    }
    case Wound: {
      const glm::vec3 middle(0.0F, 1.0F, 0.0F);
      const glm::vec3 from = 0.9F * direction(random);
      const glm::vec3 to = glm::normalize(from + 0.9F * perpendicular(from / 0.9F, random));
      return {middle + from, middle + (0.7F + 0.4F * stray) * (from + to), middle + 0.9F * to};
    }
    default: {  // Stream
      const glm::vec3 middle(0.0F, 1.0F, 0.0F);
      const glm::vec3 side(1.6F, 0.0F, 0.0F);
      return {middle - side + 0.4F * p, middle + (0.4F + stray) * q,
              middle + side + 0.4F * inBall(random)};
    }
  }
}

}  // namespace

void addGlass(Group& group) {
  Random& random = group.random;
  enum Form : std::uint32_t { Vessels, Boxes, Balls, Mixed, Forms };
  const std::uint32_t form = random.below(Forms);
  std::vector<Primitive> models;
  std::size_t largest = 1;
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t kind = form == Mixed ? i % Mixed : form;
    models.push_back(kind == Vessels ? vessel(random) : kind == Boxes ? box(random) : ball(random));
    largest = std::max(largest, models.back().indices.size() / 3);
  }
  const float walls = form == Vessels ? 4.0F : 2.0F;
  const int rows = static_cast<int>(std::clamp(group.layers / walls, 2.0F, 9.0F));
  const int columns = 3 + static_cast<int>(random.below(4));
  const int levels = 1 + static_cast<int>(random.below(3));
  const int most = std::max(group.stage.room(largest), 1);
  const float step = 2.2F * group.size / static_cast<float>(std::max(rows, columns));
  const float height = std::min(1.3F * step, 1.6F * group.size / static_cast<float>(levels));
  const Alphas alphas = group.alphas(0.1F, 0.6F);
  const bool transmits = group.lit && random.below(4) == 0;
  Primitive mesh;
  int placed = 0;
  for (int level = 0; level < levels; ++level) {
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns && placed < most; ++column) {
        const glm::vec3 jitter = 0.18F * step * inBall(random);
        const float turns = random.unit();
        const glm::vec3 color = group.palette.color(random);
        const float alpha = alphas.pick(random);
        const std::uint32_t model = random.below(static_cast<std::uint32_t>(models.size()));
        if (random.below(7) == 0) continue;  // a gap
        const glm::vec3 at =
            group.foot +
            glm::vec3((static_cast<float>(column) - 0.5F * static_cast<float>(columns - 1)) * step,
                      kAboveFloor + static_cast<float>(level) * 1.1F * height,
                      (0.5F * static_cast<float>(rows - 1) - static_cast<float>(row)) * step) +
            jitter * glm::vec3(1.0F, 0.0F, 1.0F);
        Primitive piece;
        append(piece, models[model], place(at, turns, height * random.range(0.75F, 1.0F)));
        // Light through a transmissive wall takes its colour; its alpha is that of the surface.
        paint(piece, transmits ? glm::vec4(glm::mix(color, glm::vec3(1.0F), 1.0F - alpha), 1.0F)
                               : glm::vec4(color, alpha));
        placed += group.stage.add(mesh, piece) ? 1 : 0;
      }
    }
  }
  Material material = group.material("glass");
  material.roughness = random.range(0.06F, 0.3F);
  if (transmits) material.transmission = random.range(0.7F, 1.0F);
  group.finish(std::move(mesh), material);
}

void addStrands(Group& group) {
  Random& random = group.random;
  const auto form = static_cast<StrandForm>(random.below(StrandForms));
  constexpr int kPieces = 6;  // quads of a strand
  const float stray = random.range(0.1F, 0.8F);
  const Alphas alphas = group.alphas(0.1F, 0.8F);
  const float length = group.size * (form == Stream ? 3.3F : 1.4F);
  const float over = group.size * group.size * (form == Tassel ? 1.0F : 2.0F);
  // As many as are wanted of a thin kind; where triangles are too few for that, of a wider one.
  constexpr float kWidest = 0.03F;
  const float thin = random.range(0.003F, 0.016F);
  const float needed = group.layers * over /
                       (static_cast<float>(group.stage.room(2 * kPieces)) * length * group.size);
  const float halfWidth = group.size * std::min(std::max(thin, needed), kWidest);
  // Shown: 2 half-widths, 0.77 of them left by the taper, 0.64 of those by turning at random.
  const int count = group.pieces(halfWidth * length, over, 2 * kPieces);
  Primitive mesh;
  std::array<RibbonPoint, kPieces + 1> points;
  for (int i = 0; i < count; ++i) {
    const Curve curve = strandOf(form, stray, random);
    const glm::vec3 leaving = curve.b - curve.a;
    const glm::vec3 color = group.palette.color(random);
    const float alpha = alphas.pick(random);
    const float reach = glm::length(leaving);
    if (reach < 0.05F) continue;  // it would turn on the spot
    for (std::size_t k = 0; k < points.size(); ++k) {
      const float t = static_cast<float>(k) / kPieces;
      points[k].center = group.foot + group.size * curve.at(t);
      points[k].center.y = std::max(points[k].center.y, kAboveFloor);
      points[k].halfWidth = halfWidth * (1.0F - 0.7F * t * t);
    }
    points[0].side = perpendicular(leaving / reach, random);
    if (!carrySides(points)) continue;
    Primitive strand;
    addRibbon(strand, points, glm::vec4(color, alpha));
    group.stage.add(mesh, strand);
  }
  group.finish(std::move(mesh), group.material("strands"));
}

void addShells(Group& group) {
  Random& random = group.random;
  constexpr float kMostShells = 30.0F;
  constexpr int kAround = 28;  // segments
  const int count = static_cast<int>(std::clamp(0.5F * group.layers, 3.0F, kMostShells));
  const Alphas alphas = group.alphas(0.05F, 0.5F);
  const float squeeze = random.range(0.7F, 1.2F);
  const float wander = random.below(2) == 0 ? 0.0F : 0.8F;  // share of the gap between two shells
  const float gap = group.size / static_cast<float>(count);
  glm::vec3 center = group.foot + glm::vec3(0.0F, kAboveFloor + squeeze * group.size, 0.0F);
  Primitive unit;
  addSphere(unit, glm::vec3(0.0F), 1.0F, kAround);
  Primitive mesh;
  for (int i = 0; i < count; ++i) {
    const float radius = group.size - gap * static_cast<float>(i);
    glm::mat4 transform(1.0F);
    for (int axis = 0; axis < 3; ++axis) transform[axis] *= radius * (axis == 1 ? squeeze : 1.0F);
    transform[3] = glm::vec4(center, 1.0F);
    Primitive shell;
    append(shell, unit, transform);
    paint(shell, glm::vec4{group.palette.color(random), alphas.pick(random)});
    group.stage.add(mesh, shell);
    center += wander * gap * squeeze * inBall(random);
  }
  Material material = group.material("shells");
  material.doubleSided = random.below(3) != 0;
  group.finish(std::move(mesh), material);
}

}  // namespace macula::scene::medley
