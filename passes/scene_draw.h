// Drawing the scene's lists with shaders specialised per run.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "engine/frame/frame_inputs.h"
#include "engine/gl/program.h"
#include "engine/scene/gpu_scene.h"

namespace macula::passes {

/// Defines that the lighting functions need for this scene: SHADOWS, SHADOW_TAPS, ENVIRONMENT.
[[nodiscard]] gl::Defines lightingDefines(const scene::SceneFacts& facts);

/// Whether a shadow map is worth drawing: a light casts, something opaque can block it, and
/// something lit receives it.
[[nodiscard]] bool needsShadowMap(const scene::SceneFacts& facts);

/// The programs for the runs of a draw list: one per combination of lit, textured, mask
/// and holed.
class SceneVariants {
 public:
  /// Compiles the variants that the runs need.
  /// @param fragment shader file · @param defines for all variants; POSITION_ONLY becomes UV_ONLY
  /// where fragments are tested
  void prepare(std::span<const scene::DrawRun> runs, std::string_view fragment,
               const gl::Defines& defines, const std::vector<std::string>& extensions,
               gl::ProgramCache& programs);
  /// Draws the runs in order, each with its program, textures and culling.
  void draw(const scene::GpuScene& gpu, const scene::DrawList& list,
            std::span<const scene::DrawRun> runs) const;
  [[nodiscard]] GLuint programOf(const scene::DrawRun& run) const {
    return programs_[indexOf(run)];
  }

 private:
  static std::size_t indexOf(const scene::DrawRun& run);
  std::array<GLuint, 16> programs_{};
};

}  // namespace macula::passes
