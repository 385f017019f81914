// Shares the slots of the budget out at the price found, to the last one.
#pragma once

#include "passes/oit/oit_pass.h"

namespace macula::passes {

class SharePass final : public OitPass {
 public:
  using OitPass::OitPass;
  [[nodiscard]] std::string_view name() const override { return "oit.share"; }
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override;

 private:
  [[nodiscard]] bool wanted() const override;
  void declareWork(frame::PassDeclaration& d) const override;
  void run(frame::PassContext& context) override;

  GLuint program_ = 0;
};

}  // namespace macula::passes
