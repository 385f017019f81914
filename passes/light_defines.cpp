#include "passes/light_defines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <span>

#include "engine/scene/gpu_scene.h"
#include "shared/scene_data.h"

namespace macula::passes {
namespace {

static_assert(static_cast<unsigned>(scene::LightType::Directional) == LIGHT_DIRECTIONAL &&
              static_cast<unsigned>(scene::LightType::Point) == LIGHT_POINT &&
              static_cast<unsigned>(scene::LightType::Spot) == LIGHT_SPOT);

bool areFew(const scene::SceneFacts& facts) {
  return facts.lights <= facts.lightTypes.size();
}

bool isFinite(const shader::LightBlock& block) {
  static_assert(sizeof(block) % sizeof(float) == 0);
  std::array<float, sizeof(block) / sizeof(float)> values{};
  std::memcpy(values.data(), &block, sizeof(block));
  return std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
}

std::string textOf(const glm::vec4& v) {
  return fmt::format("vec4({},{},{},{})", gl::literal(v.x), gl::literal(v.y), gl::literal(v.z),
                     gl::literal(v.w));
}

std::string textOf(const shader::LightData& light) {
  return fmt::format("LightData({},{},{},{})", textOf(light.position), textOf(light.direction),
                     textOf(light.color), textOf(light.cone));
}

template <typename T>
std::string arrayOf(std::string_view type, std::span<const T> values) {
  std::string text;
  for (const T& value : values) text += (text.empty() ? "" : ",") + textOf(value);
  return fmt::format("{}[{}]({})", type, values.size(), text);
}

}  // namespace

std::string constantOf(const shader::LightBlock& block) {
  const glm::mat4& m = block.shadowMatrix;
  return fmt::format("LightBlock({},{},mat4({},{},{},{}),{},{},{},{},{})", textOf(block.ambient),
                     textOf(block.environment), textOf(m[0]), textOf(m[1]), textOf(m[2]),
                     textOf(m[3]), textOf(block.shadow), textOf(block.occlusion),
                     arrayOf<glm::vec4>("vec4", block.veins),
                     arrayOf<glm::vec4>("vec4", block.irradiance),
                     arrayOf<shader::LightData>("LightData", block.lights));
}

bool needsShadowMap(const scene::SceneFacts& facts) {
  return facts.shadowLight && facts.opaqueTriangles > 0 &&
         (facts.litOpaque || facts.litTransparent);
}

gl::Defines lightDefines(const frame::FrameInputs& in) {
  const scene::SceneFacts& facts = in.facts;
  gl::Defines defines;
  if (areFew(facts)) {
    std::string each;
    for (std::size_t i = 0; i < facts.lights; ++i) {
      each += fmt::format("F({}, {}u) ", i, static_cast<unsigned>(facts.lightTypes[i]));
    }
    defines.emplace_back("EACH_LIGHT(F)", each);
    // The colours of veins are chosen at run time; infinity, to which a light's intensity times its
    // colour may come, has no literal.
    if (!facts.veins && isFinite(in.gpu->lightBlock()))
      defines.emplace_back("LIGHT_CONSTANTS", constantOf(in.gpu->lightBlock()));
  }
  if (facts.environment) defines.emplace_back("ENVIRONMENT", "1");
  return defines;
}

gl::Defines lightingDefines(const frame::FrameInputs& in) {
  const scene::SceneFacts& facts = in.facts;
  gl::Defines defines = lightDefines(in);
  if (!needsShadowMap(facts)) return defines;
  defines.emplace_back("SHADOWS", "1");
  if (areFew(facts)) {
    defines.emplace_back("SHADOW_LIGHT", std::to_string(facts.shadowLightNumber));
  }
  if (facts.shadowTaps != scene::kUsualShadowTaps) {
    defines.emplace_back("SHADOW_TAPS", std::to_string(facts.shadowTaps));
  }
  return defines;
}

}  // namespace macula::passes
