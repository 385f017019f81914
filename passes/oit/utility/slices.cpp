// Sums transparent fragments into depth slices, from which utilities are predicted
// (shaders/lib/slices.glsl, shaders/lib/predicted_error.glsl).
#include "engine/gl/render_state.h"
#include "passes/full_screen.h"
#include "passes/light_defines.h"
#include "passes/oit/oit_pass.h"
#include "passes/oit/passes.h"
#include "passes/oit/utility/demand.h"
#include "passes/scene_draw.h"
#include "shared/bindings.h"

namespace macula::passes {
namespace {

using frame::Access;

/// Farthest opaque depth of a tile.
constexpr frame::Resource kTileDepth{"tile depth", GL_DEPTH_COMPONENT32F, frame::SizeRule::Declared,
                                     frame::ByteClass::Overhead, frame::Initial::Undefined};

class SlicesPass final : public OitPass {
 public:
  using OitPass::OitPass;
  [[nodiscard]] std::string_view name() const override { return "oit.slices"; }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    const glm::ivec2 most = tilesOf(plan_.imageSize);
    if (tiled()) {
      d.depth(kTileDepth, Access::Write);
      d.size(kTileDepth, most);
      d.viewport(tilesOf(plan_.size));
      depthTexture(d, TEX_INPUT0);
      d.step();
      d.depth(kTileDepth);
      d.viewport(tilesOf(plan_.size));
    } else {
      depthTarget(d);
    }
    d.scene();
    d.texture(TEX_INPUT1, kDepthRange);
    d.storage(SSBO_SLICES, kSliceSums, Access::ReadWrite);
    constexpr std::size_t kSliceBytes = 16;
    d.bytes(kSliceSums, static_cast<std::size_t>(most.x) * static_cast<std::size_t>(most.y) *
                            static_cast<std::size_t>(plan_.importance.slices) * kSliceBytes);
  }

  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override {
    gl::Defines defines = sliceDefines(plan_);
    defines.emplace_back("VERTEX_LIGHT", "1");
    if (plan_.sync == SyncMode::Ordered) defines.emplace_back("SYNC_ORDERED", "1");
    for (auto& define : lightDefines(in)) defines.push_back(std::move(define));
    if (plan_.usesNetwork()) defines.emplace_back("LEARNED", "1");
    variants_.prepare(in.gpu->transparent().runs, "oit/slices.frag", defines, {}, programs);
    if (tiled()) {
      tileProgram_ = programs.get({{"oit/full_screen.vert", "oit/tile_depth.frag"}, {}, {}});
    }
  }

 private:
  [[nodiscard]] bool wanted() const override { return plan_.slices(); }
  /// Pixels share their slices.
  [[nodiscard]] bool tiled() const { return plan_.importance.tile > 1; }
  [[nodiscard]] glm::ivec2 tilesOf(glm::ivec2 size) const {
    return (size + plan_.importance.tile - 1) / plan_.importance.tile;
  }

  void run(frame::PassContext& context) override {
    const scene::GpuScene& gpu = *context.inputs().gpu;
    if (tiled()) {
      gl::apply({.depthTest = true, .depthFunc = GL_ALWAYS, .depthWrite = true});
      fullScreen_.draw(tileProgram_);
      context.beginStep(1);
    }
    gl::apply({.depthTest = true});
    variants_.draw(gpu, gpu.transparent(), gpu.transparent().runs);
  }

  SceneVariants variants_;
  GLuint tileProgram_ = 0;
  FullScreenDraw fullScreen_;
};

}  // namespace

OitPassPtr makeSlicesPass(const OitPlan& plan) {
  return std::make_unique<SlicesPass>(plan);
}

}  // namespace macula::passes
