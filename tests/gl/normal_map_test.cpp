// Normal maps turn the light on a surface, and never put it into its own shadow.
#include <algorithm>
#include <cmath>

#include "engine/scene/procedural/mesh_builder.h"
#include "engine/scene/procedural/scene_builder.h"
#include "gl_fixture.h"
#include "lod_scenes.h"

namespace macula::test {
namespace {

constexpr glm::ivec2 kSize{64, 64};
constexpr int kRim = 8;  // pixels of the image around the quad and its outermost pixels

std::uint8_t byteOf(float component) {
  return static_cast<std::uint8_t>(std::lround((component * 0.5F + 0.5F) * 255.0F));
}

/// A normal map. @param normalAt of the texel at x, y; need not be of unit length
template <typename Function>
scene::Image normalMap(int side, Function normalAt) {
  scene::Image image{.name = "normals", .width = side, .height = side, .rgba = {}};
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const glm::vec3 n = glm::normalize(normalAt(x, y));
      image.rgba.insert(image.rgba.end(), {byteOf(n.x), byteOf(n.y), byteOf(n.z), 255});
    }
  }
  return image;
}

/// The same normal everywhere, turned by some degrees towards +x.
scene::Image turned(float degrees) {
  const float angle = glm::radians(degrees);
  return normalMap(1, [&](int, int) { return glm::vec3(std::sin(angle), 0.0F, std::cos(angle)); });
}

/// Bumps a side of the map.
scene::Image bumps() {
  constexpr int kSide = 64;
  constexpr float kTurn = 6.2831853F * 4.0F / kSide;
  return normalMap(kSide, [&](int x, int y) {
    return glm::vec3(0.6F * std::sin(kTurn * static_cast<float>(x)),
                     0.6F * std::sin(kTurn * static_cast<float>(y)), 1.0F);
  });
}

enum class Look { Opaque, Blended, FromBehind };

/// A flat quad that looks at the camera, alone under one light.
scene::Scene quad(const scene::Image& normals, const scene::Light& light, Look look) {
  scene::SceneBuilder builder("quad");
  scene::Material material = scene::plainMaterial("paper", {0.5F, 0.5F, 0.5F, 1.0F}, 1.0F);
  material.normalTexture.image = builder.image(normals);
  material.doubleSided = true;
  if (look == Look::Blended) {
    material.alphaMode = scene::AlphaMode::Blend;
    material.baseColor.a = 0.5F;
  }
  const std::int32_t paper = builder.material(material);
  scene::Primitive mesh;
  if (look == Look::FromBehind) {
    scene::addQuad(mesh, {0.9F, -0.9F, 0}, {-0.9F, -0.9F, 0}, {-0.9F, 0.9F, 0}, {0.9F, 0.9F, 0});
  } else {
    scene::addQuad(mesh, {-0.9F, -0.9F, 0}, {0.9F, -0.9F, 0}, {0.9F, 0.9F, 0}, {-0.9F, 0.9F, 0});
  }
  for (scene::VertexAttributes& vertex : mesh.attributes) {
    vertex.tangent = glm::vec4(look == Look::FromBehind ? -1.0F : 1.0F, 0.0F, 0.0F, 1.0F);
  }
  builder.addOnce(std::move(mesh), paper);
  if (look == Look::Blended) {
    // What is blended casts no shadow itself: it lies on something that does.
    constexpr float kGap = -1e-4F;  // metres
    scene::Primitive other;
    scene::addQuad(other, {-0.9F, -0.9F, kGap}, {0.9F, -0.9F, kGap}, {0.9F, 0.9F, kGap},
                   {-0.9F, 0.9F, kGap});
    builder.addOnce(std::move(other), builder.material(scene::plainMaterial(
                                          "black", {0.0F, 0.0F, 0.0F, 1.0F}, 1.0F)));
  }
  builder.light(light);
  scene::Camera camera;
  camera.position = {0.0F, 0.0F, 5.0F};
  camera.verticalFov = 0.39479F;
  builder.camera(camera);
  return std::move(builder).finish();
}

