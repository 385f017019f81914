// Opaque surfaces into the G-buffer.
#pragma once

#include "engine/frame/pass.h"
#include "engine/frame/pass_context.h"
#include "passes/scene_draw.h"

namespace macula::passes {

/// 20 bytes a sample: depth 4, octahedral normal 4, base colour and metallic 4, roughness,
/// occlusion, kind and geometric normal 4, emissive 4.
class GBufferPass final : public frame::Pass {
 public:
  [[nodiscard]] std::string_view name() const override { return "gbuffer"; }
  void declare(frame::PassDeclaration& d, const frame::FrameInputs& in) const override;
  [[nodiscard]] bool hasWork(const frame::FrameInputs& in) const override;
  [[nodiscard]] std::string reason(const frame::FrameInputs& in) const override;
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override;
  void execute(frame::PassContext& context) override;

 private:
  SceneVariants variants_;
};

}  // namespace macula::passes
