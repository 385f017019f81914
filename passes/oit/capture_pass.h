// Stores transparent fragments in their pixels' ranges.
#pragma once

#include "engine/frame/pass.h"
#include "engine/frame/pass_context.h"
#include "passes/oit/plan.h"
#include "passes/scene_draw.h"

namespace macula::passes {

class CapturePass final : public frame::Pass {
 public:
  explicit CapturePass(const OitPlan& plan) : plan_(plan) {}
  [[nodiscard]] std::string_view name() const override { return "oit.capture"; }
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
