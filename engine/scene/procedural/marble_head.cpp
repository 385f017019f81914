// The dragon's head, in its own frame: x to its left, y up, z forward, the neck ends at 0.
#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "engine/scene/procedural/circle.h"
#include "engine/scene/procedural/marble_parts.h"
#include "engine/scene/procedural/mesh_builder.h"
#include "engine/scene/procedural/patch.h"

namespace macula::scene::marble {
namespace {

/// A section of the skull: where along the head, half the width, how far up and down; metres.
struct Section {
  float z, half, top, bottom;
};

constexpr std::array kSkull{
    Section{-0.05F, 0.045F, 0.045F, -0.055F}, Section{0.00F, 0.066F, 0.062F, -0.066F},
    Section{0.06F, 0.088F, 0.084F, -0.070F},  Section{0.11F, 0.094F, 0.096F, -0.052F},
    Section{0.15F, 0.082F, 0.092F, -0.030F},  Section{0.19F, 0.062F, 0.060F, -0.020F},
    Section{0.25F, 0.052F, 0.046F, -0.018F},  Section{0.31F, 0.050F, 0.044F, -0.018F},
    Section{0.35F, 0.050F, 0.056F, -0.022F},  Section{0.38F, 0.036F, 0.042F, -0.030F},
    Section{0.395F, 0.0F, 0.0F, 0.0F}};
constexpr std::array kJaw{
    Section{0.04F, 0.050F, -0.040F, -0.085F}, Section{0.10F, 0.064F, -0.050F, -0.098F},
    Section{0.18F, 0.046F, -0.078F, -0.118F}, Section{0.26F, 0.038F, -0.100F, -0.136F},
    Section{0.33F, 0.032F, -0.112F, -0.150F}, Section{0.355F, 0.0F, -0.13F, -0.13F}};

void addSections(Primitive& mesh, std::span<const Section> sections) {
  constexpr int kAround = 24;
  constexpr int kBetween = 3;
  const int spans = static_cast<int>(sections.size()) - 1;
  Patch patch(spans * kBetween + 1, kAround + 1);
  for (int i = 0; i < patch.rows(); ++i) {
    const auto k = static_cast<std::size_t>(std::min(i / kBetween, spans - 1));
    const float t = static_cast<float>(i - static_cast<int>(k) * kBetween) / kBetween;
    const Section& a = sections[k];
    const Section& b = sections[k + 1];
    const float half = glm::mix(a.half, b.half, t);
    const float middle = 0.5F * glm::mix(a.top + a.bottom, b.top + b.bottom, t);
    const float height = 0.5F * glm::mix(a.top - a.bottom, b.top - b.bottom, t);
    const float z = glm::mix(a.z, b.z, t);
    for (int j = 0; j <= kAround; ++j) {
      const glm::vec2 c = onCircle(static_cast<double>(j) / kAround);
      // Squarer than an ellipse: flat cheeks and brow.
      const float square = 1.0F + 0.30F * c.x * c.x * c.y * c.y * 4.0F * 0.5F;
      patch.at(i, j).position = {half * c.x * square, middle + height * c.y * square, z};
    }
  }
  addPatch(mesh, patch);
}

void addTeeth(Primitive& mesh) {
  constexpr int kTeeth = 8;
  for (int i = 0; i < kTeeth; ++i) {
    const float t = static_cast<float>(i) / (kTeeth - 1);
    const float length = i == kTeeth - 2 ? 0.044F : 0.026F;
    for (const float side : {-1.0F, 1.0F}) {
      const glm::vec3 upper{side * glm::mix(0.046F, 0.033F, t), -0.012F,
                            glm::mix(0.19F, 0.365F, t)};
      addSpike(mesh, upper, upper - glm::vec3(0.0F, 0.55F * length, 0.0F),
               upper - glm::vec3(0.0F, length, 0.008F), 0.0075F, 5);
      const glm::vec3 lower{side * glm::mix(0.038F, 0.024F, t), glm::mix(-0.088F, -0.118F, t),
                            glm::mix(0.19F, 0.335F, t)};
      addSpike(mesh, lower, lower + glm::vec3(0.0F, 0.55F * length, 0.0F),
               lower + glm::vec3(0.0F, length, 0.004F), 0.007F, 5);
    }
  }
}

void addHorns(Primitive& mesh) {
  for (const float side : {-1.0F, 1.0F}) {
    const auto at = [side](float x, float y, float z) { return glm::vec3(side * x, y, z); };
    // Ringed horns that sweep back and up.
    std::vector<glm::vec3> path;
    std::vector<float> radii;
    constexpr int kSteps = 24;
    for (int i = 0; i <= kSteps; ++i) {
      const float t = static_cast<float>(i) / kSteps;
      path.push_back(splineBetween(at(0.0F, -0.05F, 0.2F), at(0.050F, 0.070F, 0.07F),
                                   at(0.105F, 0.185F, -0.19F), at(0.05F, 0.42F, -0.30F), t));
      radii.push_back(glm::mix(0.029F, 0.003F, t) * (i % 2 == 0 ? 1.0F : 0.88F));
    }
    addTube(mesh, path, radii, 10, false);
    addSpike(mesh, at(0.07F, 0.04F, 0.03F), at(0.115F, 0.055F, -0.04F), at(0.16F, 0.085F, -0.12F),
             0.022F, 8);
    addSpike(mesh, at(0.075F, -0.005F, 0.03F), at(0.125F, -0.01F, -0.03F),
             at(0.165F, 0.01F, -0.10F), 0.019F, 8);
    addSpike(mesh, at(0.06F, -0.05F, 0.04F), at(0.105F, -0.07F, -0.01F), at(0.14F, -0.07F, -0.08F),
             0.017F, 8);
    // Brow and nostril.
    addSpike(mesh, at(0.045F, 0.075F, 0.175F), at(0.078F, 0.098F, 0.11F), at(0.098F, 0.12F, 0.03F),
             0.017F, 8);
    addSphere(mesh, at(0.027F, 0.044F, 0.352F), 0.020F, 10);
    // Whiskers beside the mouth.
    addTube(mesh,
            std::vector<glm::vec3>{at(0.045F, 0.0F, 0.34F), at(0.10F, -0.02F, 0.37F),
                                   at(0.15F, -0.09F, 0.36F), at(0.17F, -0.18F, 0.33F),
                                   at(0.21F, -0.24F, 0.32F)},
            std::vector<float>{0.010F, 0.008F, 0.0065F, 0.0045F, 0.0015F}, 6, false);
  }
  for (int i = 0; i < 3; ++i) {  // a beard
    const float z = 0.14F + 0.07F * static_cast<float>(i);
    const float y = -0.10F - 0.017F * static_cast<float>(i);
    addSpike(mesh, {0.0F, y, z}, {0.0F, y - 0.05F, z - 0.015F}, {0.0F, y - 0.09F, z - 0.05F},
             0.015F, 6);
  }
}

}  // namespace

void addHead(Primitive& stone, Primitive& eyes, const glm::mat4& frame) {
  Primitive head;
  addSections(head, kSkull);
  addSections(head, kJaw);
  addTeeth(head);
  addHorns(head);
  append(stone, head, frame);
  Primitive pair;
  for (const float side : {-1.0F, 1.0F})
    addSphere(pair, {side * 0.068F, 0.052F, 0.148F}, 0.021F, 16);
  append(eyes, pair, frame);
}

}  // namespace macula::scene::marble
