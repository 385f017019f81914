// Which samples of the reduced-rate image are shaded, and their shading.
#include "passes/lod/lod_pass.h"
#include "passes/lod/passes.h"
#include "passes/opaque_shading.h"
#include "shared/bindings.h"

namespace macula::passes {
namespace {

using frame::Access;

/// Empties the lists, and where shading is foveated gives each tile its rate and puts it in a list.
class RatesPass final : public LodPass {
 public:
  using LodPass::LodPass;
  [[nodiscard]] std::string_view name() const override { return "lod.rates"; }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& in) const override {
    d.update(kLodTotals);
    d.bytes(kLodTotals, sizeof(shader::LodTotals));
    if (!plan_.foveated) return;
    d.step();
    const glm::ivec2 tiles = (in.displaySize + LOD_TILE - 1) / LOD_TILE;
    d.image(IMG_0, kShadingRate, Access::Write);
    d.size(kShadingRate, tiles);
    d.storage(SSBO_LOD_TILES, kLodTiles, Access::Write);
    d.bytes(kLodTiles, static_cast<std::size_t>(tiles.x) * static_cast<std::size_t>(tiles.y) *
                           LOD_RATES * sizeof(std::uint32_t));
    d.storage(SSBO_LOD_TOTALS, kLodTotals, Access::ReadWrite);
  }

  void prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) override {
    if (plan_.foveated) program_ = programs.get({{"lod/rates.comp"}, {}, {}});
  }

  void execute(frame::PassContext& context) override {
    shader::LodTotals zero{};
    for (glm::uvec4& dispatch : zero.dispatches) dispatch = {0U, 1U, 1U, 0U};
    context.resources().upload(kLodTotals, &zero, sizeof(zero));
    if (!plan_.foveated) return;
    context.beginStep(1);
    glUseProgram(program_);
    context.dispatch(plan_.tiles, kGroup);
  }

 private:
  GLuint program_ = 0;
};

/// Shades the samples, or every pixel where r is 1.
class ShadePass final : public LodPass {
 public:
  using LodPass::LodPass;
  [[nodiscard]] std::string_view name() const override { return "lod.shade"; }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& in) const override {
    declareShadingInputs(d, in.facts, work(), plan_.parts, true);
    if (plan_.foveated) {
      d.storage(SSBO_LOD_TILES, kLodTiles, Access::Read);
      d.storage(SSBO_LOD_TOTALS, kLodTotals, Access::Read);
      d.indirect(kLodTotals);
    }
    d.image(IMG_0, kLodSamples, Access::Write).when(!plan_.fullRate());
    d.image(IMG_0, target(), Access::Write).when(plan_.fullRate());
  }

  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override {
    gl::Defines defines = shadingDefines(in, work(), plan_.parts);
    pixels_ = programs.get({{"lighting.comp"}, defines, {}});
    if (plan_.demodulates) defines.emplace_back("DEMODULATE", "1");
    defines.emplace_back(plan_.foveated ? "AT_TILES" : "AT_GRID", "1");
    samples_ = programs.get({{"lighting.comp"}, defines, {}});
  }

  void execute(frame::PassContext& context) override {
    glUseProgram(plan_.fullRate() ? pixels_ : samples_);
    for (int i = 0; i < plan_.load; ++i) {
      if (i > 0) context.beginStep(0);  // each writes the same samples
      if (!plan_.foveated) {
        context.dispatch(plan_.fullRate() ? plan_.size : plan_.texels, kGroup);
        continue;
      }
      for (int level = 0; level < LOD_RATES; ++level) {
        glUniform1i(0, level);
        context.dispatchIndirect(kLodTotals, dispatchOffset(level));
      }
    }
  }

 private:
  [[nodiscard]] ShadingWork work() const {
    return plan_.parts.shading ? ShadingWork::All : ShadingWork::Parts;
  }

  GLuint pixels_ = 0;   ///< every pixel
  GLuint samples_ = 0;  ///< those of the grid, or of the tiles
};

}  // namespace

LodPassPtr makeLodRatesPass(const LodPlan& plan) {
  return std::make_unique<RatesPass>(plan);
}

LodPassPtr makeLodShadePass(const LodPlan& plan) {
  return std::make_unique<ShadePass>(plan);
}

}  // namespace macula::passes
