// Body, limbs and wings of the dragon.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/core/random.h"
#include "engine/scene/procedural/circle.h"
#include "engine/scene/procedural/marble_parts.h"
#include "engine/scene/procedural/mesh_builder.h"
#include "engine/scene/procedural/patch.h"

namespace macula::scene::marble {
namespace {

/// A place along the spine.
struct Spine {
  glm::vec3 at;    ///< metres
  float radius;    ///< metres
  glm::vec3 back;  ///< towards the ridge of the back; need not be at right angles to the spine
};

// From the tip of the tail, over the rim of the plinth, around it, and up to the head.
constexpr std::array kSpine{Spine{{0.60F, 0.17F, 0.50F}, 0.010F, {0.7F, 0.2F, 0.7F}},
                            Spine{{0.56F, 0.34F, 0.47F}, 0.022F, {0.7F, 0.2F, 0.7F}},
                            Spine{{0.40F, 0.45F, 0.42F}, 0.038F, {0.2F, 1.0F, 0.2F}},
                            Spine{{0.06F, 0.455F, 0.50F}, 0.050F, {0.0F, 1.0F, 0.1F}},
                            Spine{{-0.38F, 0.475F, 0.34F}, 0.066F, {0.0F, 1.0F, 0.0F}},
                            Spine{{-0.48F, 0.495F, -0.12F}, 0.084F, {0.0F, 1.0F, 0.0F}},
                            Spine{{-0.16F, 0.515F, -0.46F}, 0.102F, {0.0F, 1.0F, 0.0F}},
                            Spine{{0.30F, 0.540F, -0.34F}, 0.124F, {0.1F, 1.0F, 0.0F}},
                            Spine{{0.38F, 0.600F, 0.03F}, 0.146F, {0.4F, 0.9F, 0.0F}},
                            Spine{{0.15F, 0.730F, 0.17F}, 0.160F, {0.5F, 0.8F, -0.4F}},
                            Spine{{-0.10F, 0.920F, 0.08F}, 0.166F, {0.3F, 0.3F, -1.0F}},
                            Spine{{-0.15F, 1.120F, -0.06F}, 0.150F, {0.0F, 0.2F, -1.0F}},
                            Spine{{-0.03F, 1.310F, -0.11F}, 0.112F, {-0.1F, 0.4F, -1.0F}},
                            Spine{{0.10F, 1.470F, -0.02F}, 0.086F, {0.1F, 0.8F, -0.8F}},
                            Spine{{0.11F, 1.575F, 0.13F}, 0.072F, {0.0F, 1.0F, -0.4F}},
                            Spine{{0.04F, 1.590F, 0.29F}, 0.066F, {0.0F, 1.0F, 0.0F}},
                            Spine{{-0.02F, 1.560F, 0.40F}, 0.058F, {0.0F, 1.0F, 0.2F}}};

constexpr int kRings = 250;
constexpr int kAround = 26;

/// The spine between its places, at s = 0 (tail) .. 1 (head).
struct Ring {
  glm::vec3 at, along, back, side;
  float radius;
};

glm::vec3 spineAt(float s) {
  const float scaled = s * static_cast<float>(kSpine.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(scaled), kSpine.size() - 2);
  const auto place = [](std::size_t k) { return kSpine[std::min(k, kSpine.size() - 1)].at; };
  return splineBetween(place(i > 0 ? i - 1 : 0), place(i), place(i + 1), place(i + 2),
                       scaled - static_cast<float>(i));
}

Ring ringAt(float s) {
  const float scaled = s * static_cast<float>(kSpine.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(scaled), kSpine.size() - 2);
  const float t = scaled - static_cast<float>(i);
  constexpr float kStep = 0.002F;  // of the whole, for the direction
  Ring ring{};
  ring.at = spineAt(s);
  ring.along =
      glm::normalize(spineAt(std::min(s + kStep, 1.0F)) - spineAt(std::max(s - kStep, 0.0F)));
  ring.radius = glm::mix(kSpine[i].radius, kSpine[i + 1].radius, t * t * (3.0F - 2.0F * t));
  const glm::vec3 hint = glm::mix(kSpine[i].back, kSpine[i + 1].back, t);
  ring.back = glm::normalize(hint - ring.along * glm::dot(hint, ring.along));
  ring.side = glm::cross(ring.along, ring.back);
  return ring;
}

/// How far the skin stands out, as a share of the radius: scales in diamonds on back and flanks,
/// plates across the belly.
float relief(int ring, int column) {
  constexpr float kScale = 0.085F;
  constexpr float kPlate = 0.07F;
  constexpr int kPlateRings = 4;
  // Column 0 is the ridge of the back, half way around is the belly.
  const int fromBelly = std::abs(column % kAround - kAround / 2);
  if (fromBelly <= 4) {
    const float ramp = static_cast<float>(ring % kPlateRings) / kPlateRings;
    return kPlate * ramp - (fromBelly == 4 ? 0.05F : 0.0F);
  }
  return (ring + column) % 2 == 0 ? kScale : 0.0F;
}

void addBody(Primitive& mesh) {
  Patch patch(kRings + 1, kAround + 1);
  for (int i = 0; i <= kRings; ++i) {
    const Ring ring = ringAt(static_cast<float>(i) / kRings);
    for (int j = 0; j <= kAround; ++j) {
      const glm::vec2 turned = onCircle(static_cast<double>(j) / kAround);
      // A little taller than wide, with a keel along the back.
      const float keel = turned.x > 0.0F ? 0.16F * turned.x * turned.x * turned.x * turned.x : 0.0F;
      const float r = ring.radius * (1.0F + relief(i, j) + keel);
      patch.at(i, j).position = ring.at + r * (ring.back * turned.x * 1.04F - ring.side * turned.y);
    }
  }
  addPatch(mesh, patch);
}

void addSpines(Primitive& mesh, std::uint64_t seed) {
  constexpr int kSpikes = 62;
  Random random(seed, 41);
  for (int i = 1; i < kSpikes; ++i) {
    const Ring ring = ringAt(static_cast<float>(i) / kSpikes);
    const float height = (0.45F * ring.radius + 0.028F) * random.range(0.9F, 1.1F);
    const glm::vec3 foot = ring.at + ring.back * (1.1F * ring.radius);
    addSpike(mesh, foot - ring.back * 0.02F,
             foot + ring.back * (0.6F * height) - ring.along * (0.15F * height),
             foot + ring.back * height - ring.along * (0.75F * height), 0.34F * height);
  }
}

/// A limb of tubes with a foot of claws. @param claws the way that they point
void addLimb(Primitive& mesh, const std::array<glm::vec3, 4>& joints, float radius,
             const glm::vec3& claws, const glm::vec3& spread) {
  constexpr int kSteps = 6;
  std::vector<glm::vec3> path;
  std::vector<float> radii;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::vec3& before = joints[i > 0 ? i - 1 : 0];
    const glm::vec3& after = joints[std::min<std::size_t>(i + 2, 3)];
    for (int k = 0; k < kSteps; ++k) {
      const float t = static_cast<float>(k) / kSteps;
      path.push_back(splineBetween(before, joints[i], joints[i + 1], after, t));
      const float s = (static_cast<float>(i) + t) / 3.0F;
      // Muscles: thick above the joints, thin at them.
      const float bulge = 0.16F * onCircle(1.5 * static_cast<double>(s)).y;
      radii.push_back(radius * (1.0F - 0.55F * s + bulge));
    }
  }
  path.push_back(joints[3]);
  radii.push_back(0.42F * radius);
  addTube(mesh, path, radii, 14, false);
  addSphere(mesh, joints[3], 0.52F * radius, 12);
  for (int i = -1; i <= 1; ++i) {
    const glm::vec3 aside = spread * (0.5F * static_cast<float>(i));
    const glm::vec3 toe = joints[3] + radius * (0.9F * claws + aside);
    addTube(mesh, std::vector<glm::vec3>{joints[3], toe},
            std::vector<float>{0.36F * radius, 0.30F * radius}, 8, false);
    addSphere(mesh, toe, 0.32F * radius, 8);
    const glm::vec3 drop{0.0F, -0.4F * radius, 0.0F};
    addSpike(mesh, toe, toe + radius * (0.7F * claws + 0.3F * aside) + 0.1F * drop,
             toe + radius * (1.3F * claws + 0.4F * aside) + drop, 0.27F * radius);
  }
  // A spur behind the elbow.
  const glm::vec3 outwards = glm::normalize(2.0F * joints[1] - joints[0] - joints[2]);
  addSpike(mesh, joints[1] + outwards * (0.5F * radius), joints[1] + outwards * (1.0F * radius),
           joints[1] + outwards * (1.7F * radius) + glm::vec3(0.0F, 0.4F * radius, 0.0F),
           0.32F * radius);
}

using Bone = std::array<glm::vec3, 3>;

glm::vec3 onBone(const Bone& bone, float t) {
  // A quadratic Bezier curve.
  const float s = 1.0F - t;
  return s * s * bone[0] + 2.0F * s * t * bone[1] + t * t * bone[2];
}

/// The skin between two bones: hollow, its rim drawn in between the tips.
void addSkin(Primitive& mesh, const Bone& upper, const Bone& lower, const glm::vec3& sag) {
  constexpr int kAlong = 12;
  constexpr int kAcross = 8;
  constexpr float kDrawnIn = 0.20F;
  Patch patch(kAlong + 1, kAcross + 1);
  for (int i = 0; i <= kAlong; ++i) {
    for (int j = 0; j <= kAcross; ++j) {
      const float across = static_cast<float>(j) / kAcross;
      const float hollow = 4.0F * across * (1.0F - across);
      const float t = static_cast<float>(i) / kAlong * (1.0F - kDrawnIn * hollow);
      const glm::vec3 flat = glm::mix(onBone(upper, t), onBone(lower, t), across);
      patch.at(i, j) = {flat + sag * (hollow * t), {across, t}};
    }
  }
  addPatch(mesh, patch);
}

/// @param side -1 or 1; the other wing is its mirror image about the shoulders
void addWing(Primitive& stone, Primitive& skin, float side) {
  const auto at = [side](float x, float y, float z) { return glm::vec3(-0.13F + side * x, y, z); };
  const glm::vec3 shoulder = at(0.08F, 1.12F, -0.13F);
  const glm::vec3 elbow = at(0.36F, 1.36F, -0.30F);
  const glm::vec3 wrist = at(0.56F, 1.66F, -0.24F);
  const std::array<Bone, 5> bones{
      Bone{wrist, at(0.86F, 1.86F, -0.20F), at(1.08F, 1.74F, -0.22F)},
      Bone{wrist, at(0.86F, 1.58F, -0.28F), at(1.10F, 1.27F, -0.28F)},
      Bone{wrist, at(0.72F, 1.36F, -0.34F), at(0.90F, 0.92F, -0.30F)},
      Bone{elbow, at(0.52F, 1.08F, -0.38F), at(0.58F, 0.74F, -0.34F)},
      Bone{shoulder, at(0.12F, 0.98F, -0.20F), at(0.14F, 0.86F, -0.20F)}};
  addTube(stone, std::vector<glm::vec3>{shoulder, elbow, wrist},
          std::vector<float>{0.052F, 0.040F, 0.034F}, 12, false);
  addSphere(stone, elbow, 0.046F, 12);
  addSphere(stone, wrist, 0.042F, 12);
  addSpike(stone, wrist, wrist + glm::vec3(side * 0.01F, 0.06F, 0.03F),
           wrist + glm::vec3(-side * 0.03F, 0.12F, 0.06F), 0.024F);
  const glm::vec3 sag{0.0F, 0.0F, -0.05F};
  for (std::size_t i = 0; i < bones.size(); ++i) {
    constexpr int kSteps = 8;
    std::vector<glm::vec3> path;
    std::vector<float> radii;
    for (int k = 0; k <= kSteps; ++k) {
      const float t = static_cast<float>(k) / kSteps;
      path.push_back(onBone(bones[i], t));
      radii.push_back(glm::mix(0.025F, 0.005F, t));
    }
    addTube(stone, path, radii, 8, false);
    if (i + 1 < bones.size()) addSkin(skin, bones[i], bones[i + 1], sag);
  }
  // Between elbow and wrist, behind the arm.
  addSkin(skin, {wrist, glm::mix(wrist, elbow, 0.5F), elbow}, bones[3], 0.3F * sag);
}

}  // namespace

