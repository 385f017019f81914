// The k nearest keys of each pixel by atomic minima (Maule et al. 2013).
#pragma once

#include "passes/oit/oit_pass.h"
#include "passes/scene_draw.h"

namespace macula::passes {

class AtomicKeysPass final : public OitPass {
 public:
  using OitPass::OitPass;
  [[nodiscard]] std::string_view name() const override { return "oit.keys"; }
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override;

 private:
  [[nodiscard]] bool wanted() const override;
  void declareWork(frame::PassDeclaration& d) const override;
  void run(frame::PassContext& context) override;

  SceneVariants depths_;
  SceneVariants ids_;
};

}  // namespace macula::passes
