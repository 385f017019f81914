#include "passes/oit/methods.h"

#include <algorithm>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/nearest.h"
#include "passes/oit/slots.h"

namespace macula::passes {
namespace {

// How a pixel gets its slots. planSlots: how many there are, see slots.h.
constexpr Allocation kNoSlots{};
constexpr Allocation kSettingLayers{.planSlots = planSettingLayers, .constant = true};
constexpr Allocation kGrowingPool{.planSlots = planGrowingPool, .grows = true};
constexpr Allocation kExactCounts{
    .planSlots = planGrowingPool, .counts = true, .grows = true, .define = "ALLOCATION_EXACT"};
constexpr Allocation kBudgetLayers{
    .planSlots = planBudgetLayers, .constant = true, .budget = true, .adjusts = true};
/// Slots are the samples of a target: a frame cannot use fewer.
constexpr Allocation kBudgetSamples{
    .planSlots = planBudgetSamples, .constant = true, .budget = true};
constexpr Allocation kOneK{.planSlots = planBudgetPool,
                           .counts = true,
                           .budget = true,
                           .shared = true,
                           .adjusts = true,
                           .passes = {"oit.histogram", "oit.oneK"},
                           .define = "ALLOCATION_ONE_K"};
constexpr Allocation kImportanceShares{.planSlots = planBudgetPool,
                                       .counts = true,
                                       .budget = true,
                                       .shared = true,
                                       .importance = true,
                                       .adjusts = true,
                                       .define = "ALLOCATION_IMPORTANCE"};
constexpr Allocation learnedImportance() {
  Allocation a = kImportanceShares;
  a.learned = true;
  return a;
}

// What happens to a fragment.
constexpr std::string_view kNothingLeftOut =
    "leaves nothing out in order, so there is no tail; use a k-buffer";
/// Heap sort and composition take n log2 n + 3 n iterations.
constexpr std::uint32_t kDeepestHeapSort = 4096;
/// The merge sort of a list takes 2 n log2 n.
constexpr std::uint32_t kDeepestMergeSort = 2048;

/// Fixed-function blending in draw order.
constexpr Insertion kBlended{.passes = {"oit.blend"}, .noTail = kNothingLeftOut, .counted = false};
/// Summed with a weight that falls off with depth.
constexpr Insertion kWeighted{
    .passes = {"oit.weighted", "oit.weightedResolve"}, .noTail = kNothingLeftOut, .counted = false};
/// The nearest that has not been drawn yet, one layer a pass.
constexpr Insertion kPeeled{.passes = {"oit.peel"}, .noTail = kNothingLeftOut};
/// Stored in any order, sorted when resolved.
constexpr Insertion kAppended{.define = "INSERTION_APPEND",
                              .captured = true,
                              .fills = true,
                              .sortedAtResolve = true,
                              .noTail = kNothingLeftOut,
                              .deepestBounded = kDeepestHeapSort};
/// The same, in a linked list.
constexpr Insertion kLinked{.define = "INSERTION_LINKED",
                            .captured = true,
                            .links = true,
                            .noTail = kNothingLeftOut,
                            .deepestBounded = kDeepestMergeSort};
/// Inserted among the k nearest, under per-pixel ordering.
constexpr Insertion kSorted{
    .define = "INSERTION_SORTED", .captured = true, .fills = true, .sorts = true};
/// Keys sorted by atomic minima first, colours to their keys then.
constexpr Insertion kAtomicMinima{
    .define = "INSERTION_ATOMIC", .captured = true, .keysFirst = true, .passes = {"oit.keys"}};
/// One multisample slot each, chosen by the stencil test. At edges a sample may be uncovered and
/// its fragment missing.
constexpr Insertion kStencilRouted{
    .define = "INSERTION_ROUTED",
    .passes = {"oit.route"},
    .noTail =
        "leaves out what is rejected by the stencil test before it has a colour; use another "
        "k-buffer",
    .provesAll = false};

constexpr std::array kMethods{
    Method{.id = "blend",
           .allocation = kNoSlots,
           .insertion = kBlended,
           .summary = "unsorted alpha blending: the floor of speed",
           .source = "Porter and Duff 1984"},
    Method{
        .id = "wboit",
        .allocation = kNoSlots,
        .insertion = kWeighted,
        .summary = "weighted blended: one pass, no order, colours by a guess of their visibility",
        .source = "McGuire and Bavoil 2013, Eq. 9"},
    Method{.id = "peel",
           .allocation = kNoSlots,
           .insertion = kPeeled,
           .summary = "depth peeling: the nearest oit.layers, a layer a pass",
           .source = "Everitt 2001"},
    Method{.id = "ab-array",
           .allocation = kSettingLayers,
           .insertion = kAppended,
           .summary = "A-buffer of oit.layers slots a pixel: the first drawn are kept",
           .source = "Tsopouridis 2021, section 3.1.1"},
    Method{.id = "ab-list",
           .allocation = kGrowingPool,
           .insertion = kLinked,
           .exact = true,
           .summary = "A-buffer of per-pixel linked lists",
           .source = "Yang et al. 2010; Tsopouridis 2021, section 3.1.2"},
    Method{.id = "ab-sbuffer",
           .allocation = kExactCounts,
           .insertion = kAppended,
           .exact = true,
           .summary = "A-buffer with exact contiguous ranges: the reference",
           .source = "Vasilakis and Fudos 2012; Tsopouridis 2021, section 3.1"},
    Method{.id = "kb-racy",
           .allocation = kBudgetLayers,
           .insertion = kSorted,
           .racy = true,
           .summary = "k-buffer without synchronisation: hazards on purpose",
           .source = "Bavoil et al. 2007"},
    Method{.id = "kb-stencil",
           .allocation = kBudgetSamples,
           .insertion = kStencilRouted,
           .summary = "the first k drawn, one multisample slot each; sorted at the resolve",
           .source = "Bavoil and Myers 2008"},
    Method{.id = "kb-atomic",
           .allocation = kBudgetLayers,
           .insertion = kAtomicMinima,
           .summary = "the k nearest: keys by atomic minima, then colours to their keys",
           .source = "Maule et al. 2013"},
    Method{.id = "kb-fixed",
           .allocation = kBudgetLayers,
           .insertion = kSorted,
           .summary = "the k nearest of each pixel, the same k everywhere",
           .source = "Salvi 2013; Tsopouridis 2021, section 3.2.1"},
    Method{.id = "kb-plus",
           .allocation = kOneK,
           .insertion = kSorted,
           .summary = "the min(n, k) nearest, one k from the histogram of counts under a budget",
           .source = "Vasilakis and Fudos 2014"},
    Method{.id = "kb-variable",
           .allocation = kImportanceShares,
           .insertion = kSorted,
           .summary = "k-buffer whose k(p) follows importance under a budget",
           .source = "Vasilakis 2017; Tsopouridis 2021, section 3.2.2"},
    Method{.id = "kb-learned",
           .allocation = learnedImportance(),
           .insertion = kSorted,
           .summary = "k-buffer whose k(p) follows importance as a network says it, under a budget",
           .source = "Tsopouridis 2021, chapter 4"},
};

}  // namespace

bool Method::runs(std::string_view pass) const {
  const auto names = [pass](const PassNames& own) {
    return std::find(own.begin(), own.end(), pass) != own.end();
  };
  return names(allocation.passes) || names(insertion.passes);
}

std::span<const Method> methods() {
  return kMethods;
}

const Method& methodById(std::string_view id) {
  std::vector<std::string> known;
  for (const Method& method : kMethods) {
    if (method.id == id) return method;
    known.emplace_back(method.id);
  }
  failInput("oit.method: there is no method '{}'; did you mean '{}'?", id, nearestName(id, known));
}

}  // namespace macula::passes
