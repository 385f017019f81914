// What every pass that shades opaque pixels binds and defines.
#pragma once

#include "engine/frame/pass.h"
#include "engine/frame/pass_context.h"
#include "engine/gl/program.h"
#include "passes/lod/settings.h"
#include "passes/scene_draw.h"

namespace macula::passes {

/// Declares the G-buffer and the shadow map as read.
void declareShadingInputs(frame::PassDeclaration& d);

/// Binds what declareShadingInputs() names, and the lights.
void bindShadingInputs(frame::PassContext& context);

/// Which parts of the shading a program computes.
enum class ShadingWork {
  All,         ///< everything
  Parts,       ///< some parts, as they are
  AroundParts  ///< everything but these parts, which come from a texture
};

/// Defines of lighting.comp, but for which pixels it shades.
[[nodiscard]] gl::Defines shadingDefines(const scene::SceneFacts& facts, ShadingWork work,
                                         const LodParts& parts);

}  // namespace macula::passes
