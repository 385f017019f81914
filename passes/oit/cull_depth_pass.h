// The depth behind which no fragment is among the k nearest (Vasilakis 2015, Lemma 2.1).
#pragma once

#include "passes/full_screen.h"
#include "passes/oit/oit_pass.h"

namespace macula::passes {

class CullDepthPass final : public OitPass {
 public:
  using OitPass::OitPass;
  [[nodiscard]] std::string_view name() const override { return "oit.cullDepth"; }
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override;

 private:
  [[nodiscard]] bool wanted() const override;
  void declareWork(frame::PassDeclaration& d) const override;
  void run(frame::PassContext& context) override;

  GLuint program_ = 0;
  FullScreenDraw fullScreen_;
};

}  // namespace macula::passes
