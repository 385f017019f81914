// What the passes of the level of detail share: the plan, and that they work where it wants them.
#pragma once

#include <string>

#include "engine/frame/pass.h"
#include "engine/frame/pass_context.h"
#include "passes/lod/plan.h"
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
  void declare(frame::PassDeclaration& d) const final {
    if (plan_.wanted && used()) declareWork(d);
  }

 protected:
  /// Whether settings and scene need this step.
  [[nodiscard]] virtual bool used() const { return true; }
  virtual void declareWork(frame::PassDeclaration& d) const = 0;

  static constexpr glm::ivec2 kGroup{FULLSCREEN_GROUP};
  const LodPlan& plan_;
};

/// Where the dispatch of a list stands in LodTotals.
/// @param list rate level 0 to 3, or LOD_RATES for the holes
[[nodiscard]] constexpr GLintptr dispatchOffset(int list) {
  return static_cast<GLintptr>(list) * 4 * static_cast<GLintptr>(sizeof(GLuint));
}

}  // namespace macula::passes