std::vector<float> inside(const scene::Scene& scene, const passes::RenderSettings& settings,
                          passes::DeviceContext& device) {
  Bench bench(scene, settings, kSize, device);
  bench.draw();
  const std::vector<float> rgb = bench.linear();
  std::vector<float> found;
  for (int y = kRim; y < kSize.y - kRim; ++y) {
    for (int x = kRim; x < kSize.x - kRim; ++x) {
      found.push_back(rgb[static_cast<std::size_t>(y * kSize.x + x) * 3]);
    }
  }
  return found;
}

const glm::vec3 kDiagonal{1.0F, 1.0F, 1.0F};
const glm::vec3 kAcross{1.0F, 0.0F, 1.0F};
const glm::vec3 kGrazing{2.0F, 1.5F, 0.5F};
constexpr float kLux = 3.1415927F;

scene::Light sunFrom(const glm::vec3& place) {
  return scene::sun(-place, glm::vec3(1.0F), kLux);
}

/// As bright as that sun at the middle, and without shadow.
scene::Light farLampFrom(const glm::vec3& place) {
  constexpr float kDistance = 1000.0F;
  return scene::pointLight(glm::normalize(place) * kDistance, glm::vec3(1.0F),
                           kLux * kDistance * kDistance, 0.0F);
}

class NormalMap : public GlTest {};

TEST_F(NormalMap, LeavesAFlatQuadOneValue) {
  for (const Look look : {Look::Opaque, Look::Blended, Look::FromBehind}) {
    for (const glm::vec3& sun : {kDiagonal, kAcross, kGrazing}) {
      for (const float degrees : {-30.0F, 0.0F, 30.0F, 45.0F}) {
        const auto values = inside(quad(turned(degrees), sunFrom(sun), look),
                                   linearSettings("ab-sbuffer"), device());
        const auto [least, most] = std::minmax_element(values.begin(), values.end());
        // The reflection of a rough surface changes by less over the view.
        EXPECT_LT(*most - *least, 5e-3F) << static_cast<int>(look) << " sun from " << sun.x << ','
                                         << sun.y << ',' << sun.z << ", turned " << degrees;
      }
    }
  }
}

TEST_F(NormalMap, IsAsBrightUnderTheSunAsUnderAFarLampWithoutShadow) {
  passes::RenderSettings plain = linearSettings("ab-sbuffer");
  passes::RenderSettings parts = resized(2.0, "shadow");
  passes::RenderSettings foveated = resized(1.0);
  foveated.foveation.enabled = true;
  foveated.foveation.pixelsPerDegree = 10.0;
  for (const Look look : {Look::Opaque, Look::Blended, Look::FromBehind}) {
    for (const glm::vec3& place : {kDiagonal, kAcross}) {
      for (passes::RenderSettings* settings : {&plain, &parts, &foveated}) {
        // Resized light is compared with light resized likewise.
        const auto sun = inside(quad(bumps(), sunFrom(place), look), *settings, device());
        const auto lamp = inside(quad(bumps(), farLampFrom(place), look), *settings, device());
        float worst = 0.0F;
        for (std::size_t i = 0; i < sun.size(); ++i) {
          worst = std::max(worst, std::abs(sun[i] - lamp[i]) / std::max(lamp[i], 0.02F));
        }
        EXPECT_LT(worst, 0.02F) << static_cast<int>(look) << " from " << place.y;
      }
    }
  }
}

TEST_F(NormalMap, CostsNoByte) {
  passes::RenderSettings settings = linearSettings("ab-sbuffer");
  Bench bench(quad(bumps(), sunFrom(kAcross), Look::Opaque), settings, kSize, device());
  bench.draw();
  EXPECT_EQ(bench.renderer.bytes().gbuffer, 20U * kSize.x * kSize.y);
}

}  // namespace
}  // namespace macula::test
