#include <cmath>
#include <utility>

#include "engine/scene/procedural/gallery_parts.h"
#include "engine/scene/procedural/recipes.h"
#include "engine/scene/procedural/textures.h"

namespace macula::scene {
namespace gallery {

Palette makePalette(SceneBuilder& builder, std::uint64_t seed) {
  constexpr int kImageSize = 256;
  const auto textured = [&](const char* name, Image image, float roughness) {
    Material material = plainMaterial(name, glm::vec4(1.0F), roughness);
    material.baseColorTexture.image = builder.image(std::move(image));
    return builder.material(std::move(material));
  };
  const auto plain = [&](const char* name, const glm::vec3& color, float roughness,
                         float metallic) {
    return builder.material(plainMaterial(name, glm::vec4(color, 1.0F), roughness, metallic));
  };
  Palette palette{};
  palette.marble = textured("marble", marbleTiles(kImageSize, seed), 0.35F);
  palette.wood = textured("wood", woodBoards(kImageSize, seed), 0.5F);
  palette.plaster = textured("plaster", plaster(kImageSize, seed), 0.95F);
  palette.stone = plain("stone", {0.66F, 0.61F, 0.54F}, 0.75F, 0.0F);
  // Metals are only partly metallic: without an environment there is little for them to mirror.
  palette.bronze = plain("bronze", {0.36F, 0.22F, 0.11F}, 0.38F, 0.5F);
  palette.brass = plain("brass", {0.72F, 0.49F, 0.20F}, 0.4F, 0.5F);
  palette.fabric = plain("felt", {0.05F, 0.10F, 0.16F}, 0.95F, 0.0F);
  palette.leather = plain("leather", {0.22F, 0.055F, 0.04F}, 0.5F, 0.0F);
  palette.pottery = plain("pottery", {0.50F, 0.21F, 0.11F}, 0.8F, 0.0F);
  return palette;
}

namespace {

void addLights(SceneBuilder& builder) {
  constexpr glm::vec3 kLamp{1.0F, 0.74F, 0.46F};
  builder.light(sun({-0.76F, -0.60F, -0.24F}, {1.0F, 0.86F, 0.66F}, 9.0F));
  builder.light(pointLight({0.0F, 4.1F, 4.0F}, kLamp, 9.0F, 14.0F));
  builder.light(pointLight({0.0F, 4.1F, -6.0F}, kLamp, 9.0F, 14.0F));
  builder.light(
      pointLight(kBowlPlace + glm::vec3(0.0F, 1.25F, 0.0F), {1.0F, 0.42F, 0.14F}, 2.5F, 6.0F));
  // Daylight that the windows scatter into the room, from their middle.
  builder.light(pointLight({5.2F, 3.4F, 0.0F}, {0.60F, 0.78F, 1.0F}, 8.0F, 16.0F));
  builder.light(spotLight({-3.6F, 5.0F, 0.0F}, {-6.0F, 2.2F, 0.0F}, kLamp, 22.0F, 0.6F));
  builder.ambient({0.17F, 0.19F, 0.23F});
}

void addCameras(SceneBuilder& builder) {
  Camera camera;
  camera.name = "scene";
  camera.position = {-0.3F, 1.62F, 7.3F};
  camera.target = {0.2F, 1.46F, 0.0F};
  camera.verticalFov = 0.96F;  // 55 degrees: wide enough for a room, without stretched edges
  camera.farPlane = 60.0F;
  builder.camera(camera);

  // Around the bowl inside the columns.
  camera.name = "orbit";
  camera.target = kBowlPlace + glm::vec3(0.0F, 1.3F, 0.0F);
  camera.position = camera.target + glm::vec3(0.0F, 0.75F, 3.4F);
  builder.camera(camera);
}

}  // namespace
}  // namespace gallery

Scene makeGallery(std::uint64_t seed) {
  SceneBuilder builder("gallery");
  const gallery::Palette palette = gallery::makePalette(builder, seed);
  gallery::addHall(builder, palette, seed);
  gallery::addFurniture(builder, palette, seed);
  gallery::addGlass(builder, palette, seed);
  gallery::addPlantsAndSmoke(builder, palette, seed);
  gallery::addLights(builder);
  gallery::addCameras(builder);
  return std::move(builder).finish();
}

}  // namespace macula::scene
