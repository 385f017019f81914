#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <span>
#include <utility>
#include <vector>

#include "engine/core/random.h"
#include "engine/scene/procedural/circle.h"
#include "engine/scene/procedural/depth_counter.h"
#include "engine/scene/procedural/hair_head.h"
#include "engine/scene/procedural/in_ball.h"
#include "engine/scene/procedural/mesh_builder.h"
#include "engine/scene/procedural/recipes.h"
#include "engine/scene/procedural/ribbon.h"

namespace macula::scene {
namespace {

constexpr int kDepthLimit = 92;      // maximum depth of the beard of Vasilakis 2017
constexpr int kCountingSize = 1024;  // pixels; the size at which the depth is promised
constexpr float kTanHalfFov = 0.3F;
// Strands tried; those that would exceed the limit are left out.
constexpr int kBeard = 2300;
constexpr int kMane = 3100;
constexpr int kWhiskers = 420;
constexpr int kBrows = 260;
constexpr float kThickness = 0.0019F;  // half the width of a strand, metres

/// A cubic curve (Bezier).
struct Curve {
  glm::vec3 a, b, c, d;
  [[nodiscard]] glm::vec3 at(float t) const {
    const float s = 1.0F - t;
    return s * s * s * a + 3.0F * s * s * t * b + 3.0F * s * t * t * c + t * t * t * d;
  }
};

/// The skin in a direction from the middle of the skull: position and normal.
struct Root {
  glm::vec3 position, normal;
};

Root rootAt(const glm::vec3& direction) {
  const glm::vec3 onSkull = head::kRadii * glm::normalize(direction / head::kRadii);
  return {head::kCenter + onSkull, glm::normalize(onSkull / (head::kRadii * head::kRadii))};
}

/// Grows strands where the promised depth allows.
class Barber {
 public:
  Barber(const Camera& camera, std::uint64_t seed)
      : counter_(camera, kTanHalfFov, kCountingSize), random_(seed, 61) {}

  void noteOpaque(const Primitive& mesh) { counter_.occlude(mesh, glm::mat4(1.0F)); }
  Random& random() { return random_; }

  /// A strand along curves that continue each other, waving by `wave` metres.
  void grow(std::span<const Curve> curves, int pointsEach, float wave, const glm::vec3& color) {
    const glm::vec3 root = curves.front().a;
    const glm::vec3 leaving = curves.front().b - root;
    const glm::vec3 jitter = inBall(random_);
    // Across the plane in which the strand bends, so that it lies flat on what it falls over.
    const glm::vec3 across = glm::normalize(glm::cross(leaving, curves.back().d - root));
    const glm::vec3 side = glm::normalize(across + 0.5F * jitter);
    const float phase = random_.unit();
    const float waves = random_.range(1.5F, 3.5F);
    const float alpha = random_.range(0.15F, 0.5F);
    const float thickness = kThickness * random_.range(0.75F, 1.25F);
    const auto steps = static_cast<float>(pointsEach);
    points_.clear();
    for (std::size_t k = 0; k < curves.size(); ++k) {
      for (int i = k == 0 ? 0 : 1; i <= pointsEach; ++i) {
        const float t = static_cast<float>(i) / steps;
        const float along = (static_cast<float>(k) + t) / static_cast<float>(curves.size());
        const float swing =
            wave * 4.0F * along * (1.0F - along) * onCircle(phase + waves * along).y;
        points_.push_back(
            {curves[k].at(t) + across * swing, side, thickness * (1.0F - 0.7F * along * along)});
      }
    }
    if (!carrySides(points_)) return;
    Primitive strand;
    addRibbon(strand, points_, glm::vec4(color, alpha));
    if (counter_.addWithin(strand, glm::mat4(1.0F), kDepthLimit)) {
      append(hair_, strand, glm::mat4(1.0F));
    }
  }

  [[nodiscard]] Primitive takeHair() { return std::move(hair_); }

