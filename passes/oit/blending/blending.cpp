// Methods that store no fragments: blending in draw order, and weighted blended transparency
// (McGuire and Bavoil 2013), whose weighted sums do not depend on order.
#include "engine/gl/render_state.h"
#include "passes/light_defines.h"
#include "passes/oit/oit_pass.h"
#include "passes/oit/passes.h"
#include "passes/scene_draw.h"
#include "shared/bindings.h"

namespace macula::passes {
namespace {

using frame::Access;

/// Sums of weighted premultiplied colours and of weighted alpha.
constexpr frame::Resource kWeightedColors{"weighted colours", GL_RGBA32F, frame::SizeRule::Display,
                                          frame::ByteClass::Oit, frame::Initial::Undefined};

class BlendPass final : public OitPass {
 public:
  using OitPass::OitPass;
  [[nodiscard]] std::string_view name() const override { return "oit.blend"; }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& in) const override {
    d.scene();
    shadowMap(d, in);
    depthTarget(d);
    colorTarget(d, 0);
  }

  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override {
    variants_.prepare(in.gpu->transparentInOrder().runs, "oit/blend.frag", lightingDefines(in), {},
                      programs);
  }

 private:
  [[nodiscard]] bool wanted() const override { return plan_.method->runs(name()); }

  void run(frame::PassContext& context) override {
    const scene::GpuScene& gpu = *context.inputs().gpu;
    gl::apply({.depthTest = true, .blend = gl::Blend::Premultiplied});
    variants_.draw(gpu, gpu.transparentInOrder(), gpu.transparentInOrder().runs);
  }

  SceneVariants variants_;
};

/// Weighted sums, by blending.
class WeightedPass final : public OitPass {
 public:
  using OitPass::OitPass;
  [[nodiscard]] std::string_view name() const override { return "oit.weighted"; }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& in) const override {
    d.scene();
    shadowMap(d, in);
    depthTarget(d);
    d.color(0, kWeightedColors, Access::Write);
    d.color(1, kTailSums, Access::Write);
  }

  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override {
    variants_.prepare(in.gpu->transparentInOrder().runs, "oit/weighted.frag", lightingDefines(in),
                      {}, programs);
  }

 private:
  [[nodiscard]] bool wanted() const override { return plan_.method->runs(name()); }

  void run(frame::PassContext& context) override {
    const scene::GpuScene& gpu = *context.inputs().gpu;
    gl::apply({.depthTest = true, .blend = gl::Blend::Add});
    constexpr GLfloat kNone[4]{};
    glClearBufferfv(GL_COLOR, 0, kNone);
    glClearBufferfv(GL_COLOR, 1, kNone);
    variants_.draw(gpu, gpu.transparentInOrder(), gpu.transparentInOrder().runs);
  }

  SceneVariants variants_;
};

/// Composites the weighted mean colour over the image (McGuire and Bavoil 2013, Eq. 6).
class WeightedResolvePass final : public OitComputePass {
 public:
  using OitComputePass::OitComputePass;
  [[nodiscard]] std::string_view name() const override { return "oit.weightedResolve"; }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    d.texture(TEX_INPUT0, kWeightedColors);
    d.texture(TEX_INPUT1, kTailSums);
    colorImage(d, IMG_0);
  }

 private:
  [[nodiscard]] bool wanted() const override { return plan_.method->runs(name()); }

  [[nodiscard]] gl::ProgramKey program() const override {
    return {{"oit/weighted_resolve.comp"}, {}, {}};
  }

  void dispatch(const frame::PassContext& context) override {
    context.dispatch(plan_.size, kFullScreenGroup);
  }
};

}  // namespace

OitPassPtr makeBlendPass(const OitPlan& plan) {
  return std::make_unique<BlendPass>(plan);
}

OitPassPtr makeWeightedPass(const OitPlan& plan) {
  return std::make_unique<WeightedPass>(plan);
}

OitPassPtr makeWeightedResolvePass(const OitPlan& plan) {
  return std::make_unique<WeightedResolvePass>(plan);
}

}  // namespace macula::passes
