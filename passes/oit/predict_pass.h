// Counts of fragments as the last frame lets expect, so that no geometry pass has to count them;
// where there is no last frame they are drawn.
#pragma once

#include "passes/oit/count_draw.h"
#include "passes/oit/oit_pass.h"

namespace macula::passes {

class PredictPass final : public OitPass {
 public:
  using OitPass::OitPass;
  [[nodiscard]] std::string_view name() const override { return "oit.predict"; }
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override;

 private:
  [[nodiscard]] bool wanted() const override;
  void declareWork(frame::PassDeclaration& d) const override;
  void run(frame::PassContext& context) override;

  CountDraw count_;
  GLuint program_ = 0;
};

}  // namespace macula::passes
