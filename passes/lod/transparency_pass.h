// Resized transparency over the full-rate opaque image.
#pragma once

#include "passes/lod/transparency.h"

namespace macula::passes {

class LodTransparencyPass final : public ResizedTransparencyPass {
 public:
  using ResizedTransparencyPass::ResizedTransparencyPass;
  [[nodiscard]] std::string_view name() const override { return "lod.transparency"; }
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override;
  void execute(frame::PassContext& context) override;

 private:
  void declareWork(frame::PassDeclaration& d) const override;

  GLuint program_ = 0;
};

}  // namespace macula::passes
