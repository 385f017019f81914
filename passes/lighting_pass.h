// Deferred lighting of the opaque image, and its background.
#pragma once

#include "engine/frame/pass.h"
#include "engine/frame/pass_context.h"

namespace macula::passes {

class LightingPass final : public frame::Pass {
 public:
  [[nodiscard]] std::string_view name() const override { return "lighting"; }
  void declare(frame::PassDeclaration& d) const override;
  [[nodiscard]] bool hasWork(const frame::FrameInputs& in) const override;
  [[nodiscard]] std::string reason(const frame::FrameInputs& in) const override;
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override;
  void execute(frame::PassContext& context) override;

 private:
  GLuint program_ = 0;
  bool shadows_ = false;
};

}  // namespace macula::passes
