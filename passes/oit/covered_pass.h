// Lists the tiles, or those pixels of a sample, that transparency covers.
#pragma once

#include "passes/oit/oit_pass.h"

namespace macula::passes {

class CoveredPass final : public OitPass {
 public:
  /// @param list LIST_OF_TILES or LIST_OF_SAMPLES
  CoveredPass(const OitPlan& plan, int list) : OitPass(plan), list_(list) {}
  [[nodiscard]] std::string_view name() const override;
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override;

 private:
  [[nodiscard]] bool wanted() const override;
  void declareWork(frame::PassDeclaration& d) const override;
  void run(frame::PassContext& context) override;

  int list_;
  GLuint program_ = 0;
};

}  // namespace macula::passes
