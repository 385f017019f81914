// Slots that each pixel takes at the price found, where it costs much to say so.
#pragma once

#include "passes/oit/oit_pass.h"

namespace macula::passes {

class BidsPass final : public OitPass {
 public:
  using OitPass::OitPass;
  [[nodiscard]] std::string_view name() const override { return "oit.bids"; }
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override;

 private:
  [[nodiscard]] bool wanted() const override;
  void declareWork(frame::PassDeclaration& d) const override;
  void run(frame::PassContext& context) override;

  GLuint program_ = 0;
};

}  // namespace macula::passes
