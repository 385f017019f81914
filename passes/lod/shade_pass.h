// Shades the samples of the resized image, or every pixel where r is 1.
#pragma once

#include "passes/lod/lod_pass.h"

namespace macula::passes {

class LodShadePass final : public LodPass {
 public:
  using LodPass::LodPass;
  [[nodiscard]] std::string_view name() const override { return "lod.shade"; }
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override;
  void execute(frame::PassContext& context) override;

 private:
  void declareWork(frame::PassDeclaration& d) const override;

  GLuint pixels_ = 0;   ///< every pixel
  GLuint samples_ = 0;  ///< those of the grid, or of the tiles
};

}  // namespace macula::passes
