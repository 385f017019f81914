// What the passes around resized transparency share: that they work where the plan wants it.
#pragma once

#include <string>

#include "engine/frame/pass.h"
#include "engine/frame/pass_context.h"
#include "passes/lod/plan.h"

namespace macula::passes {

class ResizedTransparencyPass : public frame::Pass {
 public:
  explicit ResizedTransparencyPass(const LodPlan& plan) : plan_(plan) {}
  [[nodiscard]] bool hasWork(const frame::FrameInputs& in) const final {
    return plan_.transparency && in.facts.transparentTriangles > 0;
  }
  [[nodiscard]] std::string reason(const frame::FrameInputs& in) const final {
    if (in.facts.transparentTriangles == 0) return "nothing transparent";
    return plan_.transparency ? "transparent surfaces are drawn at a lower rate"
                              : "transparent surfaces are drawn at full rate";
  }
  void declare(frame::PassDeclaration& d) const final {
    if (plan_.transparency) declareWork(d);
  }

 protected:
  virtual void declareWork(frame::PassDeclaration& d) const = 0;
  /// Samples of the image a texel, per axis: L covers the image exactly, so that what is drawn at
  /// its texels lies where it lies in the image; r where it divides the size.
  [[nodiscard]] glm::vec2 pitch() const { return glm::vec2(plan_.size) / glm::vec2(plan_.texels); }

  const LodPlan& plan_;
};

}  // namespace macula::passes
