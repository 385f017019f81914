// How many fragments a pixel has: counted by additive blending, which needs no atomics, or
// reprojected from the last frame's capture.
#include "engine/gl/render_state.h"
#include "passes/light_defines.h"
#include "passes/oit/oit_pass.h"
#include "passes/oit/passes.h"
#include "passes/scene_draw.h"
#include "shared/bindings.h"

namespace macula::passes {
namespace {

using frame::Access;

constexpr GLfloat kNoFragments[4]{};
/// Nearest and minus farthest reversed depth, both less than any.
constexpr GLfloat kNoDepth[4]{-2.0F, -2.0F, 0.0F, 0.0F};

const gl::Defines kPositionOnly{{"POSITION_ONLY", "1"}};

/// Draws the transparent runs that need positions alone, so that target 0 counts their fragments.
class CountDraw {
 public:
  void prepare(const frame::FrameInputs& in, const gl::Defines& defines,
               gl::ProgramCache& programs) {
    variants_.prepare(in.gpu->transparent().depthRuns, "oit/count.frag", defines, {}, programs);
  }
  void draw(const scene::GpuScene& gpu, gl::Blend blend) const {
    gl::apply({.depthTest = true, .blend = blend});
    glClearBufferfv(GL_COLOR, 0, kNoFragments);
    variants_.draw(gpu, gpu.transparent(), gpu.transparent().depthRuns);
  }

 private:
  SceneVariants variants_;
};

class CountPass final : public OitPass {
 public:
  using OitPass::OitPass;
  [[nodiscard]] std::string_view name() const override { return "oit.count"; }

  [[nodiscard]] bool wanted() const override {
    if (plan_.gathersColors()) return false;  // counted with its colours
    return (plan_.method->counts() && !plan_.predictsCounts()) || plan_.culls();
  }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    d.scene();
    depthTarget(d);
    d.color(0, kFragmentCount, Access::Write);
    if (plan_.findsRange()) d.color(1, kDepthRange, Access::Write);
  }

  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override {
    gl::Defines defines = kPositionOnly;
    if (plan_.findsRange()) defines.emplace_back("RANGE", "1");
    count_.prepare(in, defines, programs);
  }

 private:
  void run(frame::PassContext& context) override {
    if (plan_.findsRange()) glClearBufferfv(GL_COLOR, 1, kNoDepth);
    count_.draw(*context.inputs().gpu, plan_.findsRange() ? gl::Blend::AddThenMax : gl::Blend::Add);
  }

  CountDraw count_;
};

/// Counts, and sums by the same blending what the thesis's network reads.
class CountColorsPass final : public OitPass {
 public:
  using OitPass::OitPass;
  [[nodiscard]] std::string_view name() const override { return "oit.countColors"; }

  [[nodiscard]] bool wanted() const override { return plan_.gathersColors(); }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    d.scene();
    depthTarget(d);
    d.color(0, kFragmentCount, Access::Write);
    d.color(1, kDepthRange, Access::Write);
    d.color(2, kColorSums, Access::Write);
    d.color(3, kNearestColor, Access::Write);
  }

  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override {
    gl::Defines defines{{"VERTEX_LIGHT", "1"}};
    for (auto& define : lightDefines(in)) defines.push_back(std::move(define));
    variants_.prepare(in.gpu->transparent().runs, "oit/count_colors.frag", defines, {}, programs);
  }

 private:
  void run(frame::PassContext& context) override {
    const scene::GpuScene& gpu = *context.inputs().gpu;
    gl::apply({.depthTest = true, .blend = gl::Blend::AddThenMax});
    glClearBufferfv(GL_COLOR, 0, kNoFragments);
    glClearBufferfv(GL_COLOR, 1, kNoDepth);
    glClearBufferfv(GL_COLOR, 2, kNoFragments);
    glClearBufferfv(GL_COLOR, 3, kNoFragments);
    variants_.draw(gpu, gpu.transparent(), gpu.transparent().runs);
  }

  SceneVariants variants_;
};

/// Reprojects the last frame's counts, so that no geometry pass has to count; where there is no
/// last frame it counts.
class PredictPass final : public OitPass {
 public:
  using OitPass::OitPass;
  [[nodiscard]] std::string_view name() const override { return "oit.predict"; }

  [[nodiscard]] bool wanted() const override { return plan_.predictsCounts(); }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    const bool predicts = plan_.historyValid;
    d.scene();
    depthTarget(d, !predicts);
    d.color(0, kPredictedCount, Access::Write).when(!predicts);
    d.texture(TEX_INPUT0, kFragmentCount, Access::ReadHistory).when(predicts);
    d.texture(TEX_INPUT1, kFragmentRange, Access::ReadHistory).when(predicts);
    d.texture(TEX_INPUT2, kFragmentFill, Access::ReadHistory).when(predicts);
    depthTexture(d, TEX_INPUT3, predicts);
    d.storage(SSBO_FRAGMENT_KEYS, kFragmentKeys, Access::ReadHistory).when(predicts);
    d.image(IMG_0, kPredictedCount, Access::Write).when(predicts);
  }

  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override {
    count_.prepare(in, kPositionOnly, programs);
    program_ = programs.get({{"oit/predict.comp"}, {}, {}});
  }

 private:
  void run(frame::PassContext& context) override {
    if (!plan_.historyValid) return count_.draw(*context.inputs().gpu, gl::Blend::Add);
    glUseProgram(program_);
    context.dispatch(plan_.size, kFullScreenGroup);
  }

  CountDraw count_;
  GLuint program_ = 0;
};

/// Counts for the report where the frame itself did not, after its time has been taken.
class ReportCountPass final : public OitPass {
 public:
  using OitPass::OitPass;
  [[nodiscard]] std::string_view name() const override { return "report.count"; }

  [[nodiscard]] bool wanted() const override { return plan_.countsForReport(); }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    d.scene();
    depthTarget(d);
    d.color(0, kReportCount, Access::Write);
  }

  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override {
    count_.prepare(in, kPositionOnly, programs);
  }

 private:
  void run(frame::PassContext& context) override {
    count_.draw(*context.inputs().gpu, gl::Blend::Add);
  }

  CountDraw count_;
};

}  // namespace

OitPassPtr makeCountPass(const OitPlan& plan) {
  return std::make_unique<CountPass>(plan);
}
OitPassPtr makeCountColorsPass(const OitPlan& plan) {
  return std::make_unique<CountColorsPass>(plan);
}
OitPassPtr makePredictPass(const OitPlan& plan) {
  return std::make_unique<PredictPass>(plan);
}
OitPassPtr makeReportCountPass(const OitPlan& plan) {
  return std::make_unique<ReportCountPass>(plan);
}

}  // namespace macula::passes
