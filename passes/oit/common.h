// What the transparency passes have in common: the launch shape of strips, reasons.
#pragma once

#include <fmt/format.h>

#include <string>

#include "engine/frame/pass_context.h"
#include "shared/oit_constants.h"

namespace macula::passes {

/// Threads for all strips of a frame and the shape of their groups: a row of groups per row of
/// pixels.
inline void dispatchStrips(const frame::PassContext& context) {
  const glm::ivec2 size = context.inputs().displaySize;
  const glm::ivec2 threads((size.x + STRIP - 1) / STRIP, size.y);
  context.dispatch(threads, {STRIP_GROUP, 1});
}

/// Why a pass of a storing method runs or does not.
inline std::string transparencyReason(const frame::FrameInputs& in, bool wanted,
                                      std::string_view method) {
  if (in.facts.transparentTriangles == 0) return "nothing transparent";
  return wanted
             ? fmt::format("{} transparent triangles by {}", in.facts.transparentTriangles, method)
             : fmt::format("{} does not use it", method);
}

}  // namespace macula::passes
