// Slots that each pixel takes at the price found, and their sums.
#pragma once

#include "passes/oit/oit_pass.h"

namespace macula::passes {

class DemandPass final : public OitPass {
 public:
  using OitPass::OitPass;
  [[nodiscard]] std::string_view name() const override { return "oit.demand"; }
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override;

 private:
  [[nodiscard]] bool wanted() const override;
  void declareWork(frame::PassDeclaration& d) const override;
  void run(frame::PassContext& context) override;
  /// A pass before this one has said what pixels take.
  [[nodiscard]] bool bidsAreIn() const { return plan_.slices(); }

  GLuint program_ = 0;
};

}  // namespace macula::passes
