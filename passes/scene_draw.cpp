#include "passes/scene_draw.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/gtc/type_ptr.hpp>

#include "shared/bindings.h"
#include "shared/scene_data.h"

namespace macula::passes {

namespace {

constexpr std::array<const char*, MATERIAL_TEXTURES> kMaps{
    "BASE_COLOR_MAP", "METALLIC_ROUGHNESS_MAP", "NORMAL_MAP", "OCCLUSION_MAP", "EMISSIVE_MAP"};
static_assert(TEX_BASE_COLOR == 0 && TEX_METALLIC_ROUGHNESS == 1 && TEX_NORMAL == 2 &&
              TEX_OCCLUSION == 3 && TEX_EMISSIVE == 4);

gl::Defines definesOf(const scene::DrawRun& run, gl::Defines defines) {
  const auto add = [&defines](const char* name, bool wanted) {
    if (wanted) defines.emplace_back(name, "1");
  };
  const bool positions = std::any_of(defines.begin(), defines.end(), [](const auto& define) {
    return define.first == "POSITION_ONLY";
  });
  const bool tested = run.holed || run.mask;
  if (positions && !tested) return defines;  // whatever the material is
  for (auto& define : defines) {
    if (define.first == "POSITION_ONLY") define.first = "UV_ONLY";
  }
  const scene::SurfaceFeatures& f = run.features;
  add("LIT", run.lit);
  add("HOLED", run.holed);
  add("MASK", run.mask);
  add("TEXTURED", f.textures != 0);
  for (std::size_t i = 0; i < kMaps.size(); ++i) add(kMaps[i], (f.textures >> i & 1U) != 0);
  if (f.secondUv != 0) defines.emplace_back("SECOND_UV", std::to_string(unsigned{f.secondUv}));
  if (f.veins != 0) defines.emplace_back("VEINS_KIND", fmt::format("{}u", unsigned{f.veins}));
  add("ALPHA_BLEND", f.alpha == scene::AlphaMode::Blend);
  add("ALPHA_MASK", f.alpha == scene::AlphaMode::Mask);
  add("VERTEX_COLOR", f.vertexColor);
  add("DOUBLE_SIDED", f.doubleSided);
  add("TRANSMISSION", f.transmission);
  return defines;
}

}  // namespace

void SceneVariants::prepare(std::span<const scene::DrawRun> runs, std::string_view fragment,
                            const gl::Defines& defines, const std::vector<std::string>& extensions,
                            gl::ProgramCache& programs) {
  programs_.clear();
  for (const scene::DrawRun& run : runs) {
    programs_.push_back(
        programs.get({{"scene.vert", std::string(fragment)}, definesOf(run, defines), extensions}));
  }
}

void SceneVariants::draw(const scene::GpuScene& gpu, const scene::DrawList& list,
                         std::span<const scene::DrawRun> runs,
                         const glm::mat4* shadowViewProjection) const {
  gpu.bindGeometry();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    glUseProgram(programs_[i]);
    gpu.bindMaterial(runs[i]);
    if (shadowViewProjection == nullptr) {
      gpu.draw(list, runs[i]);
    } else {
      glUniformMatrix4fv(0, 1, GL_FALSE, glm::value_ptr(*shadowViewProjection));
      gpu.drawAll(list, runs[i]);
    }
  }
}

}  // namespace macula::passes
