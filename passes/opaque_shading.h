// What every pass that shades opaque pixels binds and defines.
#pragma once

#include "engine/frame/pass.h"
#include "engine/gl/program.h"
#include "passes/light_defines.h"
#include "passes/lod/settings.h"

namespace macula::passes {

/// Which parts of the shading a program computes.
enum class ShadingWork {
  All,         ///< everything
  Parts,       ///< some parts, as they are
  AroundParts  ///< everything but these parts, which come from a texture
};

/// Rows of the G-buffer and of the shadow map, as far as lighting.comp reads them.
/// @param samples results are samples of the reduced-rate image, which hold normals
void declareShadingInputs(frame::PassDeclaration& d, const scene::SceneFacts& facts,
                          ShadingWork work, const LodParts& parts, bool samples);

/// Defines of lighting.comp, but for which pixels it shades.
[[nodiscard]] gl::Defines shadingDefines(const frame::FrameInputs& in, ShadingWork work,
                                         const LodParts& parts);

}  // namespace macula::passes
