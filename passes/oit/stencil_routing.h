// Whether the stencil test can deal out a pixel's fragments to its samples.
#pragma once

#include <cstdint>

#include "engine/gl/program.h"
#include "passes/full_screen.h"

namespace macula::passes {

/// How multisample slots are to be drawn to.
enum class RoutingMode : std::uint8_t {
  Single,  ///< GL_MULTISAMPLE off: one fragment for all samples, each with its own stencil
  Multi,   ///< GL_MULTISAMPLE on, for rasterisers that then test all samples by the first one's
           ///< stencil; at edges some samples are not covered, and slots stay empty
  None,    ///< neither deals them out
};

/// Draws two layers over a pixel of two samples in each mode, and looks which sample got which.
[[nodiscard]] RoutingMode checkStencilRouting(gl::ProgramCache& programs);

/// What prepareRouting() draws with.
[[nodiscard]] GLuint routingProgram(gl::ProgramCache& programs);

/// Sets the stencil of sample i to i + 1 and its depth to that of `opaqueDepth`, in the bound
/// framebuffer. @param program routingProgram() · @param slots samples that take a fragment; the
/// others get 0
void prepareRouting(GLuint program, FullScreenDraw& fullScreen, GLuint opaqueDepth,
                    std::uint32_t slots);

/// Stencil state under which each fragment goes to the next free sample; endRouting() ends it.
void beginRouting(RoutingMode mode);
void endRouting();

}  // namespace macula::passes
