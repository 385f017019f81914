// Sums transparent fragments into depth slices, from which layers are predicted.
#pragma once

#include "passes/full_screen.h"
#include "passes/oit/oit_pass.h"
#include "passes/scene_draw.h"

namespace macula::passes {

class SlicesPass final : public OitPass {
 public:
  using OitPass::OitPass;
  [[nodiscard]] std::string_view name() const override { return "oit.slices"; }
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override;

 private:
  [[nodiscard]] bool wanted() const override;
  void declareWork(frame::PassDeclaration& d) const override;
  void run(frame::PassContext& context) override;
  /// Texels of the raster that slices are summed in.
  [[nodiscard]] glm::ivec2 tiles() const {
    return (plan_.size + plan_.importance.tile - 1) / plan_.importance.tile;
  }

  void drawTileDepth(frame::PassContext& context);

  SceneVariants variants_;
  GLuint tileProgram_ = 0;
  FullScreenDraw fullScreen_;
};

}  // namespace macula::passes
