// Occupancy culling (Vasilakis 2015): a bit map of depth intervals says which of them hold a
// transparent fragment. Fragments behind the k-th occupied interval cannot be among the k nearest
// (Lemma 2.1), so the capture tests against a depth that rejects them before they are shaded.
#include "engine/gl/render_state.h"
#include "passes/full_screen.h"
#include "passes/oit/oit_pass.h"
#include "passes/oit/passes.h"
#include "passes/scene_draw.h"
#include "shared/bindings.h"

namespace macula::passes {
namespace {

using frame::Access;

/// Per pixel, a bit for each depth interval. Empty between frames: the pass that counts the bits
/// resets them, which is cheaper than to clear all of it.
constexpr frame::Resource kOccupancy{"occupancy", 0, frame::SizeRule::Declared,
                                     frame::ByteClass::Overhead, frame::Initial::Zero};

/// Rows of shaders/lib/occupancy.glsl.
void occupancyRows(frame::PassDeclaration& d, const OitPlan& plan, Access access) {
  d.texture(TEX_INPUT0, kFragmentCount);
  d.texture(TEX_INPUT1, kDepthRange);
  if (plan.method->hasRanges()) d.image(IMG_0, kFragmentRange, Access::Read);
  d.storage(SSBO_OCCUPANCY, kOccupancy, access);
  const auto pixels =
      static_cast<std::size_t>(plan.imageSize.x) * static_cast<std::size_t>(plan.imageSize.y);
  d.bytes(kOccupancy,
          pixels * static_cast<std::size_t>(plan.options.cullWords) * sizeof(std::uint32_t));
}

/// Marks the intervals that hold a fragment (section 2).
class OccupancyPass final : public OitPass {
 public:
  using OitPass::OitPass;
  [[nodiscard]] std::string_view name() const override { return "oit.occupancy"; }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    d.scene();
    depthTarget(d);
    occupancyRows(d, plan_, Access::ReadWriteHistory);
  }

  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override {
    gl::Defines defines{{"POSITION_ONLY", "1"}};
    if (plan_.method->hasRanges()) defines.emplace_back("RANGES", "1");
    if (plan_.sync == SyncMode::Ordered) defines.emplace_back("SYNC_ORDERED", "1");
    variants_.prepare(in.gpu->transparent().depthRuns, "oit/occupancy.frag", defines, {}, programs);
  }

 private:
  [[nodiscard]] bool wanted() const override { return plan_.culls(); }

  void run(frame::PassContext& context) override {
    const scene::GpuScene& gpu = *context.inputs().gpu;
    gl::apply({.depthTest = true});
    variants_.draw(gpu, gpu.transparent(), gpu.transparent().depthRuns);
  }

  SceneVariants variants_;
};

/// Turns the bit map into a depth, and empties it.
class CullDepthPass final : public OitPass {
 public:
  using OitPass::OitPass;
  [[nodiscard]] std::string_view name() const override { return "oit.cullDepth"; }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    d.depth(kCullDepth, Access::Write);
    d.viewport(plan_.size);
    depthTexture(d, TEX_INPUT2);
    occupancyRows(d, plan_, Access::ReadWrite);
  }

  void prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) override {
    gl::Defines defines;
    if (plan_.method->hasRanges()) defines.emplace_back("RANGES", "1");
    program_ = programs.get({{"oit/full_screen.vert", "oit/cull_depth.frag"}, defines, {}});
  }

 private:
  [[nodiscard]] bool wanted() const override { return plan_.culls(); }

  void run(frame::PassContext& /*context*/) override {
    gl::apply({.depthTest = true, .depthFunc = GL_ALWAYS, .depthWrite = true});
    fullScreen_.draw(program_);
  }

  GLuint program_ = 0;
  FullScreenDraw fullScreen_;
};

}  // namespace

OitPassPtr makeOccupancyPass(const OitPlan& plan) {
  return std::make_unique<OccupancyPass>(plan);
}

OitPassPtr makeCullDepthPass(const OitPlan& plan) {
  return std::make_unique<CullDepthPass>(plan);
}

}  // namespace macula::passes
