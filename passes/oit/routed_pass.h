// Stencil-routed k-buffer (Bavoil and Myers 2008): the first k fragments drawn go to the samples of
// a multisample target.
#pragma once

#include "passes/oit/oit_pass.h"
#include "passes/oit/stencil_routing.h"
#include "passes/scene_draw.h"

namespace macula::passes {

class RoutedPass final : public OitPass {
 public:
  using OitPass::OitPass;
  [[nodiscard]] std::string_view name() const override { return "oit.route"; }
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override;

 private:
  [[nodiscard]] bool wanted() const override;
  void declareWork(frame::PassDeclaration& d) const override;
  void run(frame::PassContext& context) override;

  SceneVariants variants_;
  FullScreenDraw fullScreen_;
  RoutingMode mode_ = RoutingMode::None;
  GLuint routing_ = 0;
};

}  // namespace macula::passes
