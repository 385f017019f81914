// Deferred lighting of the opaque image, and its background.
#pragma once

#include "engine/frame/pass.h"
#include "engine/frame/pass_context.h"
#include "passes/lod/plan.h"
#include "passes/opaque_shading.h"

namespace macula::passes {

/// Shades every pixel; parts that the level of detail computes at 1/r come from a texture. Has no
/// work where all of the shading is computed at 1/r.
class LightingPass final : public frame::Pass {
 public:
  explicit LightingPass(const LodPlan& lod) : lod_(lod) {}
  [[nodiscard]] std::string_view name() const override { return "lighting"; }
  void declare(frame::PassDeclaration& d, const frame::FrameInputs& in) const override;
  [[nodiscard]] bool hasWork(const frame::FrameInputs& in) const override;
  [[nodiscard]] std::string reason(const frame::FrameInputs& in) const override;
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override;
  void execute(frame::PassContext& context) override;

 private:
  [[nodiscard]] bool atReducedRate() const { return lod_.wanted && lod_.parts.shading; }
  [[nodiscard]] ShadingWork work() const {
    return lod_.wanted ? ShadingWork::AroundParts : ShadingWork::All;
  }

  const LodPlan& lod_;
  GLuint program_ = 0;
};

}  // namespace macula::passes
