// Colours, coverages and the stage of the medleys.
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/scene/procedural/circle.h"
#include "engine/scene/procedural/in_ball.h"
#include "engine/scene/procedural/medley_parts.h"
#include "engine/scene/procedural/mesh_builder.h"

namespace macula::scene::medley {
namespace {

constexpr int kCountingSize = 256;  // pixels: depths are aimed at, not promised to the layer

/// A saturated colour by its hue in turns (the hexcone of Smith 1978).
glm::vec3 hueColor(float hue) {
  const float h = 6.0F * (hue - std::floor(hue));
  return glm::clamp(
      glm::vec3(std::abs(h - 3.0F) - 1.0F, 2.0F - std::abs(h - 2.0F), 2.0F - std::abs(h - 4.0F)),
      0.0F, 1.0F);
}

enum PaletteKind : std::uint32_t { Saturated, OneHue, Grey, White, Black, Opposed, PaletteKinds };
enum AlphaKind : std::uint32_t { Equal, Spread, FewHigh, AlphaKinds };

}  // namespace

Palette::Palette(Random& random) : kind_(random.below(PaletteKinds)), hue_(random.unit()) {}

glm::vec3 Palette::color(Random& random) const {
  const float u = random.unit();
  const float v = random.unit();
  switch (kind_) {
    case Saturated:
      return glm::mix(hueColor(u), glm::vec3(0.5F), 0.2F * v);
    case OneHue:
      return hueColor(hue_ + 0.1F * u) * (0.25F + 0.75F * v) + 0.1F * (1.0F - v);
    case Grey:
      return glm::vec3(0.12F + 0.6F * u);
    case White:
      return glm::mix(glm::vec3(0.9F), hueColor(hue_), 0.1F * u);
    case Black:
      return glm::mix(glm::vec3(0.01F), hueColor(hue_), 0.06F * u);
    default:  // Opposed
      return u < 0.5F ? glm::mix(hueColor(hue_), glm::vec3(1.0F), 0.3F * v)
                      : 0.5F * hueColor(hue_ + 0.5F) * v;
  }
}

Alphas::Alphas(float low, float high, Random& random)
    : low_(low), high_(high), only_(random.range(low, high)), kind_(random.below(AlphaKinds)) {}

float Alphas::pick(Random& random) const {
  const float u = random.unit();
  const float v = random.unit();
  if (kind_ == Equal) return only_;
  if (kind_ == Spread) return glm::mix(low_, high_, u);
  constexpr float kHighShare = 0.15F;
  return u < kHighShare ? high_ : glm::mix(low_, high_, 0.25F * v);
}

glm::vec3 direction(Random& random) {
  for (;;) {
    const glm::vec3 p = inBall(random);
    const float length = glm::length(p);
    if (length > 0.1F) return p / length;  // nearer to the middle, rounding would show
  }
}

glm::vec3 perpendicular(const glm::vec3& v, Random& random) {
  const glm::vec3 other = std::abs(v.y) < 0.9F ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 u = glm::normalize(glm::cross(v, other));
  const glm::vec2 turned = onCircle(random.unit());
  return u * turned.x + glm::cross(v, u) * turned.y;
}

Stage::Stage(std::string name, const Camera& camera, float tanHalfFov, int depthLimit)
    : builder_(std::move(name)),
      camera_(camera),
      counter_(camera, tanHalfFov, kCountingSize),
      depthLimit_(depthLimit) {}

void Stage::addOpaque(Primitive mesh, std::int32_t material) {
  left_ -= static_cast<int>(mesh.indices.size() / 3);
  counter_.occlude(mesh, glm::mat4(1.0F));
  builder_.addOnce(std::move(mesh), material);
}

void Stage::share(std::size_t groups) {
  ofGroup_ = left_ / static_cast<int>(groups);
}

int Stage::room(std::size_t trianglesEach) const {
  return ofGroup_ / static_cast<int>(trianglesEach);
}

bool Stage::add(Primitive& group, const Primitive& piece) {
  const auto triangles = static_cast<int>(piece.indices.size() / 3);
  if (triangles > ofGroup_) return false;
  if (!counter_.addWithin(piece, glm::mat4(1.0F), depthLimit_)) return false;
  ofGroup_ -= triangles;
  left_ -= triangles;
  append(group, piece, glm::mat4(1.0F));
  return true;
}

glm::vec3 Group::scatter() {
  const glm::vec3 p = inBall(random);
  return p * glm::mix(1.0F, 1.3F * random.unit(), looseness);
}

Alphas Group::alphas(float low, float high) {
  constexpr float kShallow = 12.0F;  // layers through which any alpha lets something be seen
  const bool faint = random.below(4) != 0;
  const float share = faint ? std::min(kShallow / layers, 1.0F) : 1.0F;
  return {low, glm::mix(low, high, share * random.range(0.4F, 1.0F)), random};
}

Material Group::material(const char* name) {
  Material material = plainMaterial(name, glm::vec4(1.0F), random.range(0.1F, 0.9F));
  material.alphaMode = AlphaMode::Blend;
  material.doubleSided = true;
  material.unlit = !lit;
  return material;
}

int Group::pieces(float area, float over, std::size_t trianglesEach) const {
  return std::clamp(static_cast<int>(layers * over / area), 1, stage.room(trianglesEach));
}

void Group::finish(Primitive mesh, const Material& material) const {
  stage.builder().addOnce(std::move(mesh), stage.builder().material(material));
}

}  // namespace macula::scene::medley
