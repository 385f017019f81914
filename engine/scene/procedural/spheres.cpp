#include <array>
#include <string>

#include "engine/core/random.h"
#include "engine/scene/procedural/mesh_builder.h"
#include "engine/scene/procedural/recipes.h"
#include "engine/scene/procedural/scene_builder.h"

namespace macula::scene {
namespace {

constexpr int kSide = 4;          // spheres along each axis of a cube
constexpr float kSpacing = 1.0F;  // metres
constexpr float kRadius = 0.44F;  // metres
constexpr float kJitter = 0.25F;  // metres to each side
constexpr int kSegments = 48;     // around; no outline shows its corners at 1024 pixels
constexpr float kAlpha = 0.3F;
constexpr float kDistance = 4.6F;  // from the middle: the cube fills the view

constexpr std::array<glm::vec3, 6> kColors{{{0.8F, 0.1F, 0.1F},
                                            {0.1F, 0.6F, 0.2F},
                                            {0.1F, 0.2F, 0.8F},
                                            {0.8F, 0.6F, 0.1F},
                                            {0.6F, 0.1F, 0.6F},
                                            {0.1F, 0.6F, 0.6F}}};

}  // namespace

Scene makeSpheres(std::uint64_t seed) {
  SceneBuilder builder("spheres");
  Primitive sphere;
  addSphere(sphere, glm::vec3(0.0F), kRadius, kSegments);
  std::array<std::uint32_t, kColors.size()> shapes{};
  for (std::size_t i = 0; i < kColors.size(); ++i) {
    Material material;
    material.name = "colour " + std::to_string(i + 1);
    material.baseColor = glm::vec4(kColors[i], kAlpha);
    material.alphaMode = AlphaMode::Blend;
    material.doubleSided = true;
    material.unlit = true;
    shapes[i] = builder.shape(sphere, builder.material(material));
  }
  Random random(seed);
  constexpr float kFirst = -0.5F * kSpacing * static_cast<float>(kSide - 1);
  for (int i = 0; i < kSide * kSide * kSide; ++i) {
    const glm::vec3 cell(i % kSide, i / kSide % kSide, i / (kSide * kSide));
    glm::mat4 transform(1.0F);
    for (int axis = 0; axis < 3; ++axis) {
      transform[3][axis] = kFirst + kSpacing * cell[axis] + random.range(-kJitter, kJitter);
    }
    builder.add(shapes[static_cast<std::size_t>(i) % shapes.size()], transform);
  }
  Camera camera;
  camera.name = "scene";
  camera.position = glm::vec3(0.0F, 0.0F, kDistance);
  camera.target = glm::vec3(0.0F);
  camera.nearPlane = 0.1F;
  camera.farPlane = 2.0F * kDistance;
  builder.camera(camera);
  camera.name = "still";  // `--camera auto` stays in front
  builder.camera(camera);
  return std::move(builder).finish();
}

}  // namespace macula::scene
