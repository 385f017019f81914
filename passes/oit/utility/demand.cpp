// Allocation of the budget's M slots by marginal utility, to the last slot.
//
// Each pixel p of n_p fragments has a utility U_p(k) of k slots: its importance, or the predicted
// error that they save (shaders/lib/demand.glsl). Wanted are the numbers k_p with
//   sum U_p(k_p) -> max,  sum k_p = M,  least_p <= k_p <= n_p.
// With a Lagrange multiplier L for the budget (Everett 1963; in image coding, Shoham and Gersho
// 1988) each pixel is a problem of its own, and its solution is its demand
//   k_p(L) = argmax_k U_p(k) - L k:
// it takes the slots whose marginal utility U_p(k) - U_p(k - 1) is at least L. Total demand
// D(L) = sum k_p(L) falls as L rises; the L with D(L) = M is wanted.
//   1. oit.multiplier0, oit.multiplier1: D at 16 candidates for L, in a sample of the covered
//      pixels (oit.coveredSamples), then at 16 between the two that enclose M. The sums of the
//      sample are about 1 % off, so two multipliers L+ and L- a little above and a little below
//      are used from here on (shaders/lib/multiplier.glsl).
//   2. oit.marginalDemand: k_p(L+) and k_p(L-), for utilities that are expensive, by covered tiles.
//      Other utilities are a part of the next step.
//   3. oit.demand: sums of least_p, k_p(L+), k_p(L-) and n_p over each strip of 32 pixels.
//   4. oit.prefix, oit.prefixRows: sums of all strips before each strip, and of the image; which of
//      the latter, or 0, are the two next to M, A <= M < B; and r = (M - A) / (B - A).
//   5. oit.share: with a_p, b_p the pixel's part of A and B (shaders/oit/share.comp),
//        k_p = a_p + floor(r S_p) - floor(r S_(p-1)),
//        S_p = sum over q <= p of b_q - a_q,
//      so that sum k_p = M exactly. The same sums say where each pixel's range of slots begins.
// From 3 on all is integer arithmetic: no order of threads changes a bit.
#include "passes/oit/utility/demand.h"

#include <string>

#include "passes/oit/oit_pass.h"
#include "passes/oit/passes.h"
#include "passes/oit/utility/covered.h"
#include "shared/bindings.h"
#include "shared/oit_constants.h"
#include "shared/oit_totals.h"

namespace macula::passes {
namespace {

using frame::Access;

/// Slots that each covered pixel demands at L+ and L-, 16 bits each.
constexpr frame::Resource kSlotDemand{"slot demand", GL_R32UI, frame::SizeRule::Display,
                                      frame::ByteClass::Overhead, frame::Initial::Undefined};
/// The four sums of each strip, then of each row: see shaders/lib/strips.glsl.
constexpr frame::Resource kStripSums{"strip sums", 0, frame::SizeRule::Declared,
                                     frame::ByteClass::Overhead, frame::Initial::Undefined};

/// Utility is predicted error.
bool predictsError(const OitPlan& plan) {
  return plan.slices() && plan.options.importance != Predictor::Transmittance;
}

/// Rows of shaders/lib/demand.glsl.
void demandRows(frame::PassDeclaration& d, const OitPlan& plan) {
  d.texture(TEX_INPUT0, plan.countResource());
  if (plan.mapsImportance()) d.image(IMG_2, kImportance, Access::Read);
  if (plan.learnsUtility()) d.texture(TEX_INPUT2, kNetworkOutput);
  if (plan.slices()) d.storage(SSBO_SLICES, kSliceSums, Access::Read);
  // The opaque image, at full rate even where transparency is at a reduced rate.
  if (predictsError(plan)) d.texture(TEX_INPUT1, kHdrColor);
}

/// Uniforms of shaders/lib/demand.glsl.
void setDemandUniforms(const OitPlan& plan) {
  if (!predictsError(plan)) return;
  glUniform2f(0, static_cast<float>(plan.importance.periphery),
              static_cast<float>(plan.importance.gazeWeight));
  const glm::vec2 pitch = plan.pitch();
  glUniform2f(1, pitch.x, pitch.y);
}

/// One round of the search for L.
class MultiplierRoundPass final : public OitComputePass {
 public:
  MultiplierRoundPass(const OitPlan& plan, int round)
      : OitComputePass(plan), round_(round), name_("oit.multiplier" + std::to_string(round)) {}
  [[nodiscard]] std::string_view name() const override { return name_; }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    demandRows(d, plan_);
    d.storage(SSBO_COVERED, kCoveredSamples, Access::Read);
    totalsRow(d, Access::ReadWrite);
  }

 private:
  [[nodiscard]] bool wanted() const override { return plan_.sharesByUtility(); }

  [[nodiscard]] gl::ProgramKey program() const override {
    gl::Defines defines = demandDefines(plan_);
    defines.emplace_back("ROUND", std::to_string(round_));
    return {{"oit/multiplier.comp"}, defines, {}};
  }

  void dispatch(const frame::PassContext& context) override {
    setDemandUniforms(plan_);
    context.dispatch({MULTIPLIER_THREADS, 1}, {LIST_GROUP, 1});
  }

  int round_;
  std::string name_;
};

/// Demand at L+ and L-, for utilities that are predicted from depth slices.
class MarginalDemandPass final : public OitComputePass {
 public:
  using OitComputePass::OitComputePass;
  [[nodiscard]] std::string_view name() const override { return "oit.marginalDemand"; }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    demandRows(d, plan_);
    coveredTilesRows(d);
    d.image(IMG_0, kSlotDemand, Access::Write);
  }

 private:
  [[nodiscard]] bool wanted() const override { return plan_.sharesByUtility() && plan_.slices(); }

