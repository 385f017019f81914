// Full-rate pixels from low-rate samples.
#pragma once

#include "passes/lod/lod_pass.h"

namespace macula::passes {

class LodReconstructPass final : public LodPass {
 public:
  using LodPass::LodPass;
  [[nodiscard]] std::string_view name() const override { return "lod.reconstruct"; }
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override;
  void execute(frame::PassContext& context) override;

 private:
  void declareWork(frame::PassDeclaration& d) const override;

  GLuint program_ = 0;
};

}  // namespace macula::passes
