#include <utility>

#include "engine/scene/procedural/car_parts.h"
#include "engine/scene/procedural/recipes.h"

namespace macula::scene {
namespace car {

Palette makePalette(SceneBuilder& builder, std::uint64_t seed) {
  constexpr int kLiverySize = 1024;  // 4 mm of the car a pixel
  constexpr int kGroundSize = 512;
  const auto textured = [&](const char* name, Image image, float roughness) {
    Material material = plainMaterial(name, glm::vec4(1.0F), roughness);
    material.baseColorTexture.image = builder.image(std::move(image));
    return builder.material(std::move(material));
  };
  const auto plain = [&](const char* name, const glm::vec3& color, float roughness,
                         float metallic = 0.0F) {
    return builder.material(plainMaterial(name, glm::vec4(color, 1.0F), roughness, metallic));
  };
  Palette palette{};
  palette.paint = textured("paint", livery(kLiverySize, seed), 0.28F);
  palette.cobbles = textured("cobbles", cobbles(kGroundSize, seed), 0.8F);
  palette.bricks = textured("bricks", bricks(kGroundSize, seed), 0.9F);
  palette.plate = textured("plate", numberPlate(256, 64, seed), 0.5F);
  palette.glass = plain("dark glass", {0.012F, 0.018F, 0.022F}, 0.12F);
  palette.rubber = plain("rubber", {0.022F, 0.022F, 0.024F}, 0.75F);
  // Metals are only partly metallic: without an environment there is little for them to mirror.
  palette.chrome = plain("chrome", {0.72F, 0.73F, 0.75F}, 0.22F, 0.4F);
  palette.alloy = plain("alloy", {0.62F, 0.58F, 0.48F}, 0.32F, 0.4F);
  palette.steel = plain("steel", {0.10F, 0.10F, 0.11F}, 0.4F, 0.4F);
  palette.dark = plain("dark", {0.015F, 0.015F, 0.017F}, 0.6F);
  palette.lamp = plain("lamp", {0.80F, 0.82F, 0.78F}, 0.12F);
  palette.amber = plain("amber", {0.80F, 0.32F, 0.03F}, 0.2F);
  palette.red = plain("red", {0.55F, 0.03F, 0.02F}, 0.25F);
  palette.stone = plain("stone", {0.42F, 0.39F, 0.34F}, 0.85F);
  palette.timber = plain("timber", {0.30F, 0.20F, 0.12F}, 0.75F);
  palette.bark = plain("bark", {0.16F, 0.12F, 0.085F}, 0.9F);
  Material leaves = plainMaterial("leaves", glm::vec4(1.0F), 0.55F);
  leaves.doubleSided = true;
  palette.leaves = builder.material(std::move(leaves));
  return palette;
}

}  // namespace car

Scene makeCar(std::uint64_t seed) {
  constexpr int kShadowTaps = 9;  // Yang 2008, section 4: shadow map queries of 9 x 9 taps
  SceneBuilder builder("car");
  const car::Palette palette = car::makePalette(builder, seed);
  car::addBody(builder, palette);
  car::addWheels(builder, palette);
  car::addFittings(builder, palette);
  car::addYard(builder, palette, seed);

  // From above the pergola and the tree, so that their shadows lie on the car.
  Light light = sun({-0.42F, -0.78F, -0.42F}, {1.0F, 0.94F, 0.84F}, 4.6F);
  light.shadowTaps = kShadowTaps;
  builder.light(light);
  builder.light(pointLight({2.6F, 3.0F, 4.2F}, {0.72F, 0.84F, 1.0F}, 9.0F, 14.0F));
  builder.ambient({0.20F, 0.23F, 0.28F});

  Camera camera;
  camera.name = "scene";
  camera.position = {3.55F, 1.68F, 4.25F};
  camera.target = {0.22F, 0.56F, 0.0F};
  camera.verticalFov = 0.80F;  // 46 degrees: the car fills a square frame
  camera.farPlane = 40.0F;
  builder.camera(camera);
  camera.name = "orbit";
  builder.camera(camera);
  return std::move(builder).finish();
}

}  // namespace macula::scene