  [[nodiscard]] gl::ProgramKey program() const override {
    gl::Defines defines = demandDefines(plan_);
    defines.push_back(listedTileDefine(plan_));
    return {{"oit/marginal_demand.comp"}, defines, {}};
  }

  void dispatch(const frame::PassContext& context) override {
    setDemandUniforms(plan_);
    dispatchCoveredTiles(context);
  }
};

/// Sums of demand over strips.
class DemandPass final : public OitComputePass {
 public:
  using OitComputePass::OitComputePass;
  [[nodiscard]] std::string_view name() const override { return "oit.demand"; }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    if (isStored()) {
      d.texture(TEX_INPUT0, plan_.countResource());
      d.image(IMG_0, kSlotDemand, Access::Read);
    } else {
      demandRows(d, plan_);
      d.image(IMG_0, kSlotDemand, Access::Write);
      totalsRow(d, Access::Read);
    }
    d.storage(SSBO_STRIP_SUMS, kStripSums, Access::Write);
    constexpr std::size_t kFourSums = 4 * sizeof(std::uint32_t);
    const auto rows = static_cast<std::size_t>(plan_.imageSize.y);
    const auto strips = static_cast<std::size_t>((plan_.imageSize.x + STRIP - 1) / STRIP);
    d.bytes(kStripSums, (rows * strips + rows) * kFourSums);
  }

 private:
  [[nodiscard]] bool wanted() const override { return plan_.sharesByUtility(); }
  /// oit.marginalDemand has found the demand.
  [[nodiscard]] bool isStored() const { return plan_.slices(); }

  [[nodiscard]] gl::ProgramKey program() const override {
    gl::Defines defines = demandDefines(plan_);
    if (isStored()) defines.emplace_back("DEMAND_STORED", "1");
    return {{"oit/demand.comp"}, defines, {}};
  }

  void dispatch(const frame::PassContext& context) override {
    if (!isStored()) setDemandUniforms(plan_);
    dispatchTiles(context, plan_.size);
  }
};

class PrefixPass final : public OitComputePass {
 public:
  /// @param rows false: the strips of each row; true: the rows, by one group
  PrefixPass(const OitPlan& plan, bool rows) : OitComputePass(plan), rows_(rows) {}
  [[nodiscard]] std::string_view name() const override {
    return rows_ ? "oit.prefixRows" : "oit.prefix";
  }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    d.storage(SSBO_STRIP_SUMS, kStripSums, Access::ReadWrite);
    if (rows_) totalsRow(d, Access::ReadWrite);
  }

 private:
  [[nodiscard]] bool wanted() const override { return plan_.sharesByUtility(); }

  [[nodiscard]] gl::ProgramKey program() const override {
    return {{rows_ ? "oit/prefix_rows.comp" : "oit/prefix.comp"}, {}, {}};
  }

  void dispatch(const frame::PassContext& context) override {
    if (rows_) {
      context.dispatch({1, 1}, {1, 1});
    } else {
      context.dispatch({1, plan_.size.y}, {1, PREFIX_ROWS});
    }
  }

  bool rows_;
};

/// Gives each pixel its part of M and its range of slots.
class SharePass final : public OitComputePass {
 public:
  using OitComputePass::OitComputePass;
  [[nodiscard]] std::string_view name() const override { return "oit.share"; }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    d.texture(TEX_INPUT0, plan_.countResource());
    d.image(IMG_2, kSlotDemand, Access::Read);
    d.storage(SSBO_STRIP_SUMS, kStripSums, Access::Read);
    totalsRow(d, Access::Read);
    slotRangeRows(d, plan_);
  }

 private:
  [[nodiscard]] bool wanted() const override { return plan_.sharesByUtility(); }

  [[nodiscard]] gl::ProgramKey program() const override {
    return {{"oit/share.comp"}, slotRangeDefines(plan_), {}};
  }
};

}  // namespace

gl::Defines sliceDefines(const OitPlan& plan) {
  return {{"SLICES", std::to_string(plan.importance.slices)},
          {"SLICE_TILE", std::to_string(plan.importance.tile)}};
}

gl::Defines demandDefines(const OitPlan& plan) {
  gl::Defines defines;
  if (plan.packed()) defines.emplace_back("PACKED", "1");
  if (plan.tailInSlot()) defines.emplace_back("TAIL_IN_SLOT", "1");
  defines.emplace_back(predictsError(plan)     ? "UTILITY_ERROR"
                       : plan.slices()         ? "UTILITY_TRANSMITTANCE"
                       : plan.mapsImportance() ? "UTILITY_IMPORTANCE"
                                               : "UTILITY_UNIFORM",
                       "1");
  if (plan.learnsUtility()) {
    defines.emplace_back("UTILITY_LEARNED", "1");
    defines.emplace_back("NETWORK_TILE", std::to_string(plan.importance.networkTile));
  }
  if (plan.slices()) {
    for (auto& define : sliceDefines(plan)) defines.push_back(define);
  }
  return defines;
}

OitPassPtr makeMultiplierRoundPass(const OitPlan& plan, int round) {
  return std::make_unique<MultiplierRoundPass>(plan, round);
}

OitPassPtr makeMarginalDemandPass(const OitPlan& plan) {
  return std::make_unique<MarginalDemandPass>(plan);
}

OitPassPtr makeDemandPass(const OitPlan& plan) {
  return std::make_unique<DemandPass>(plan);
}

OitPassPtr makePrefixPass(const OitPlan& plan, bool rows) {
  return std::make_unique<PrefixPass>(plan, rows);
}

OitPassPtr makeSharePass(const OitPlan& plan) {
  return std::make_unique<SharePass>(plan);
}

}  // namespace macula::passes
