// Counts the transparent fragments of each pixel that pass opaque depth.
#pragma once

#include "engine/frame/pass.h"
#include "engine/frame/pass_context.h"
#include "passes/oit/plan.h"
#include "passes/scene_draw.h"

namespace macula::passes {

class CountPass final : public frame::Pass {
 public:
  explicit CountPass(const OitPlan& plan) : plan_(plan) {}
  [[nodiscard]] std::string_view name() const override { return "oit.count"; }
  void declare(frame::PassDeclaration& d) const override;
  [[nodiscard]] bool hasWork(const frame::FrameInputs& in) const override;
  [[nodiscard]] std::string reason(const frame::FrameInputs& in) const override;
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override;
  void execute(frame::PassContext& context) override;

 private:
  const OitPlan& plan_;
  SceneVariants variants_;
};

}  // namespace macula::passes
