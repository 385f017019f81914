// One round of the search for the price of a slot at which the budget is used
// (shaders/lib/bids.glsl).
#pragma once

#include "passes/oit/oit_pass.h"

namespace macula::passes {

class PricePass final : public OitPass {
 public:
  /// @param round 0 .. PRICE_ROUNDS - 1
  PricePass(const OitPlan& plan, int round)
      : OitPass(plan), round_(round), name_("oit.price" + std::to_string(round)) {}
  [[nodiscard]] std::string_view name() const override { return name_; }
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override;

 private:
  [[nodiscard]] bool wanted() const override;
  void declareWork(frame::PassDeclaration& d) const override;
  void run(frame::PassContext& context) override;

  int round_;
  std::string name_;
  GLuint program_ = 0;
};

}  // namespace macula::passes
