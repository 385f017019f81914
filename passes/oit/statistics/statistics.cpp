#include "passes/oit/statistics/statistics.h"

#include <algorithm>

#include "passes/oit/oit_pass.h"
#include "passes/oit/passes.h"
#include "shared/bindings.h"

namespace macula::passes {
namespace {

using frame::Access;

/// Sums over the image what became of each pixel's fragments.
class StatisticsPass final : public OitPass {
 public:
  using OitPass::OitPass;
  [[nodiscard]] std::string_view name() const override { return "report.statistics"; }

  [[nodiscard]] bool wanted() const override { return plan_.method->insertion.counted; }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    d.update(kOitStatistics);
    d.bytes(kOitStatistics, sizeof(shader::OitStatistics));
    d.step();
    d.texture(TEX_INPUT0, plan_.countsForReport() ? kReportCount : kFragmentCount);
    if (plan_.method->hasRanges()) d.texture(TEX_INPUT1, kFragmentRange);
    if (plan_.method->fills()) d.texture(TEX_INPUT2, kFragmentFill);
    d.storage(SSBO_OIT_STATISTICS, kOitStatistics, Access::ReadWrite);
  }

  void prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) override {
    gl::Defines defines;
    if (plan_.method->hasRanges()) defines.emplace_back("SLOTS_RANGES", "1");
    if (plan_.method->fills()) defines.emplace_back("FILLS", "1");
    program_ = programs.get({{"oit/statistics.comp"}, defines, {}});
  }

 private:
  void run(frame::PassContext& context) override {
    context.fill(kOitStatistics, 0);
    context.beginStep(1);
    glUseProgram(program_);
    glUniform1ui(0, plan_.hasTail() ? plan_.tailSlots() : 0U);
    dispatchTiles(context, plan_.size);
  }

  GLuint program_ = 0;
};

FragmentCounts countsOf(const OitPlan& plan, const shader::OitStatistics& s,
                        const shader::OitTotals& totals) {
  FragmentCounts counts;
  counts.generated = s.generated;
  // Lists have no slots of a pixel's own: what was taken from the pool is what is stored.
  counts.stored = plan.method->insertion.links ? std::min(totals.cursor, plan.slots) : s.stored;
  // All that is not stored counts as merged where there is a tail, but what was given up at a lock
  // never reached it.
  const std::uint64_t left = counts.generated - counts.stored;
  counts.merged =
      std::min<std::uint64_t>(s.merged, left - std::min<std::uint64_t>(left, totals.lockFailures));
  counts.lost = left - counts.merged;
  return counts;
}

/// Whether each pixel's fragments were drawn in their order, and none is missing from the counts.
bool provesOrder(const OitPlan& plan, std::uint32_t deepest, const gl::Capabilities& device) {
  const Insertion& insertion = plan.method->insertion;
  const bool sortsAll = insertion.deepestBounded == 0 || device.maxLoopIterations == 0 ||
                        deepest <= insertion.deepestBounded;
  const bool ordered = !plan.sorted() || plan.sync != SyncMode::None;
  return insertion.provesAll && sortsAll && ordered && !plan.packed() && !plan.reduced();
}

}  // namespace

OitPassPtr makeStatisticsPass(const OitPlan& plan) {
  return std::make_unique<StatisticsPass>(plan);
}

FragmentReport reportOf(const OitPlan& plan, const shader::OitStatistics& s,
                        const shader::OitTotals& totals, const gl::Capabilities& device) {
  FragmentReport report;
  const FragmentCounts counts = countsOf(plan, s, totals);
  report.fragments = counts;
  report.deepest = s.countMax;
  report.largestLayers = s.kMax;
  if (plan.tailInSlot()) report.tailSlots = std::uint64_t{s.tails} * plan.tailSlots();
  if (s.covered > 0 && plan.method->stores() && !plan.method->insertion.links) {
    report.layers =
        LayerStatistics{~s.kMinInverted, s.kMax, static_cast<double>(s.slots) / s.covered};
  }
  report.exact = counts.lost == 0 && counts.merged == 0 && provesOrder(plan, s.countMax, device);
  return report;
}

}  // namespace macula::passes
