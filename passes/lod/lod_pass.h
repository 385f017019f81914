// What the passes of opaque surfaces at a reduced rate share: the plan, and that they work where it
// wants them.
#pragma once

#include <string>

#include "engine/frame/pass.h"
#include "engine/frame/pass_context.h"
#include "passes/lod/plan.h"
#include "passes/lod/resources.h"
#include "passes/resources.h"
#include "shared/dispatch.h"
#include "shared/lod_totals.h"

namespace macula::passes {

class LodPass : public frame::Pass {
 public:
  explicit LodPass(const LodPlan& plan) : plan_(plan) {}
  [[nodiscard]] bool hasWork(const frame::FrameInputs& /*in*/) const final {
    return plan_.wanted && used();
  }
  [[nodiscard]] std::string reason(const frame::FrameInputs& in) const final {
    if (!in.facts.litOpaque) return "nothing opaque is lit";
    if (!plan_.wanted) return "every pixel is shaded";
    return used() ? "opaque surfaces are shaded at a lower rate" : "not of use with these settings";
  }

 protected:
  /// Whether settings and scene need this step.
  [[nodiscard]] virtual bool used() const { return true; }

  /// What is reconstructed, and shaded in holes.
  [[nodiscard]] const frame::Resource& target() const {
    return plan_.parts.shading ? kHdrColor : kShadingParts;
  }

  static constexpr glm::ivec2 kGroup{FULLSCREEN_GROUP};
  const LodPlan& plan_;
};

/// Where the dispatch of a list stands in LodTotals.
/// @param list rate level 0 to 3, or LOD_RATES for the holes
[[nodiscard]] constexpr GLintptr dispatchOffset(int list) {
  return static_cast<GLintptr>(list) * 4 * static_cast<GLintptr>(sizeof(GLuint));
}

}  // namespace macula::passes