void addSpike(Primitive& mesh, const glm::vec3& foot, const glm::vec3& middle, const glm::vec3& tip,
              float radius, int segments) {
  constexpr float kTip = 0.0008F;  // metres: not quite a point, so that its normals are sound
  addTube(mesh, std::vector<glm::vec3>{foot, middle, tip},
          std::vector<float>{radius, 0.62F * radius, kTip}, segments, false);
}

glm::mat4 headFrame() {
  const Ring end = ringAt(1.0F);
  const glm::vec3 forward = glm::normalize(end.along + glm::vec3(0.05F, 0.10F, 0.25F));
  const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0.0F, 1.0F, 0.0F), forward));
  return {glm::vec4(right, 0.0F), glm::vec4(glm::cross(forward, right), 0.0F),
          glm::vec4(forward, 0.0F), glm::vec4(end.at, 1.0F)};
}

void addDragon(Primitive& stone, Primitive& wings, std::uint64_t seed) {
  addBody(stone);
  addSpines(stone, seed);
  for (const float side : {-1.0F, 1.0F}) {
    addWing(stone, wings, side);
    // Arms around the ball.
    const glm::vec3 ball(kBall);
    addLimb(stone,
            {ball + glm::vec3(side * 0.10F, 0.10F, -0.30F),
             ball + glm::vec3(side * 0.23F, -0.02F, -0.18F),
             ball + glm::vec3(side * 0.20F, -0.07F, -0.06F),
             ball + glm::vec3(side * 0.105F, -0.03F, 0.03F)},
            0.070F, {-side * 0.45F, 0.0F, 0.75F}, {0.0F, 1.2F, 0.0F});
  }
  // A hind leg on either side of the haunches.
  addLimb(stone,
          {glm::vec3(0.40F, 0.62F, 0.10F), glm::vec3(0.60F, 0.665F, 0.20F),
           glm::vec3(0.655F, 0.50F, 0.27F), glm::vec3(0.50F, kPlinthTop + 0.05F, 0.34F)},
          0.068F, {0.35F, -0.1F, 0.9F}, {1.0F, 0.0F, -0.4F});
  addLimb(stone,
          {glm::vec3(0.18F, 0.55F, -0.22F), glm::vec3(0.04F, 0.63F, -0.12F),
           glm::vec3(-0.07F, 0.53F, 0.0F), glm::vec3(-0.12F, kPlinthTop + 0.05F, 0.12F)},
          0.074F, {-0.35F, -0.1F, 0.9F}, {1.0F, 0.0F, 0.4F});
}

}  // namespace macula::scene::marble
