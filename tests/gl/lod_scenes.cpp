#include "lod_scenes.h"

#include <array>
#include <cmath>

#include "engine/scene/procedural/mesh_builder.h"
#include "engine/scene/procedural/scene_builder.h"

namespace macula::test {
namespace {

scene::SceneBuilder stillLife(bool rich) {
  scene::SceneBuilder builder("still");
  scene::Material stone = scene::plainMaterial("stone", {0.7F, 0.6F, 0.5F, 1.0F}, 0.6F);
  if (rich) stone.veins = {.color = {0.1F, 0.15F, 0.2F}, .scale = 1.5F};
  const std::int32_t ground = builder.material(stone);
  const std::int32_t paint =
      builder.material(scene::plainMaterial("paint", {0.8F, 0.1F, 0.1F, 1.0F}, 0.4F));
  scene::Primitive floor;
  scene::addQuad(floor, {-8, 0, 4}, {8, 0, 4}, {8, 0, -12}, {-8, 0, -12});
  builder.addOnce(std::move(floor), ground);
  scene::Primitive wall;
  scene::addBox(wall, {-3, 0, -4}, {3, 1.2F, -3.8F});
  builder.addOnce(std::move(wall), ground);
  scene::Primitive ball;
  scene::addSphere(ball, {0, 0.7F, -1}, 0.7F, 48);
  builder.addOnce(std::move(ball), paint);
  scene::Light sun = scene::sun({-0.5F, -0.8F, -0.3F}, {1.0F, 0.95F, 0.9F}, 3.0F);
  if (rich) sun.shadowTaps = 9;
  builder.light(sun);
  builder.ambient({0.2F, 0.22F, 0.25F});
  scene::Camera camera;
  camera.position = {0.4F, 1.3F, 3.0F};
  camera.target = {0.0F, 0.6F, -1.0F};
  camera.verticalFov = 0.8F;
  camera.farPlane = 40.0F;
  builder.camera(camera);
  return builder;
}

}  // namespace

scene::Scene still() {
  return std::move(stillLife(false)).finish();
}

scene::Scene richStill() {
  scene::Scene scene = std::move(stillLife(true)).finish();
  scene.occlusion = {.radius = 0.4F, .samples = 24};
  return scene;
}

scene::Scene wires() {
  scene::SceneBuilder builder = stillLife(false);
  const std::int32_t iron =
      builder.material(scene::plainMaterial("iron", {0.05F, 0.05F, 0.06F, 1.0F}, 0.5F));
  scene::Primitive fence;
  constexpr int kWires = 25;
  constexpr float kHalfWidth = 0.002F;  // metres; a pixel spans 8 mm there at 128 x 128
  for (int i = 0; i < kWires; ++i) {
    const float x = -0.8F + 0.0667F * static_cast<float>(i);
    scene::addBox(fence, {x - kHalfWidth, 0.3F, 0.5F}, {x + kHalfWidth, 1.6F, 0.504F});
  }
  builder.addOnce(std::move(fence), iron);
  return std::move(builder).finish();
}

scene::Scene grazing() {
  scene::SceneBuilder builder("grazing");
  const std::int32_t stone =
      builder.material(scene::plainMaterial("stone", {0.7F, 0.6F, 0.5F, 1.0F}, 0.8F));
  scene::Primitive floor;
  scene::addQuad(floor, {-20, 0, 4}, {20, 0, 4}, {20, 0, -60}, {-20, 0, -60});
  builder.addOnce(std::move(floor), stone);
  builder.light(scene::pointLight({-1.0F, 0.6F, -4.0F}, {1.0F, 0.8F, 0.6F}, 2.0F, 30.0F));
  builder.light(scene::pointLight({1.5F, 0.5F, -9.0F}, {0.5F, 0.8F, 1.0F}, 4.0F, 30.0F));
  builder.ambient({0.1F, 0.1F, 0.1F});
  scene::Camera camera;
  camera.position = {0.0F, 0.6F, 2.0F};
  camera.target = {0.0F, 0.1F, -8.0F};  // 2.9 degrees down
  camera.verticalFov = 0.25F;
  camera.farPlane = 100.0F;
  builder.camera(camera);
  return std::move(builder).finish();
}

scene::Scene litCard() {
  scene::SceneBuilder builder("lit card");
  const std::int32_t plaster =
      builder.material(scene::plainMaterial("plaster", {0.8F, 0.8F, 0.8F, 1.0F}, 1.0F));
  scene::Primitive wall;
  scene::addQuad(wall, {-3, 0, -5}, {3, 0, -5}, {3, 3, -5}, {-3, 3, -5});
  builder.addOnce(std::move(wall), plaster);
  scene::Primitive card;
  scene::addBox(card, {-0.3F, 0.9F, -2.05F}, {0.3F, 1.5F, -2.0F});
  builder.addOnce(std::move(card), plaster);
  // The sun falls by 1 in 2: what it would light of the wall above y = 0.25 passes under z = 2.5
  // at the roof's height, what it lights of the card does not.
  scene::Primitive roof;
  scene::addBox(roof, {-6, 4, -4.5F}, {6, 4.1F, 2.5F});
  builder.addOnce(std::move(roof), plaster);
  builder.light(scene::sun({0.0F, -0.5F, -1.0F}, {1.0F, 1.0F, 1.0F}, 3.0F));
  builder.ambient({0.1F, 0.1F, 0.1F});
  scene::Camera camera;
  camera.position = {0.05F, 1.25F, 2.4F};
  camera.target = {0.0F, 1.2F, -5.0F};
  camera.verticalFov = 0.26F;
  camera.farPlane = 20.0F;
  builder.camera(camera);
  return std::move(builder).finish();
}

scene::Scene swatches() {
  scene::SceneBuilder builder("swatches");
  constexpr int kTexels = 32;
  constexpr int kMetalTexels = 4;
  scene::Image greys{.name = "greys", .width = kTexels, .height = kTexels, .rgba = {}};
  std::uint32_t state = 1;
  for (int i = 0; i < kTexels * kTexels; ++i) {
    state = state * 1664525U + 1013904223U;
    const auto value = static_cast<std::uint8_t>(state >> 16U & 1U   ? 255
                                                 : state >> 20U & 1U ? 128
                                                                     : 0);
    greys.rgba.insert(greys.rgba.end(), {value, value, value, 255});
  }
  scene::Image metals{.name = "metals", .width = kMetalTexels, .height = kMetalTexels, .rgba = {}};
  for (int i = 0; i < kMetalTexels * kMetalTexels; ++i) {
    const auto metal = static_cast<std::uint8_t>((i + i / kMetalTexels) % 2 * 255);
    metals.rgba.insert(metals.rgba.end(), {0, 150, metal, 255});
  }
  const scene::Sampler sharp{.nearest = true, .mipmaps = false};
  const scene::TextureRef texture{.image = builder.image(greys), .sampler = sharp};
  const scene::Material plain = scene::plainMaterial("plain", glm::vec4(1.0F), 1.0F);
  std::array<scene::Material, 5> all{plain, plain, plain, plain, plain};
  for (scene::Material& material : all) material.baseColorTexture = texture;
  all[0].unlit = true;
  all[1].emissive = glm::vec3(1.0F);
  all[1].emissiveTexture = texture;
  all[1].baseColor = {0.0F, 0.0F, 0.0F, 1.0F};
  all[3].metallic = 1.0F;
  all[3].roughness = 0.6F;
  all[4].metallic = 1.0F;
  all[4].metallicRoughnessTexture = {.image = builder.image(metals), .sampler = sharp};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const float left = -1.0F + 0.4F * static_cast<float>(i);
    const float right = left + 0.4F;
    scene::Primitive quad;
    scene::addQuad(quad, {left, -0.7F, 0}, {right, -0.7F, 0}, {right, 0.7F, 0}, {left, 0.7F, 0});
    builder.addOnce(std::move(quad), builder.material(all[i]));
  }
  builder.light(scene::sun({0.3F, -0.4F, -1.0F}, {1.0F, 0.95F, 0.9F}, 2.0F));
  builder.ambient({0.2F, 0.25F, 0.3F});
  scene::Camera camera;
  camera.position = {0.0F, 0.0F, 4.0F};
  camera.verticalFov = 0.46F;
  builder.camera(camera);
  return std::move(builder).finish();
}

passes::RenderSettings resized(double r, const std::string& what) {
  passes::RenderSettings settings = linearSettings("kb-variable");
  settings.lod.resize = r;
  settings.lod.what = what;
  return settings;
}

std::vector<float> radiance(const Bench& bench) {
  return bench.floats(passes::kHdrColor, 4);
}

double rootMeanSquare(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (i % 4 == 3) continue;
    const double d = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    sum += d * d;
  }
  return std::sqrt(sum / (static_cast<double>(a.size()) * 0.75));
}

}  // namespace macula::test
