// Slots of each pixel by the published formulas, under a budget of M slots:
//   exact counts  k = n
//   kb-plus       k = min(n, K), K the largest with sum min(n, K) <= M (Vasilakis and Fudos 2014):
//                 oit.histogram counts the pixels of each n, oit.oneK finds K
//   importance    k = max(1, floor(I (M - Z) / sum I)) (Vasilakis 2017, Eq. 1); oit.reserve counts
//                 Z, the pixels whose share would round to 0 and that get a slot nevertheless
// oit.allocate then gives each pixel its range of the pool. All sums are integers, so that no order
// of threads changes a bit. Where slots go by marginal utility (utility/), none of these run.
#include "passes/oit/oit_pass.h"
#include "passes/oit/passes.h"
#include "shared/bindings.h"
#include "shared/oit_totals.h"

namespace macula::passes {
namespace {

using frame::Access;

/// Numbers of pixels with 1, 2, ... fragments.
constexpr frame::Resource kCountBins{"count bins", 0, frame::SizeRule::Declared,
                                     frame::ByteClass::Overhead, frame::Initial::Zero};

/// Counts covered pixels whose share of the budget rounds to nothing.
class ReservePass final : public OitComputePass {
 public:
  using OitComputePass::OitComputePass;
  [[nodiscard]] std::string_view name() const override { return "oit.reserve"; }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    d.texture(TEX_INPUT0, kFragmentCount);
    d.image(IMG_0, kImportance, Access::Read);
    totalsRow(d, Access::ReadWrite);
  }

 private:
  [[nodiscard]] bool wanted() const override {
    return plan_.mapsImportance() && !plan_.sharesByUtility();
  }

  [[nodiscard]] gl::ProgramKey program() const override { return {{"oit/reserve.comp"}, {}, {}}; }
};

class HistogramPass final : public OitComputePass {
 public:
  using OitComputePass::OitComputePass;
  [[nodiscard]] std::string_view name() const override { return "oit.histogram"; }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    d.texture(TEX_INPUT0, kFragmentCount);
    d.storage(SSBO_STRIP_SUMS, kCountBins, Access::ReadWrite);
    d.bytes(kCountBins, COUNT_BINS * sizeof(std::uint32_t));
  }

 private:
  [[nodiscard]] bool wanted() const override {
    return plan_.method->runs(name()) && !plan_.sharesByUtility();
  }

  [[nodiscard]] gl::ProgramKey program() const override { return {{"oit/histogram.comp"}, {}, {}}; }
};

class OneKPass final : public OitComputePass {
 public:
  using OitComputePass::OitComputePass;
  [[nodiscard]] std::string_view name() const override { return "oit.oneK"; }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    d.storage(SSBO_STRIP_SUMS, kCountBins, Access::Read);
    totalsRow(d, Access::ReadWrite);
  }

 private:
  [[nodiscard]] bool wanted() const override {
    return plan_.method->runs(name()) && !plan_.sharesByUtility();
  }

  [[nodiscard]] gl::ProgramKey program() const override { return {{"oit/one_k.comp"}, {}, {}}; }

  void dispatch(const frame::PassContext& context) override { context.dispatch({1, 1}, {1, 1}); }
};

/// Gives each pixel its range of slots.
class AllocatePass final : public OitComputePass {
 public:
  using OitComputePass::OitComputePass;
  [[nodiscard]] std::string_view name() const override { return "oit.allocate"; }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    d.texture(TEX_INPUT0, kFragmentCount);
    if (plan_.mapsImportance()) d.image(IMG_2, kImportance, Access::Read);
    slotRangeRows(d, plan_);
    totalsRow(d, Access::ReadWrite);
  }

 private:
  [[nodiscard]] bool wanted() const override {
    return plan_.method->hasRanges() && !plan_.sharesByUtility();
  }

  [[nodiscard]] gl::ProgramKey program() const override {
    gl::Defines defines = slotRangeDefines(plan_);
    defines.emplace_back(plan_.method->allocation.define, "1");
    return {{"oit/allocate.comp"}, defines, {}};
  }
};

}  // namespace

OitPassPtr makeReservePass(const OitPlan& plan) {
  return std::make_unique<ReservePass>(plan);
}

OitPassPtr makeHistogramPass(const OitPlan& plan) {
  return std::make_unique<HistogramPass>(plan);
}

OitPassPtr makeOneKPass(const OitPlan& plan) {
  return std::make_unique<OneKPass>(plan);
}

OitPassPtr makeAllocatePass(const OitPlan& plan) {
  return std::make_unique<AllocatePass>(plan);
}

}  // namespace macula::passes
