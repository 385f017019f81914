// Opaque depth of the texels at which resized transparency is drawn, and nothing over them yet.
#pragma once

#include "passes/full_screen.h"
#include "passes/lod/transparency.h"

namespace macula::passes {

class LodDepthPass final : public ResizedTransparencyPass {
 public:
  using ResizedTransparencyPass::ResizedTransparencyPass;
  [[nodiscard]] std::string_view name() const override { return "lod.depth"; }
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override;
  void execute(frame::PassContext& context) override;

 private:
  void declareWork(frame::PassDeclaration& d) const override;

  FullScreenDraw fullScreen_;
  GLuint program_ = 0;
};

}  // namespace macula::passes
