#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>
#include <utility>

#include "engine/core/random.h"
#include "engine/scene/procedural/medley_parts.h"
#include "engine/scene/procedural/recipes.h"

namespace macula::scene {
namespace {

using medley::Group;
using medley::Stage;

// One stream of random numbers for each thing that is drawn, so that a change of one leaves the
// others as they are. Within a stream, two numbers are never drawn as arguments of one call or as
// operands of one operator, only in braces: the order would be the compiler's.
enum Stream : std::uint64_t {
  CameraStream = 81,
  RoomStream,
  LightStream,
  ChoiceStream,
  GroupStream
};

// Layers that may lie behind one another. They and the first group are taken in turn rather than
// at random, so that any few medleys in a row differ in both.
constexpr std::array<int, 10> kDepthLimits{8, 54, 16, 104, 26, 12, 76, 38, 128, 150};

constexpr std::array<void (*)(Group&), 7> kGroups{
    medley::addPuffs,  medley::addGlass,  medley::addStrands, medley::addLeaves,
    medley::addSheets, medley::addShells, medley::addConfetti};
constexpr std::size_t kFewestGroups = 2;
constexpr std::size_t kMostGroups = 5;
// Of the frame. Where less is covered before the last group, that one is wide, and others follow.
constexpr float kLeastCoverage = 0.2F;
constexpr float kFillingLayers = 5.0F;  // that a group needs to close most of its gaps

const glm::vec3 kMiddle{0.0F, 0.9F, 0.0F};  // of the stage, metres

Camera drawCamera(Random random, float& tanHalfFov) {
  constexpr std::array<float, 3> kTangents{0.28F, 0.34F, 0.42F};
  tanHalfFov = kTangents[random.below(static_cast<std::uint32_t>(kTangents.size()))];
  const glm::vec3 side{random.range(-0.5F, 0.5F), random.range(0.05F, 0.55F), 1.0F};
  Camera camera;
  camera.name = "scene";
  camera.target = kMiddle;
  camera.position = kMiddle + random.range(3.4F, 4.4F) * glm::normalize(side);
  camera.verticalFov = 2.0F * std::atan(tanHalfFov);
  camera.nearPlane = 0.1F;
  camera.farPlane = 30.0F;
  return camera;
}

glm::vec3 lampColor(Random& random) {
  return glm::mix(glm::vec3(1.0F, 0.62F, 0.34F), glm::vec3(0.55F, 0.72F, 1.0F), random.unit());
}

/// One to three lamps; the first may be a sun.
void addLights(SceneBuilder& builder, Random random) {
  const std::uint32_t count = 1 + random.below(3);
  for (std::uint32_t i = 0; i < count; ++i) {
    const glm::vec3 color = lampColor(random);
    const float strength = random.unit();
    const glm::vec3 from{random.range(-2.2F, 2.2F), random.range(1.2F, 3.0F),
                         random.range(-1.6F, 2.4F)};
    if (i == 0 && random.below(4) != 0) {
      builder.light(sun(-from, glm::mix(color, glm::vec3(1.0F), 0.6F), 1.0F + 3.0F * strength));
    } else {
      constexpr float kRange = 14.0F;  // metres: beyond the stage
      builder.light(pointLight(from, color, 4.0F + 14.0F * strength, kRange));
    }
  }
  const glm::vec3 ambient = glm::mix(lampColor(random), glm::vec3(1.0F), 0.7F);
  builder.ambient(ambient * random.range(0.05F, 0.4F));
}

/// The groups in the order in which they are made: one in turn, then others at random.
std::array<std::size_t, kGroups.size()> drawOrderOf(int n, Random& random) {
  std::array<std::size_t, kGroups.size()> order{};
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i] = (static_cast<std::size_t>(n) + i) % order.size();
  }
  for (std::size_t i = order.size() - 1; i > 1; --i) {  // Fisher-Yates without the first
    std::swap(order[i], order[1 + random.below(static_cast<std::uint32_t>(i))]);
  }
  return order;
}

void addGroups(Stage& stage, int n, int depthLimit, bool lit) {
  Random random(static_cast<std::uint64_t>(n), ChoiceStream);
  const auto order = drawOrderOf(n, random);
  const std::size_t count = kFewestGroups + random.below(kMostGroups - kFewestGroups + 1);
  for (std::size_t i = 0; i < kMostGroups; ++i) {
    if (i >= count && stage.coverage() >= kLeastCoverage) break;
    Random own(static_cast<std::uint64_t>(n), GroupStream + i);
    const medley::Palette palette(own);
    Group group{.stage = stage, .random = own, .palette = palette};
    // The first one is large and in the middle, the others stand around and overlap it.
    const float distance = i == 0 ? 0.25F : 1.0F;
    group.foot = distance * glm::vec3{own.range(-0.9F, 0.9F), 0.0F, own.range(-1.1F, 0.7F)};
    const bool wide = own.below(4) == 0;  // it fills the frame
    group.size =
        i == 0 ? (wide ? own.range(1.4F, 1.9F) : own.range(0.85F, 1.2F)) : own.range(0.45F, 1.0F);
    group.looseness = own.unit();
    group.layers =
        static_cast<float>(depthLimit) * (i == 0 ? own.range(0.5F, 0.9F) : own.range(0.15F, 0.6F));
    if (i + 1 >= count && stage.coverage() < kLeastCoverage) {
      group.foot *= 0.3F;
      group.size *= 1.7F;
      group.layers = std::max(group.layers, kFillingLayers);
    }
    group.lit = lit && own.below(5) != 0;
    group.random = own;
    // Half of the triangles are for the first.
    stage.share(i == 0 ? 2 : std::max(count, i + 1) - i);
    kGroups[order[i]](group);
  }
}

}  // namespace

Scene makeMedley(int n) {
  const auto seed = static_cast<std::uint64_t>(n);
  float tanHalfFov = 0.0F;
  const Camera camera = drawCamera(Random(seed, CameraStream), tanHalfFov);
  const int depthLimit = kDepthLimits[static_cast<std::size_t>(n) % kDepthLimits.size()];
  Stage stage(fmt::format("medley-{}", n), camera, tanHalfFov, depthLimit);
  stage.builder().camera(camera);
  Camera orbit = camera;
  orbit.name = "orbit";
  stage.builder().camera(orbit);

  Random random(seed, RoomStream);
  const bool lit = random.below(6) != 0;
  medley::addRoom(stage, random, lit);
  addGroups(stage, n, depthLimit, lit);
  if (lit) addLights(stage.builder(), Random(seed, LightStream));
  return std::move(stage.builder()).finish();
}

}  // namespace macula::scene
