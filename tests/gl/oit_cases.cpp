#include "oit_cases.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "engine/core/error.h"

namespace macula::test {

using passes::OitSettings;
using passes::Predictor;
using passes::Tail;

scene::Scene sheets(const std::vector<Sheet>& list) {
  constexpr float kHalfSide = 60.0F;
  scene::Scene scene;
  scene.name = "sheets";
  for (const Sheet& sheet : list) {
    scene::Material material;
    material.unlit = true;
    material.doubleSided = true;
    material.metallic = 0.0F;
    material.baseColor = sheet.color + glm::vec4(glm::vec3(sheet.brightness), 0.0F);
    material.alphaMode = sheet.opaque ? scene::AlphaMode::Opaque : scene::AlphaMode::Blend;
    scene::Primitive quad;
    quad.material = static_cast<std::int32_t>(scene.materials.size());
    scene.materials.push_back(material);
    for (const glm::vec2 c :
         {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(-1, 1), glm::vec2(1, 1)}) {
      // A tilted sheet is cut off before it comes behind the eye.
      const float x =
          sheet.slope == 0.0F
              ? kHalfSide * c.x
              : c.x * std::min(kHalfSide, 0.8F * sheet.distance / std::abs(sheet.slope));
      quad.positions.emplace_back(x, kHalfSide * c.y, -(sheet.distance + sheet.slope * x));
      quad.attributes.emplace_back();
    }
    quad.indices = {0, 1, 2, 2, 1, 3};
    scene.instances.push_back({static_cast<std::uint32_t>(scene.primitives.size()), glm::mat4(1)});
    scene.primitives.push_back(std::move(quad));
  }
  scene::Camera camera;
  camera.nearPlane = 0.1F;
  camera.farPlane = 50.0F;
  scene.cameras.push_back(camera);
  return scene;
}

void addRectangle(scene::Scene& scene, float distance, glm::vec2 low, glm::vec2 high,
                  glm::vec4 color, bool opaque) {
  scene::Material material;
  material.unlit = true;
  material.doubleSided = true;
  material.metallic = 0.0F;
  material.baseColor = color;
  material.alphaMode = opaque ? scene::AlphaMode::Opaque : scene::AlphaMode::Blend;
  scene::Primitive quad;
  quad.material = static_cast<std::int32_t>(scene.materials.size());
  scene.materials.push_back(material);
  for (const glm::vec2 p : {low, glm::vec2(high.x, low.y), glm::vec2(low.x, high.y), high}) {
    quad.positions.emplace_back(p, -distance);
    quad.attributes.emplace_back();
  }
  quad.indices = {0, 1, 2, 2, 1, 3};
  scene.instances.push_back({static_cast<std::uint32_t>(scene.primitives.size()), glm::mat4(1)});
  scene.primitives.push_back(std::move(quad));
}

scene::Scene emptyScene() {
  scene::Scene scene;
  scene::Camera camera;
  camera.nearPlane = 0.1F;
  camera.farPlane = 50.0F;
  scene.cameras.push_back(camera);
  return scene;
}

scene::Scene unlit(scene::Scene scene) {
  for (scene::Material& material : scene.materials) material.unlit = true;
  return scene;
}

glm::vec4 variedColor(int i, float alpha) {
  const auto channel = [&](int step) { return static_cast<float>(i * step % 97) / 96.0F; };
  return {channel(37), channel(53), channel(71), alpha};
}

glm::vec3 over(const std::vector<glm::vec4>& nearestFirst, glm::vec3 behind) {
  glm::vec3 color(0.0F);
  float passes = 1.0F;
  for (const glm::vec4& layer : nearestFirst) {
    color += passes * layer.a * glm::vec3(layer);
    passes *= 1.0F - layer.a;
  }
  return color + passes * behind;
}

passes::RenderSettings settingsOf(const OitSettings& oit) {
  passes::RenderSettings settings = linearSettings(oit.method, oit.kAve);
  settings.oit = oit;
  return settings;
}

std::string describe(const OitSettings& oit) {
  constexpr const char* kPredictors[]{"published", "transmittance", "error", "learned"};
  return oit.method + " sync " + oit.sync + (oit.tail == Tail::Mean ? " tail" : "") +
         (oit.fill ? " fill" : "") + " " + kPredictors[static_cast<int>(oit.importance)] + " " +
         std::to_string(oit.fragmentBytes) + " bytes, k " + std::to_string(oit.kAve);
}

OitSettings learnedUtility(double kAve, int fragmentBytes) {
  return {.method = "kb-variable",
          .kAve = kAve,
          .fill = true,
          .tail = Tail::Mean,
          .importance = Predictor::Learned,
          .fragmentBytes = fragmentBytes};
}

std::vector<OitSettings> sortedCases(double kAve) {
  const char* tested = std::getenv("MACULA_TEST_SYNC");
  const bool interlock = tested != nullptr && std::string_view(tested) == "interlock";
  std::vector<OitSettings> all;
  for (const char* method : {"kb-fixed", "kb-plus", "kb-variable", "kb-learned"}) {
    for (const char* sync : {interlock ? "interlock" : "ordered", "spinlock"}) {
      for (const Tail tail : {Tail::None, Tail::Mean}) {
        for (const bool fill : {false, true}) {
          for (const Predictor importance : {Predictor::Published, Predictor::Transmittance,
                                             Predictor::Error, Predictor::Learned}) {
            for (const int bytes : {16, 8}) {
              const OitSettings s{.method = method,
                                  .kAve = kAve,
                                  .sync = sync,
                                  .fill = fill,
                                  .tail = tail,
                                  .importance = importance,
                                  .fragmentBytes = bytes};
              try {
                passes::checkCombination(s);
              } catch (const InputError&) {
                continue;
              }
              all.push_back(s);
            }
          }
        }
      }
    }
  }
  return all;
}

std::vector<OitSettings> completeCases(int layers) {
  const double k = layers;
  // Importance is uneven: four times the layers give each pixel at least all of its own.
  return {{.method = "ab-sbuffer"},
          {.method = "ab-list"},
          {.method = "ab-list", .sync = "spinlock"},
          {.method = "ab-array", .layers = layers},
          {.method = "peel", .layers = layers},
          {.method = "kb-fixed", .kAve = k},
          {.method = "kb-fixed", .kAve = k, .sync = "spinlock"},
          {.method = "kb-fixed", .kAve = k, .tail = Tail::Mean},
          {.method = "kb-atomic", .kAve = k},
          {.method = "kb-atomic", .kAve = k + 1.0, .tail = Tail::Mean},
          {.method = "kb-plus", .kAve = k},
          {.method = "kb-plus", .kAve = k, .fill = true},
          {.method = "kb-variable", .kAve = 4.0 * k + 4.0},
          {.method = "kb-variable", .kAve = k, .fill = true},
          {.method = "kb-variable", .kAve = k, .fill = true, .tail = Tail::Mean},
          {.method = "kb-variable", .kAve = k, .fill = true, .importance = Predictor::Error},
          {.method = "kb-learned", .kAve = k, .fill = true},
          learnedUtility(k)};
}

float largestDifference(const std::vector<float>& a, const std::vector<float>& b) {
  EXPECT_EQ(a.size(), b.size());
  float largest = 0.0F;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const float difference = std::abs(a[i] - b[i]);
    // NaN is no difference that is small enough.
    largest = std::isnan(difference) ? INFINITY : std::max(largest, difference);
  }
  return largest;
}

std::size_t countUnlike(const std::vector<float>& a, const std::vector<float>& b) {
  EXPECT_EQ(a.size(), b.size());
  std::size_t unlike = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) unlike += a[i] == b[i] ? 0U : 1U;
  return unlike;
}

bool allFinite(const std::vector<float>& values) {
  return std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
}

void note(const std::string& what, double value) {
  testing::Test::RecordProperty(what, std::to_string(value));
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  std::printf("[   NOTE   ] %s.%s: %s %g\n", test->test_suite_name(), test->name(), what.c_str(),
              value);
}

}  // namespace macula::test
