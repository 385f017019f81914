// Before and after transparency at a reduced rate: the opaque depth of its texels, and the result
// over the full-rate opaque image.
#include <string>

#include "engine/frame/pass_context.h"
#include "engine/gl/render_state.h"
#include "passes/full_screen.h"
#include "passes/lod/passes.h"
#include "passes/resources.h"
#include "shared/bindings.h"
#include "shared/dispatch.h"

namespace macula::passes {
namespace {

using frame::Access;

constexpr glm::ivec2 kGroup{FULLSCREEN_GROUP};

/// All rows of these passes rest while transparency is drawn at full rate.
class ReducedTransparencyPass : public frame::Pass {
 public:
  explicit ReducedTransparencyPass(const LodPlan& plan) : plan_(plan) {}
  [[nodiscard]] bool hasWork(const frame::FrameInputs& in) const final {
    return plan_.transparency && in.facts.transparentTriangles > 0;
  }
  [[nodiscard]] std::string reason(const frame::FrameInputs& in) const final {
    if (in.facts.transparentTriangles == 0) return "nothing transparent";
    return plan_.transparency ? "transparent surfaces are drawn at a lower rate"
                              : "transparent surfaces are drawn at full rate";
  }

 protected:
  /// Samples of the image a texel, per axis: L covers the image exactly, so that what is drawn at
  /// its texels lies where it lies in the image; r where it divides the size.
  [[nodiscard]] glm::vec2 pitch() const { return glm::vec2(plan_.size) / glm::vec2(plan_.texels); }

  const LodPlan& plan_;
};

/// Opaque depth of the texels at which transparency is drawn, and nothing over them yet.
class DepthPass final : public ReducedTransparencyPass {
 public:
  using ReducedTransparencyPass::ReducedTransparencyPass;
  [[nodiscard]] std::string_view name() const override { return "lod.depth"; }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    const bool active = plan_.resizesTransparency();
    d.texture(TEX_INPUT0, kDepth).when(active);
    d.depth(kReducedDepth, Access::Write).when(active);
    d.color(0, kReducedColor, Access::Write).when(active);
    d.viewport(plan_.texels);
  }

  void prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) override {
    program_ = programs.get({{"oit/full_screen.vert", "lod/depth.frag"}, {}, {}});
  }

  void execute(frame::PassContext& /*context*/) override {
    if (!plan_.resizesTransparency()) return;
    gl::apply({.depthTest = true, .depthFunc = GL_ALWAYS, .depthWrite = true});
    glProgramUniform2f(program_, 0, pitch().x, pitch().y);
    fullScreen_.draw(program_);
  }

 private:
  FullScreenDraw fullScreen_;
  GLuint program_ = 0;
};

class TransparencyPass final : public ReducedTransparencyPass {
 public:
  using ReducedTransparencyPass::ReducedTransparencyPass;
  [[nodiscard]] std::string_view name() const override { return "lod.transparency"; }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& in) const override {
    const bool active = plan_.resizesTransparency();
    d.texture(TEX_INPUT0, kReducedColor).when(active);
    d.texture(TEX_INPUT1, kReducedDepth).when(active);
    if (in.facts.opaqueTriangles > 0) {
      d.texture(TEX_INPUT2, kDepth).when(active);
      d.texture(TEX_INPUT3, kNormal).when(active);
    }
    d.image(IMG_0, kHdrColor, Access::ReadWrite).when(active);
  }

  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override {
    gl::Defines defines;
    if (in.facts.opaqueTriangles == 0) defines.emplace_back("NOTHING_OPAQUE", "1");
    program_ = programs.get({{"lod/transparency.comp"}, defines, {}});
  }

  void execute(frame::PassContext& context) override {
    if (!plan_.resizesTransparency()) return;
    glUseProgram(program_);
    glUniform2f(0, pitch().x, pitch().y);
    glUniform2i(1, plan_.texels.x, plan_.texels.y);
    // A cell between texels each, and outside of the rim.
    context.dispatch(plan_.texels + 1, kGroup);
  }

 private:
  GLuint program_ = 0;
};

}  // namespace

LodPassPtr makeLodDepthPass(const LodPlan& plan) {
  return std::make_unique<DepthPass>(plan);
}

LodPassPtr makeLodTransparencyPass(const LodPlan& plan) {
  return std::make_unique<TransparencyPass>(plan);
}

}  // namespace macula::passes
