// Shades the pixels that no low-rate sample fits.
#pragma once

#include "passes/lod/lod_pass.h"

namespace macula::passes {

class LodHolesPass final : public LodPass {
 public:
  using LodPass::LodPass;
  [[nodiscard]] std::string_view name() const override { return "lod.holes"; }
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override;
  void execute(frame::PassContext& context) override;

 private:
  [[nodiscard]] bool used() const override { return plan_.shadesHoles(); }
  void declareWork(frame::PassDeclaration& d) const override;

  GLuint program_ = 0;
};

}  // namespace macula::passes
