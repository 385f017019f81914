#include "passes/scene_draw.h"

namespace macula::passes {

bool needsShadowMap(const scene::SceneFacts& facts) {
  return facts.shadowLight && facts.opaqueTriangles > 0 &&
         (facts.litOpaque || facts.litTransparent);
}

gl::Defines lightingDefines(const scene::SceneFacts& facts) {
  gl::Defines defines;
  if (needsShadowMap(facts)) {
    defines.emplace_back("SHADOWS", "1");
    if (facts.shadowTaps != scene::kUsualShadowTaps) {
      defines.emplace_back("SHADOW_TAPS", std::to_string(facts.shadowTaps));
    }
  }
  if (facts.environment) defines.emplace_back("ENVIRONMENT", "1");
  return defines;
}

std::size_t SceneVariants::indexOf(const scene::DrawRun& run) {
  return (run.lit ? 1U : 0U) | (run.texturedMaterial != scene::kNone ? 2U : 0U) |
         (run.mask ? 4U : 0U) | (run.holed ? 8U : 0U);
}

void SceneVariants::prepare(std::span<const scene::DrawRun> runs, std::string_view fragment,
                            const gl::Defines& defines, const std::vector<std::string>& extensions,
                            gl::ProgramCache& programs) {
  programs_.fill(0);
  for (const scene::DrawRun& run : runs) {
    GLuint& program = programs_[indexOf(run)];
    if (program != 0) continue;
    gl::ProgramKey key{{"scene.vert", std::string(fragment)}, defines, extensions};
    if (run.lit) key.defines.emplace_back("LIT", "1");
    if (run.texturedMaterial != scene::kNone) key.defines.emplace_back("TEXTURED", "1");
    if (run.holed) {
      for (auto& [name, value] : key.defines) {
        if (name == "POSITION_ONLY") name = "UV_ONLY";
      }
      key.defines.emplace_back("HOLED", "1");
    }
    if (run.mask) key.defines.emplace_back("MASK", "1");
    program = programs.get(key);
  }
}

void SceneVariants::draw(const scene::GpuScene& gpu, const scene::DrawList& list,
                         std::span<const scene::DrawRun> runs) const {
  gpu.bindGeometry();
  for (const scene::DrawRun& run : runs) {
    glUseProgram(programOf(run));
    if (run.texturedMaterial != scene::kNone) gpu.bindMaterialTextures(run.texturedMaterial);
    gpu.draw(list, run);
  }
}

}  // namespace macula::passes
