// Importance of each pixel (Vasilakis 2017, Eq. 3-6), in fixed point of 1/65536 per unit, and its
// sum:
//   I = I_periphery I_depth I_Fresnel + lambda (xi - 0.5)
// shaders/lib/importance.glsl has each factor.
#include "passes/oit/oit_pass.h"
#include "passes/oit/passes.h"
#include "shared/bindings.h"

namespace macula::passes {
namespace {

using frame::Access;

class ImportancePass final : public OitComputePass {
 public:
  using OitComputePass::OitComputePass;
  [[nodiscard]] std::string_view name() const override { return "oit.importance"; }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    d.texture(TEX_INPUT0, plan_.countResource());
    d.image(IMG_2, kFrontNormal, Access::ReadWriteHistory);
    // 0 where nothing is transparent: only covered pixels are written.
    d.image(IMG_0, kImportance, Access::ReadWrite);
    if (plan_.factorMaps) d.image(IMG_1, kImportanceFactors, Access::ReadWrite);
    totalsRow(d, Access::ReadWrite);
  }

 private:
  [[nodiscard]] bool wanted() const override {
    return plan_.mapsImportance() && !plan_.usesNetwork();
  }

  [[nodiscard]] gl::ProgramKey program() const override {
    gl::Defines defines;
    if (plan_.factorMaps) defines.emplace_back("FACTORS", "1");
    return {{"oit/importance.comp"}, defines, {}};
  }

  void dispatch(const frame::PassContext& context) override {
    const ImportanceSettings& s = plan_.importance;
    glUniform4f(0, static_cast<float>(s.rangeBias), static_cast<float>(s.periphery),
                static_cast<float>(s.noise), plan_.layerLimit);
    glUniform1ui(1, plan_.seed + (s.noisePerFrame ? context.inputs().frameIndex : 0U));
    dispatchTiles(context, plan_.size);
  }
};

}  // namespace

OitPassPtr makeImportancePass(const OitPlan& plan) {
  return std::make_unique<ImportancePass>(plan);
}

}  // namespace macula::passes
