// Counts transparent fragments, and gathers by the same blending what the thesis's network sees.
#pragma once

#include "passes/oit/oit_pass.h"
#include "passes/scene_draw.h"

namespace macula::passes {

class CountColorsPass final : public OitPass {
 public:
  using OitPass::OitPass;
  [[nodiscard]] std::string_view name() const override { return "oit.countColors"; }
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override;

 private:
  [[nodiscard]] bool wanted() const override;
  void declareWork(frame::PassDeclaration& d) const override;
  void run(frame::PassContext& context) override;

  SceneVariants variants_;
};

}  // namespace macula::passes
