// Depth peeling (Everitt 2001), exact at equal depths: each layer takes three geometry passes, for
// its depth, the least id at that depth, and its colour.
#pragma once

#include "engine/gl/objects.h"
#include "passes/oit/oit_pass.h"
#include "passes/scene_draw.h"

namespace macula::passes {

class PeelPass final : public OitPass {
 public:
  using OitPass::OitPass;
  [[nodiscard]] std::string_view name() const override { return "oit.peel"; }
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override;

 private:
  [[nodiscard]] bool wanted() const override;
  void declareWork(frame::PassDeclaration& d) const override;
  void run(frame::PassContext& context) override;
  /// Draws the depths of the next layer. @returns whether there was any
  bool drawDepths(frame::PassContext& context);
  void drawIds(frame::PassContext& context);
  void drawColors(frame::PassContext& context);
  void composite(frame::PassContext& context, GLuint program);

  SceneVariants depths_;
  SceneVariants ids_;
  SceneVariants colors_;
  GLuint layerProgram_ = 0;
  GLuint finishProgram_ = 0;
  gl::QueryId query_;
};

}  // namespace macula::passes
