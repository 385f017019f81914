// Depth seen by the shadow-casting light.
#pragma once

#include "engine/frame/pass.h"
#include "engine/frame/pass_context.h"
#include "passes/scene_draw.h"

namespace macula::passes {

/// Draws the shadow map once for a scene: neither lights nor objects move.
class ShadowPass final : public frame::Pass {
 public:
  struct Settings {
    int size = 2048;  ///< texels a side
  };
  explicit ShadowPass(const Settings& settings) : settings_(settings) {}
  [[nodiscard]] std::string_view name() const override { return "shadow"; }
  void declare(frame::PassDeclaration& d, const frame::FrameInputs& in) const override;
  [[nodiscard]] bool hasWork(const frame::FrameInputs& in) const override;
  [[nodiscard]] std::string reason(const frame::FrameInputs& in) const override;
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override;
  void execute(frame::PassContext& context) override;

 private:
  const Settings& settings_;
  SceneVariants variants_;
  bool drawn_ = false;
};

}  // namespace macula::passes
