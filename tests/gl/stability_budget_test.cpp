// Budgets are promises: slots, ranges, and how fill shares them out.
#include <gmock/gmock.h>

#include <algorithm>
#include <queue>

#include "engine/core/error.h"
#include "oit_cases.h"
#include "slots.h"

namespace macula::test {
namespace {

using passes::OitSettings;
using passes::Tail;

constexpr glm::ivec2 kSize{61, 43};  // no multiple of a strip

class Promise : public GlTest {};

TEST_F(Promise, SlotsStayWithinTheBudgetForEveryOption) {
  const scene::Scene scene = unlit(tangle(240, 11));
  const scene::GpuScene gpu(scene, nullptr);
  int frames = 0;
  for (const double kAve : {0.02, 0.3, 1.0, 2.5, 6.0, 40.0}) {
    for (const OitSettings& oit : sortedCases(kAve)) {
      if (oit.sync != "spinlock") continue;  // per-pixel ordering changes no allocation
      const std::string what = describe(oit);
      const passes::RenderSettings settings = settingsOf(oit);
      Bench bench(scene, settings, kSize, device());
      passes::FrameResult result;
      try {
        result = bench.draw();
      } catch (const InputError& error) {
        EXPECT_EQ(oit.method, "kb-fixed") << what << ": " << error.what();
        EXPECT_LT(kAve, bench.renderer.plan().tailInSlot() ? 2.0 : 1.0) << what;
        continue;
      }
      ++frames;
      const passes::OitPlan& plan = bench.renderer.plan();
      EXPECT_LE(bench.renderer.bytes().oit, *plan.budgetBytes) << what;
      const passes::FragmentCounts& f = *result.fragments;
      EXPECT_EQ(f.generated, f.stored + f.merged + f.lost) << what;
      EXPECT_LE(f.stored, plan.slots) << what;
      EXPECT_EQ(result.exact, oit.fragmentBytes == 16 && f.stored == f.generated) << what;
      if (!plan.method->hasRanges()) continue;
      const std::vector<Given> given = givenBy(bench);
      const std::uint64_t sum = expectDisjoint(given, plan.slots, what);
      EXPECT_LE(sum, plan.slots) << what;
      if (!plan.sharesByUtility()) continue;
      EXPECT_EQ(sum, std::min<std::uint64_t>(plan.slots, f.generated)) << what;
      for (const Given& g : given) ASSERT_LE(g.slots, g.count) << what;
      if (oit.tail == Tail::Mean && oit.fragmentBytes == 16 && kAve >= 1.0) {
        EXPECT_EQ(f.lost, 0U) << "with a slot each, a tail leaves nothing out: " << what;
      }
    }
  }
  note("frames", frames);
}

TEST_F(Promise, OneSlotIsABudgetToo) {
  const scene::Scene scene = sheets({{1.0F}, {2.0F}, {3.0F}});
  for (const OitSettings& oit : sortedCases(1.0 / 12.0)) {
    if (oit.method == "kb-fixed" || oit.sync != "spinlock") continue;
    Bench bench(scene, settingsOf(oit), {4, 3}, device());
    const passes::FrameResult result = bench.draw();
    EXPECT_EQ(bench.renderer.plan().slots, 1U);
    EXPECT_EQ(result.fragments->generated, 36U);
    EXPECT_LE(result.fragments->stored, 1U) << describe(oit);
    // Where fewer slots than pixels are shared out by strips, shares are rounded down, here to
    // none.
    const std::uint64_t given = expectDisjoint(givenBy(bench), 1, describe(oit));
    EXPECT_EQ(given, bench.renderer.plan().sharesByUtility() ? 1U : 0U) << describe(oit);
    EXPECT_TRUE(allFinite(bench.linear()));
  }
}

TEST_F(Promise, MoreBudgetThanFragmentsIsExact) {
  const scene::Scene scene = tangle(60, 3);
  Bench reference(scene, linearSettings("ab-sbuffer"), kSize, device());
  reference.draw();
  for (const OitSettings& oit : sortedCases(64.0)) {
    if (oit.sync != "spinlock" || oit.fragmentBytes != 16) continue;
    // Not filled, slots follow importance alone, and a network may find none in a pixel.
    if (oit.method == "kb-learned" && !oit.fill) continue;
    Bench bench(scene, settingsOf(oit), kSize, device());
    const passes::FrameResult result = bench.draw();
    EXPECT_TRUE(result.exact) << describe(oit);
    EXPECT_EQ(countUnlike(bench.linear(), reference.linear()), 0U) << describe(oit);
  }
}

/// D'Hondt's method with caps: each slot beyond the first goes to the pixel with the highest I / k
/// for its next slot k that has a fragment to put there. @returns slots of each pixel
std::vector<std::uint32_t> dHondt(const std::vector<std::uint32_t>& importance,
                                  const std::vector<std::uint32_t>& counts, std::uint64_t slots) {
  using NextSlot = std::pair<double, std::size_t>;  // its marginal utility, its pixel
  std::priority_queue<NextSlot> next;
  std::vector<std::uint32_t> k(counts.size(), 0);
  for (std::size_t p = 0; p < counts.size(); ++p) {
    if (counts[p] == 0) continue;
    k[p] = 1;
    --slots;
    if (counts[p] > 1) next.emplace(importance[p] / 2.0, p);
  }
  for (; slots > 0 && !next.empty(); --slots) {
    const std::size_t p = next.top().second;
    next.pop();
    ++k[p];
    if (k[p] < counts[p]) next.emplace(importance[p] / (k[p] + 1.0), p);
  }
  return k;
}

/// The highest marginal utility of a slot that was not given over the lowest of one that was; a
/// pixel's first slot does not count. 1 or less where D'Hondt's method was followed exactly.
double utilityGap(const std::vector<std::uint32_t>& importance,
                  const std::vector<std::uint32_t>& counts, const std::vector<std::uint32_t>& k) {
  double refused = 0.0;
  double held = 1e30;
  for (std::size_t p = 0; p < k.size(); ++p) {
    if (k[p] < counts[p]) refused = std::max(refused, importance[p] / (k[p] + 1.0));
    if (k[p] > 1) held = std::min(held, static_cast<double>(importance[p]) / k[p]);
  }
  return refused / held;
}

TEST(FillMirror, AgreesWithACaseByHand) {
  // One slot each; then 6/2 = 3, 6/3 = 2, 3/2 and 6/4 = 1.5; the third pixel has one fragment.
  const std::vector<std::uint32_t> importance{6, 3, 9, 5};
  const std::vector<std::uint32_t> counts{4, 4, 1, 0};
  EXPECT_EQ(dHondt(importance, counts, 5), (std::vector<std::uint32_t>{3, 1, 1, 0}));
  EXPECT_EQ(dHondt(importance, counts, 7), (std::vector<std::uint32_t>{4, 2, 1, 0}));
  EXPECT_EQ(dHondt(importance, counts, 99), counts) << "caps";
  EXPECT_DOUBLE_EQ(utilityGap(importance, counts, {3, 1, 1, 0}), 1.5 / 2.0);
  EXPECT_DOUBLE_EQ(utilityGap(importance, counts, {1, 3, 1, 0}), 3.0 / 1.0) << "a bad allocation";
}

TEST_F(Promise, FillFollowsItsMirror) {
  const scene::Scene scene = unlit(tangle(900, 4));
  for (const double kAve : {1.2, 2.0, 4.0, 8.0}) {
    Bench bench(scene, settingsOf({.method = "kb-variable", .kAve = kAve, .fill = true}), {96, 80},
                device());
    bench.draw({0.3F, 0.4F});
    const std::vector<Given> given = givenBy(bench);
    const auto importance = bench.words(passes::kImportance, 1);
    std::vector<std::uint32_t> k;
    std::vector<std::uint32_t> counts;
    std::uint64_t fragments = 0;
    for (const Given& g : given) {
      k.push_back(g.slots);
      counts.push_back(g.count);
      fragments += g.count;
    }
    ASSERT_LT(bench.renderer.plan().slots, fragments) << "slots are scarce";
    const auto mirror = dHondt(importance, counts, bench.renderer.plan().slots);
    EXPECT_LE(utilityGap(importance, counts, mirror), 1.0);
    const double gap = utilityGap(importance, counts, k);
    // Two steps of the search and its margin on both sides: 0.25 octaves, 1.19, and rounding.
    EXPECT_LT(gap, 1.3) << "k " << kAve;
    std::uint64_t moved = 0;
    for (std::size_t p = 0; p < k.size(); ++p) moved += k[p] > mirror[p] ? k[p] - mirror[p] : 0U;
    note("gap of marginal utility", gap);
    note("share of slots elsewhere than in the mirror",
         static_cast<double>(moved) / bench.renderer.plan().slots);
    EXPECT_LT(moved, bench.renderer.plan().slots / 20);
  }
}

}  // namespace
}  // namespace macula::test