 private:
  DepthCounter counter_;
  Random random_;
  Primitive hair_;
  std::vector<RibbonPoint> points_;
};

/// Ginger with some grey; linear.
glm::vec3 hairColor(Random& random, float grey) {
  const glm::vec3 dark{0.30F, 0.09F, 0.03F};
  const glm::vec3 light{0.88F, 0.42F, 0.13F};
  const glm::vec3 silver{0.72F, 0.70F, 0.66F};
  const glm::vec3 ginger = glm::mix(dark, light, random.unit());
  return random.unit() < grey ? silver * random.range(0.7F, 1.0F) : ginger;
}

/// From cheeks and chin through the ring, and apart again below it.
void growBeard(Barber& barber) {
  Random& random = barber.random();
  for (int i = 0; i < kBeard; ++i) {
    // Turns from the front to the ear; the sides begin higher than the chin.
    const float azimuth = random.range(-0.24F, 0.24F);
    const float height = random.range(-1.0F, -0.28F) + 4.0F * azimuth * azimuth;
    const glm::vec2 around = onCircle(azimuth);
    const Root root = rootAt({around.y, height, around.x});
    const glm::vec3 spread = inBall(random) * head::kTieRadius * glm::vec3(0.62F, 0.0F, 0.62F);
    const glm::vec3 tie = head::kTie + spread;
    const float tail = random.range(0.14F, 0.38F);
    const glm::vec3 flare = 3.6F * spread + inBall(random) * 0.05F;
    const glm::vec3 end = tie + glm::vec3(flare.x, -tail, 0.6F * flare.z);
    const float bulge = random.range(0.16F, 0.32F);
    const std::array<Curve, 2> curves{
        Curve{root.position, root.position + root.normal * bulge,
              tie + 2.2F * spread + glm::vec3(0.0F, 0.30F, 0.03F), tie},
        Curve{tie, tie - glm::vec3(0.0F, 0.35F * tail, 0.0F), end + glm::vec3(0, 0.4F * tail, 0),
              end}};
    barber.grow(curves, 9, 0.012F, hairColor(random, 0.10F));
  }
}

/// Combed back from the forehead, down to the shoulders behind the ears.
void growMane(Barber& barber) {
  Random& random = barber.random();
  for (int i = 0; i < kMane; ++i) {
    const float azimuth = random.range(-0.5F, 0.5F);
    const float fromFront = azimuth < 0.0F ? -azimuth : azimuth;
    // The hairline: high over the forehead, down to the nape behind the ears.
    const float hairline = fromFront < 0.2F ? 0.75F : (fromFront < 0.3F ? 0.3F : -0.35F);
    const float height = random.range(hairline, 2.6F);
    const glm::vec2 around = onCircle(azimuth);
    const Root root = rootAt({around.y, height, around.x});
    const float outwards = root.position.x < 0.0F ? -1.0F : 1.0F;
    const float length = random.range(0.35F, 0.95F);
    const glm::vec3 lift = root.position + root.normal * random.range(0.12F, 0.30F);
    // At the sides it stands off the head; at the back it hangs straight down.
    const bool back = fromFront > 0.36F;
    const float asideEnd = back ? 1.15F * root.position.x : outwards * random.range(0.28F, 0.62F);
    const float asideFall = back ? 1.3F * root.position.x : outwards * random.range(0.42F, 0.62F);
    const float behind = back ? 0.25F : 0.0F;
    const glm::vec3 end{asideEnd, root.position.y - length, -random.range(0.15F, 0.55F) - behind};
    const glm::vec3 fall{asideFall, root.position.y - 0.25F * length,
                         -random.range(0.25F, 0.6F) - behind};
    const std::array<Curve, 1> curves{Curve{root.position, lift, fall, end}};
    barber.grow(curves, 14, 0.03F, hairColor(random, 0.16F));
  }
}

/// From under the nose outwards, curled up at the ends.
void growWhiskers(Barber& barber) {
  Random& random = barber.random();
  for (int i = 0; i < kWhiskers; ++i) {
    const float side = i % 2 == 0 ? -1.0F : 1.0F;
    const glm::vec3 loose = inBall(random);
    const glm::vec3 from{side * random.range(0.01F, 0.15F), 1.36F + 0.025F * loose.y, 0.40F};
    const glm::vec3 tip{side * (0.60F + 0.03F * loose.x), 1.44F + 0.03F * loose.y,
                        0.42F + 0.03F * loose.z};
    const float reach = random.range(0.85F, 1.0F);
    const glm::vec3 sag{side * 0.30F, 1.22F + 0.06F * loose.z, 0.60F};
    const glm::vec3 turn{side * 0.62F, 1.17F + 0.05F * loose.x, 0.52F};
    const glm::vec3 end = glm::mix(turn, tip, reach);
    const std::array<Curve, 1> curves{Curve{from, sag, turn, end}};
    barber.grow(curves, 14, 0.008F, hairColor(random, 0.06F));
  }
}

void growBrows(Barber& barber) {
  Random& random = barber.random();
  for (int i = 0; i < kBrows; ++i) {
    const float side = i % 2 == 0 ? -1.0F : 1.0F;
    const float x = random.range(0.06F, 0.24F);
    const glm::vec3 loose = inBall(random);
    const glm::vec3 from{side * x, 1.70F + 0.015F * loose.y - 0.6F * (x - 0.14F) * (x - 0.14F),
                         0.405F - 0.5F * x * x};
    const glm::vec3 end = from + glm::vec3(side * random.range(0.05F, 0.11F),
                                           0.035F + 0.03F * loose.x, 0.02F + 0.02F * loose.z);
    const glm::vec3 out{0.0F, 0.02F, 0.05F};
    const std::array<Curve, 1> curves{
        Curve{from, from + out, glm::mix(from, end, 0.6F) + 0.8F * out, end}};
    barber.grow(curves, 6, 0.002F, 0.8F * hairColor(random, 0.05F));
  }
}

}  // namespace

Scene makeHair(std::uint64_t seed) {
  SceneBuilder builder("hair");
  Camera camera;
  camera.name = "scene";
  camera.position = {0.85F, 1.5F, 3.15F};
  camera.target = {0.0F, 1.17F, 0.08F};
  camera.verticalFov = 2.0F * std::atan(kTanHalfFov);
  camera.farPlane = 20.0F;
  builder.camera(camera);
  camera.name = "orbit";
  builder.camera(camera);

  Barber barber(camera, seed);
  for (const std::uint32_t shape : head::addHead(builder, seed)) {
    barber.noteOpaque(builder.mesh(shape));
  }
  growMane(barber);
  growBrows(barber);
  growBeard(barber);
  growWhiskers(barber);
  Material strands = plainMaterial("hair", glm::vec4(1.0F), 0.38F);
  strands.alphaMode = AlphaMode::Blend;
  strands.doubleSided = true;
  builder.addOnce(barber.takeHair(), builder.material(strands));

  builder.light(sun({-0.5F, -0.65F, -0.6F}, {1.0F, 0.95F, 0.87F}, 2.8F));
  builder.light(pointLight({-1.8F, 1.7F, 1.2F}, {0.5F, 0.68F, 1.0F}, 2.5F, 8.0F));
  builder.light(pointLight({1.7F, 2.3F, -1.2F}, {1.0F, 0.7F, 0.45F}, 3.2F, 8.0F));
  builder.light(
      spotLight({0.3F, 3.6F, 1.6F}, {0.0F, 1.2F, 0.2F}, {1.0F, 0.98F, 0.94F}, 6.0F, 0.4F));
  builder.ambient({0.15F, 0.16F, 0.18F});
  return std::move(builder).finish();
}

}  // namespace macula::scene
