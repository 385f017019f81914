// Fragments into the slots of their pixels.
#include "engine/gl/render_state.h"
#include "passes/light_defines.h"
#include "passes/oit/oit_pass.h"
#include "passes/oit/passes.h"
#include "passes/scene_draw.h"
#include "shared/bindings.h"
#include "shared/oit_constants.h"

namespace macula::passes {
namespace {

using frame::Access;

/// One spin lock a pixel, open between passes.
constexpr frame::Resource kFragmentLock{"fragment lock", GL_R32UI, frame::SizeRule::Display,
                                        frame::ByteClass::Overhead, frame::Initial::Zero};

/// The k nearest keys of each pixel by atomic minima (Maule et al. 2013).
class AtomicKeysPass final : public OitPass {
 public:
  using OitPass::OitPass;
  [[nodiscard]] std::string_view name() const override { return "oit.keys"; }

  [[nodiscard]] bool wanted() const override { return plan_.method->runs(name()); }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    d.update(kFragmentKeys);
    for (std::uint32_t stage = 0; stage < kStages; ++stage) {
      d.step();
      d.scene();
      testedDepthTarget(d);
      keysRow(d, plan_, Access::ReadWrite);
    }
  }

  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override {
    const auto& runs = in.gpu->transparent().depthRuns;
    const gl::Defines depths{{"POSITION_ONLY", "1"}, {"WITH_IDS", "1"}};
    gl::Defines ids = depths;
    ids.emplace_back("STAGE_IDS", "1");
    stages_[0].prepare(runs, "oit/atomic_keys.frag", depths, {}, programs);
    stages_[1].prepare(runs, "oit/atomic_keys.frag", ids, {}, programs);
  }

 private:
  static constexpr std::uint32_t kStages = 2;  // ids go to depths that are final

  void run(frame::PassContext& context) override {
    const scene::GpuScene& gpu = *context.inputs().gpu;
    context.fill(kFragmentKeys, NO_KEY);
    for (std::uint32_t stage = 0; stage < kStages; ++stage) {
      context.beginStep(stage + 1);
      gl::apply({.depthTest = true});
      stages_[stage].draw(gpu, gpu.transparent(), gpu.transparent().depthRuns);
    }
  }

  std::array<SceneVariants, kStages> stages_;
};

/// Shades fragments and stores them as the method inserts them.
class CapturePass final : public OitPass {
 public:
  using OitPass::OitPass;
  [[nodiscard]] std::string_view name() const override { return "oit.capture"; }

  [[nodiscard]] bool wanted() const override { return plan_.method->captures(); }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& in) const override {
    const Method& method = *plan_.method;
    d.scene();
    shadowMap(d, in);
    testedDepthTarget(d);
    if (plan_.denseTail()) d.color(0, kTailSums, Access::Write);
    if (plan_.predictsCounts()) d.color(0, kFragmentCount, Access::Write);
    if (method.hasRanges()) d.image(IMG_0, kFragmentRange, Access::Read);
    if (method.hasFill()) d.image(IMG_1, kFragmentFill, Access::ReadWrite);
    if (plan_.keepsFrontNormal()) d.image(IMG_2, kFrontNormal, Access::WritePersistent);
    if (plan_.usesLocks()) d.image(IMG_3, kFragmentLock, Access::ReadInvalidate);
    // Sorted keys, and the tails that an allocation has emptied, are there already.
    const bool keysThere = method.insertion.keysFirst || plan_.emptiesTails();
    keysRow(d, plan_, keysThere ? Access::ReadWrite : Access::Write);
    colorsRow(d, plan_, plan_.emptiesTails() ? Access::ReadWrite : Access::Write);
    linksRow(d, plan_, Access::Write);
    totalsRow(d, Access::ReadWrite);
  }

  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override {
    gl::Defines defines = captureDefines(plan_);
    for (auto& define : lightingDefines(in)) defines.push_back(std::move(define));
    variants_.prepare(drawsOf(*in.gpu).runs, "oit/capture.frag", defines, captureExtensions(plan_),
                      programs);
  }

 private:
  void run(frame::PassContext& context) override {
    const scene::GpuScene& gpu = *context.inputs().gpu;
    if (plan_.denseTail() || plan_.predictsCounts()) {
      gl::apply({.depthTest = true, .blend = gl::Blend::Add});
      constexpr GLfloat kNone[4]{};
      glClearBufferfv(GL_COLOR, 0, kNone);
    } else {
      gl::apply({.depthTest = true});
    }
    variants_.draw(gpu, drawsOf(gpu), drawsOf(gpu).runs);
  }

  /// Only what is kept nearest first does not depend on the order.
  [[nodiscard]] const scene::DrawList& drawsOf(const scene::GpuScene& gpu) const {
    const bool ordered = plan_.method->sorts() && !plan_.method->isRacy();
    return ordered ? gpu.transparent() : gpu.transparentInOrder();
  }

  SceneVariants variants_;
};

}  // namespace

OitPassPtr makeAtomicKeysPass(const OitPlan& plan) {
  return std::make_unique<AtomicKeysPass>(plan);
}
OitPassPtr makeCapturePass(const OitPlan& plan) {
  return std::make_unique<CapturePass>(plan);
}

}  // namespace macula::passes
