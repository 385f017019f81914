// What the lighting functions (shaders/lib/lighting.glsl) are specialised by.
#pragma once

#include <string>

#include "engine/frame/frame_inputs.h"
#include "engine/gl/program.h"
#include "shared/scene_data.h"

namespace macula::passes {

/// Which lights there are, and ENVIRONMENT: what the lighting functions need without shadows.
[[nodiscard]] gl::Defines lightDefines(const frame::FrameInputs& in);

/// The block as a constant of the shading language; every float reads back as it is.
[[nodiscard]] std::string constantOf(const shader::LightBlock& block);

/// Defines that the lighting functions need for this scene.
[[nodiscard]] gl::Defines lightingDefines(const frame::FrameInputs& in);

/// Whether a shadow map is worth drawing: a light casts, something opaque can block it, and
/// something lit receives it.
[[nodiscard]] bool needsShadowMap(const scene::SceneFacts& facts);

}  // namespace macula::passes
