// Shading rates of tiles by eccentricity, and the counts of the level of detail from zero.
#pragma once

#include "passes/lod/lod_pass.h"

namespace macula::passes {

class LodRatesPass final : public LodPass {
 public:
  using LodPass::LodPass;
  [[nodiscard]] std::string_view name() const override { return "lod.rates"; }
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override;
  void execute(frame::PassContext& context) override;

 private:
  [[nodiscard]] bool used() const override { return true; }
  void declareWork(frame::PassDeclaration& d) const override;

  GLuint program_ = 0;
};

}  // namespace macula::passes
