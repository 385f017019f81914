// Budgets, the method table and the predicates of the plan, by hand.
#include "passes/oit/plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/core/error.h"
#include "oit_combinations.h"
#include "passes/frame_list.h"
#include "passes/oit/slots.h"

namespace macula::passes {
namespace {

const OrderedCheck kOrdered{.allowed = true, .passed = true, .reason = ""};

void planOn(OitPlan& plan, const OitSettings& settings, std::uint64_t samples,
            const gl::Capabilities& device) {
  planMethod(plan,
             {.settings = settings, .device = device, .ordered = kOrdered, .samples = samples});
}

OitPlan planned(const OitSettings& settings, std::uint64_t samples,
                const gl::Capabilities& device = {}) {
  OitPlan plan;
  planOn(plan, settings, samples, device);
  return plan;
}

TEST(Budget, ByAverageIsEquationTwo) {
  const OitPlan plan = planned({.kAve = 2.5}, 101);
  EXPECT_EQ(plan.slots, 252U) << "floor(2.5 * 101)";
  EXPECT_EQ(plan.budgetBytes, 252U * 16U);
}

TEST(Budget, ByBytesWinsAndKeepsThem) {
  const OitPlan plan = planned({.kAve = 4.0, .memoryMiB = 1.5}, 1000000);
  EXPECT_EQ(plan.budgetBytes, 1572864U);
  EXPECT_EQ(plan.slots, 98304U);
}

TEST(Budget, TooSmallOrTooLargeIsRefused) {
  EXPECT_THROW(planned({.kAve = 0.5}, 1), InputError);
  EXPECT_THROW(planned({.memoryMiB = 1e-6}, 100), InputError);
  EXPECT_THROW(planned({.kAve = 4096.0}, 16384ULL * 16384ULL), InputError);
}

TEST(Budget, OfSmallFragmentsHoldsAsManyInHalfTheBytes) {
  const OitPlan byAverage = planned({.kAve = 2.5, .fragmentBytes = 8}, 101);
  EXPECT_EQ(byAverage.slots, 252U) << "floor(2.5 * 101), whatever their size";
  EXPECT_EQ(byAverage.budgetBytes, 252U * 8U);
  const OitPlan byBytes = planned({.memoryMiB = 1.5, .fragmentBytes = 8}, 1000000);
  EXPECT_EQ(byBytes.budgetBytes, 1572864U);
  EXPECT_EQ(byBytes.slots, 196608U);
}

TEST(Budget, OfOneKForAllIsCutIntoEqualLayers) {
  const OitPlan fixed = planned({.method = "kb-fixed", .kAve = 2.5}, 100);
  EXPECT_EQ(fixed.layers, 2U) << "floor(2.5)";
  EXPECT_EQ(fixed.slots, 200U);
  EXPECT_EQ(fixed.budgetBytes, 250U * 16U) << "what was granted, not what is used";
  const OitPlan inBytes = planned({.method = "kb-fixed", .memoryMiB = 1.0}, 10000);
  EXPECT_EQ(inBytes.layers, 6U) << "1048576 / 10000 = 104.86 bytes, 16 each";
  const OitPlan packed =
      planned({.method = "kb-fixed", .memoryMiB = 1.0, .fragmentBytes = 8}, 10000);
  EXPECT_EQ(packed.layers, 13U);
  EXPECT_THROW(planned({.method = "kb-fixed", .kAve = 0.9}, 1000), InputError);
}

TEST(Budget, ChargesATailBesideTheSlots) {
  const OitPlan bare = planned({.method = "kb-atomic", .kAve = 4.0}, 100);
  EXPECT_EQ(bare.layers, 4U);
  const OitPlan dense = planned({.method = "kb-atomic", .kAve = 4.0, .tail = Tail::Mean}, 100);
  EXPECT_TRUE(dense.denseTail());
  EXPECT_EQ(dense.layers, 3U) << "16 of the 64 bytes are the tail's sums";
  const OitPlan own = planned({.method = "kb-fixed", .kAve = 4.0, .tail = Tail::Mean}, 100);
  EXPECT_FALSE(own.denseTail());
  EXPECT_EQ(own.layers, 4U) << "the tail is one of them";
}

TEST(Budget, TooSmallForItsTailIsRefused) {
  EXPECT_THROW(planned({.method = "kb-atomic", .kAve = 1.5, .tail = Tail::Mean}, 100), InputError);
  // The sums of a tail take two slots of 8 bytes, so that one slot cannot hold them.
  EXPECT_THROW(
      planned({.method = "kb-fixed", .kAve = 1.0, .tail = Tail::Mean, .fragmentBytes = 8}, 100),
      InputError);
  EXPECT_EQ(
      planned({.method = "kb-fixed", .kAve = 2.0, .tail = Tail::Mean, .fragmentBytes = 8}, 100)
          .layers,
      2U);
}

TEST(Methods, UnknownOnesNameTheNearest) {
  try {
    (void)methodById("kb-varable");
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("did you mean 'kb-variable'?"));
  }
}

TEST(Methods, OneTakesImportanceFromANetwork) {
  for (const Method& method : methods()) {
    EXPECT_EQ(method.learnsImportance(), method.id == "kb-learned") << method.id;
  }
}

bool implies(bool a, bool b) {
  return !a || b;
}

TEST(Methods, FactsImplyWhatTheirCommentsSay) {
  for (const Method& method : methods()) {
    SCOPED_TRACE(method.id);
    const Allocation& a = method.allocation;
    const Insertion& i = method.insertion;
    EXPECT_TRUE(implies(a.shared, a.counts && a.budget));
    EXPECT_TRUE(implies(a.importance, a.shared));
    EXPECT_TRUE(implies(a.learned, a.importance));
    EXPECT_TRUE(implies(a.adjusts, a.budget));
    EXPECT_FALSE(a.constant && (a.counts || a.grows));
    EXPECT_EQ(a.planSlots != nullptr, method.stores());
    EXPECT_EQ(a.define != nullptr, method.counts());
    EXPECT_TRUE(implies(i.sorts, i.fills));
    EXPECT_TRUE(implies(i.fills || i.links || i.keysFirst, i.captured));
    EXPECT_TRUE(implies(i.captured, method.stores()));
    EXPECT_TRUE(implies(!i.noTail.empty(), !i.sorts && !i.keysFirst));
    EXPECT_TRUE(implies(method.racy, method.sorts()));
    EXPECT_TRUE(implies(method.exact, method.grows() && i.provesAll));
  }
}

TEST(Methods, NamePassesOfTheFrame) {
  const RenderSettings settings;
  const OitPlan plan{.method = &methodById("blend")};
  const LodPlan lod;
  std::vector<std::string> known;
  for (const frame::PassReport& row : makeFrameList(settings, plan, lod).report(inputsOf({}))) {
    known.emplace_back(row.name);
  }
  int named = 0;
  for (const Method& method : methods()) {
    for (const PassNames& names : {method.allocation.passes, method.insertion.passes}) {
      for (const std::string_view name : names) {
        if (name.empty()) continue;
        EXPECT_THAT(known, testing::Contains(std::string(name))) << method.id;
        EXPECT_TRUE(method.runs(name));
        ++named;
      }
    }
    EXPECT_FALSE(method.runs("oit.resolve")) << "which many methods run";
  }
  EXPECT_GE(named, 8)
      << "blend, wboit, peel, kb-stencil, kb-atomic and kb-plus have passes of their own";
}

/// The predicates around networks.
struct Needs {
  bool usesNetwork, learnsUtility, gathersColors, mapsImportance, keepsFrontNormal, slices,
      findsRange, sharesByUtility;
  bool operator==(const Needs&) const = default;
};

Needs needsOf(const OitSettings& settings) {
  OitPlan plan;
  plan.method = &methodById(settings.method);
  plan.options = settings;
  return {plan.usesNetwork(),    plan.learnsUtility(),    plan.gathersColors(),
          plan.mapsImportance(), plan.keepsFrontNormal(), plan.slices(),
          plan.findsRange(),     plan.sharesByUtility()};
}

TEST(Plan, KnowsWhatANetworkNeeds) {
  const OitSettings learned{.fill = true, .tail = Tail::Mean, .importance = Predictor::Learned};
  //                       uses  utility colours maps front  slices range  shares
  EXPECT_EQ(needsOf({}), (Needs{false, false, false, true, true, false, false, false}));
  EXPECT_EQ(needsOf({.cull = Cull::Occupancy}),
            (Needs{false, false, false, true, true, false, true, false}));
  EXPECT_EQ(needsOf({.importance = Predictor::Error}),
            (Needs{false, false, false, false, false, true, true, true}));
  EXPECT_EQ(needsOf(learned), (Needs{true, true, false, false, false, true, true, true}));
  EXPECT_EQ(needsOf({.method = "kb-learned"}),
            (Needs{true, false, true, true, false, false, true, false}));
  EXPECT_EQ(needsOf({.method = "kb-learned", .fill = true}),
            (Needs{true, false, true, true, false, false, true, true}));
  for (const Method& method : methods()) {
    if (method.followsImportance()) continue;
    const Needs needs = needsOf({.method = std::string(method.id)});
    EXPECT_EQ(needs, (Needs{false, false, false, false, false, false, false, false})) << method.id;
  }
  OitPlan plan;
  plan.method = &methodById("kb-learned");
  EXPECT_EQ(plan.networkModel(), NetworkModel::Thesis);
  plan.method = &methodById("kb-variable");
  plan.options = learned;
  EXPECT_EQ(plan.networkModel(), NetworkModel::Learned);
}

/// Every implication that the comments of OitPlan state.
void expectImplications(const OitPlan& p) {
  const Method& m = *p.method;
  EXPECT_TRUE(implies(p.reduced(), p.resizable));
  EXPECT_TRUE(implies(p.usesLocks(), p.sorted()));
  EXPECT_TRUE(implies(p.packed(), p.sorted()));
  EXPECT_TRUE(implies(p.hasTail(), m.hasBudget()));
  EXPECT_EQ(p.hasTail(), p.tailInSlot() != p.denseTail());
  EXPECT_FALSE(p.tailInSlot() && p.denseTail());
  EXPECT_TRUE(implies(p.tailInSlot(), p.sorted()));
  EXPECT_TRUE(implies(p.denseTail(), m.insertion.keysFirst));
  EXPECT_TRUE(implies(p.dynamicTail(), p.tailInSlot()));
  EXPECT_TRUE(implies(p.emptiesTails(), p.tailInSlot() && m.hasRanges()));
  EXPECT_TRUE(implies(p.predictsCounts(), p.mapsImportance() && p.sharesByUtility()));
  EXPECT_FALSE(p.predictsCounts() && (p.culls() || p.packed() || p.usesNetwork()));
  EXPECT_TRUE(implies(p.sharesByUtility(), m.sharesBudget()));
  EXPECT_TRUE(implies(p.mapsImportance(), m.followsImportance() && !p.slices()));
  EXPECT_TRUE(implies(p.keepsFrontNormal(), p.mapsImportance() && !p.usesNetwork()));
  EXPECT_TRUE(implies(p.slices(), p.sharesByUtility() && p.findsRange() && p.listsTiles()));
  EXPECT_TRUE(implies(p.usesNetwork(), p.listsTiles()));
  EXPECT_EQ(p.usesNetwork(), p.learnsUtility() != p.gathersColors());
  EXPECT_FALSE(p.learnsUtility() && p.gathersColors());
  EXPECT_TRUE(implies(p.learnsUtility(), p.slices() && p.tailInSlot()));
  EXPECT_TRUE(implies(p.gathersColors(), p.mapsImportance() && p.findsRange()));
  EXPECT_TRUE(implies(p.culls(), p.findsRange() && m.hasBudget() && !p.hasTail()));
}

TEST(Plan, PredicatesImplyWhatTheirCommentsSay) {
  int plans = 0;
  for (const OitSettings& settings : test::acceptedSettings()) {
    for (const SyncMode sync : test::syncModesOf(methodById(settings.method))) {
      SCOPED_TRACE(test::combinationName(settings));
      OitPlan plan = test::planOf(settings, sync);
      for (const bool resizable : {false, true}) {
        plan.resizable = resizable;
        plan.size = {1, 1};
        expectImplications(plan);
        ++plans;
      }
    }
  }
  EXPECT_GT(plans, 400) << "the enumeration finds something";
  RecordProperty("plans", plans);
}

TEST(Plan, OfAGrowingPoolKeepsItWhileItsMethodDoes) {
  const gl::Capabilities device;
  const OitSettings lists{.method = "ab-list"};
  OitPlan plan;
  planOn(plan, lists, 100, device);
  EXPECT_EQ(plan.slots, 200U) << "two a sample to begin with";
  EXPECT_FALSE(needsLargerPool(plan, 200));
  ASSERT_TRUE(needsLargerPool(plan, 800));
  growPool(plan, 800);
  EXPECT_EQ(plan.slots, 900U) << "an eighth to spare";
  planOn(plan, lists, 50, device);
  EXPECT_EQ(plan.slots, 900U);
  planOn(plan, {.method = "kb-variable", .kAve = 3.0}, 50, device);
  EXPECT_EQ(plan.slots, 150U);
  EXPECT_FALSE(needsLargerPool(plan, 800)) << "a budget";
  planOn(plan, lists, 50, device);
  EXPECT_EQ(plan.slots, 100U);
  planOn(plan, {.method = "ab-list", .memoryMiB = 0.001}, 50, device);
  EXPECT_EQ(plan.slots, 52U) << "1,048 bytes, 20 each";
  EXPECT_FALSE(needsLargerPool(plan, 800)) << "a cap";
}

TEST(Plan, OfStencilRoutingTakesSamplesThatTheDeviceHas) {
  gl::Capabilities device;
  device.routableSamples = {2, 4, 8};
  const OitSettings settings{.method = "kb-stencil", .kAve = 7.0};
  EXPECT_EQ(planned(settings, 100, device).layers, 4U);
  EXPECT_THROW(planned({.method = "kb-stencil", .kAve = 1.0}, 100, device), InputError);
}

TEST(Plan, AQualityControlLeavesAFrameFewerSlots) {
  OitPlan shared = planned({.kAve = 4.0}, 100);
  shared.size = shared.imageSize = {10, 10};
  planFrameSlots(shared, 0.5F);
  EXPECT_EQ(shared.slots, 200U);
  OitPlan fixed = planned({.method = "kb-fixed", .kAve = 4.0}, 100);
  fixed.size = fixed.imageSize = {10, 10};
  planFrameSlots(fixed, 0.5F);
  EXPECT_EQ(fixed.layers, 2U);
  planFrameSlots(fixed, 0.01F);
  EXPECT_EQ(fixed.layers, 1U) << "one for each sample is the least";
  fixed.size = {5, 5};
  planFrameSlots(fixed, 1.0F);
  EXPECT_EQ(fixed.layers, 16U) << "the same slots for a quarter of the texels";
}

TEST(Sync, AutoPrefersWhatTheDeviceDoesItself) {
  gl::Capabilities device;
  OrderedCheck ordered = kOrdered;
  EXPECT_EQ(chooseSync(SyncMode::Auto, device, ordered), SyncMode::Ordered);
  device.fragmentShaderInterlock = true;
  EXPECT_EQ(chooseSync(SyncMode::Auto, device, ordered), SyncMode::Interlock);
  device.fragmentShaderInterlock = false;
  ordered.passed = false;
  EXPECT_EQ(chooseSync(SyncMode::Auto, device, ordered), SyncMode::Spinlock);
  EXPECT_THROW((void)chooseSync(SyncMode::Ordered, device, ordered), InputError);
  EXPECT_THROW((void)chooseSync(SyncMode::Interlock, device, ordered), InputError);
  EXPECT_EQ(chooseSync(SyncMode::None, device, ordered), SyncMode::None);
}

}  // namespace
}  // namespace macula::passes
