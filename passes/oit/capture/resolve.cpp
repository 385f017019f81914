// Slots into the image: the stored fragments of each pixel, nearest first, over what lies behind.
#include "passes/oit/oit_pass.h"
#include "passes/oit/passes.h"
#include "shared/bindings.h"

namespace macula::passes {
namespace {

using frame::Access;

class ResolvePass final : public OitPass {
 public:
  using OitPass::OitPass;
  [[nodiscard]] std::string_view name() const override { return "oit.resolve"; }

  [[nodiscard]] bool wanted() const override { return plan_.method->stores(); }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    const Method& method = *plan_.method;
    if (method.hasRanges()) d.texture(TEX_INPUT0, kFragmentRange);
    if (method.captures()) {
      if (method.hasFill()) d.texture(TEX_INPUT1, kFragmentFill);
      // Sorting in place leaves the pool in another order.
      keysRow(d, plan_, Access::ReadInvalidate);
      colorsRow(d, plan_, Access::ReadInvalidate);
      linksRow(d, plan_, Access::ReadInvalidate);
    } else {
      d.texture(TEX_INPUT3, kRoutedKeys);
      d.texture(TEX_INPUT4, kRoutedColors);
    }
    if (plan_.denseTail()) d.texture(TEX_INPUT2, kTailSums);
    colorImage(d, IMG_0);
  }

  void prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) override {
    program_ = programs.get({{"oit/resolve.comp"}, definesOf(plan_), {}});
  }

 private:
  void run(frame::PassContext& context) override {
    glUseProgram(program_);
    context.dispatch(plan_.size, kFullScreenGroup);
  }

  GLuint program_ = 0;
};

}  // namespace

OitPassPtr makeResolvePass(const OitPlan& plan) {
  return std::make_unique<ResolvePass>(plan);
}

}  // namespace macula::passes
