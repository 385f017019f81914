// Full-rate pixels from low-rate samples, and the shading of pixels that no sample fits.
#include "passes/lod/lod_pass.h"
#include "passes/lod/passes.h"
#include "passes/opaque_shading.h"
#include "shared/bindings.h"

namespace macula::passes {
namespace {

using frame::Access;

class ReconstructPass final : public LodPass {
 public:
  using LodPass::LodPass;
  [[nodiscard]] std::string_view name() const override { return "lod.reconstruct"; }

  /// All rows rest where r is 1: then every pixel is shaded.
  void declare(frame::PassDeclaration& d, const frame::FrameInputs& in) const override {
    const bool active = !plan_.fullRate();
    d.texture(TEX_INPUT0, kLodSamples).when(active);
    if (plan_.reconstruction != Reconstruction::Bilinear) {
      d.texture(TEX_INPUT1, kDepth).when(active);
      d.texture(TEX_INPUT2, kNormal).when(active);
    }
    if (plan_.foveated) d.texture(TEX_INPUT3, kShadingRate).when(active);
    if (plan_.demodulates) {
      d.texture(TEX_INPUT4, kBaseColor).when(active);
      d.texture(TEX_INPUT5, kEmissive).when(active);
      if (in.facts.unlitOpaque) d.texture(TEX_INPUT6, kSurface).when(active);
    }
    d.image(IMG_0, target(), Access::Write).when(active);
    if (!plan_.shadesHoles()) return;
    d.storage(SSBO_LOD_TOTALS, kLodTotals, Access::ReadWrite).when(active);
    d.storage(SSBO_LOD_HOLES, kLodHoles, Access::Write).when(active);
    d.bytes(kLodHoles, static_cast<std::size_t>(in.displaySize.x) *
                           static_cast<std::size_t>(in.displaySize.y) * sizeof(std::uint32_t));
  }

  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override {
    gl::Defines defines;
    if (plan_.reconstruction == Reconstruction::Bilinear) defines.emplace_back("BILINEAR", "1");
    if (plan_.reconstruction == Reconstruction::Yang2008) defines.emplace_back("YANG2008", "1");
    if (!plan_.parts.shading) defines.emplace_back("PARTS", "1");
    if (plan_.foveated) defines.emplace_back("FOVEATED", "1");
    if (plan_.demodulates) {
      defines.emplace_back("DEMODULATE", "1");
      if (in.facts.unlitOpaque) defines.emplace_back("UNLIT", "1");
    }
    if (plan_.shadesHoles()) defines.emplace_back("SHADE_HOLES", "1");
    program_ = programs.get({{"lod/reconstruct.comp"}, defines, {}});
  }

  void execute(frame::PassContext& context) override {
    if (plan_.fullRate()) return;
    glUseProgram(program_);
    if (plan_.reconstruction == Reconstruction::Yang2008) {
      glUniform2f(0, plan_.sigma.x, plan_.sigma.y);
    }
    context.dispatch(plan_.size, kGroup);
  }

 private:
  GLuint program_ = 0;
};

/// Shades the pixels at which the reconstruction failed.
class HolesPass final : public LodPass {
 public:
  using LodPass::LodPass;
  [[nodiscard]] std::string_view name() const override { return "lod.holes"; }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& in) const override {
    declareShadingInputs(d, in.facts, work(), plan_.parts, false);
    const bool active = !plan_.fullRate();
    d.storage(SSBO_LOD_HOLES, kLodHoles, Access::Read).when(active);
    d.storage(SSBO_LOD_TOTALS, kLodTotals, Access::Read).when(active);
    d.indirect(kLodTotals).when(active);
    d.image(IMG_0, target(), Access::ReadWrite).when(active);  // the other pixels stay
  }

  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override {
    gl::Defines defines = shadingDefines(in, work(), plan_.parts);
    defines.emplace_back("AT_HOLES", "1");
    program_ = programs.get({{"lighting.comp"}, defines, {}});
  }

  void execute(frame::PassContext& context) override {
    if (plan_.fullRate()) return;
    glUseProgram(program_);
    for (int i = 0; i < plan_.load; ++i) {
      if (i > 0) context.beginStep(0);  // each writes the same pixels
      context.dispatchIndirect(kLodTotals, dispatchOffset(LOD_RATES));
    }
  }

 private:
  [[nodiscard]] bool used() const override { return plan_.shadesHoles(); }
  [[nodiscard]] ShadingWork work() const {
    return plan_.parts.shading ? ShadingWork::All : ShadingWork::Parts;
  }

  GLuint program_ = 0;
};

}  // namespace

LodPassPtr makeLodReconstructPass(const LodPlan& plan) {
  return std::make_unique<ReconstructPass>(plan);
}

LodPassPtr makeLodHolesPass(const LodPlan& plan) {
  return std::make_unique<HolesPass>(plan);
}

}  // namespace macula::passes
