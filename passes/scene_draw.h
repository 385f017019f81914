// Drawing the scene's lists with shaders specialised per run.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "engine/frame/frame_inputs.h"
#include "engine/gl/program.h"
#include "engine/scene/gpu_scene.h"

namespace macula::passes {

/// The programs for the runs of a draw list: one per combination of what their materials have.
class SceneVariants {
 public:
  /// Compiles the variants that the runs need.
  /// @param fragment shader file · @param defines for all variants; POSITION_ONLY becomes UV_ONLY
  /// where alpha is tested
  void prepare(std::span<const scene::DrawRun> runs, std::string_view fragment,
               const gl::Defines& defines, const std::vector<std::string>& extensions,
               gl::ProgramCache& programs);
  /// Draws the runs in order, each with its program, material and culling.
  /// @param runs those of prepare() · @param shadowViewProjection for SHADOW variants
  void draw(const scene::GpuScene& gpu, const scene::DrawList& list,
            std::span<const scene::DrawRun> runs,
            const glm::mat4* shadowViewProjection = nullptr) const;

 private:
  std::vector<GLuint> programs_;  ///< one a run
};

}  // namespace macula::passes
