// Budgets and the method table, by hand.
#include "passes/oit/plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/core/error.h"

namespace macula::passes {
namespace {

OitPlan planned(const OitSettings& settings, std::uint64_t samples) {
  OitPlan plan;
  plan.method = &methodById(settings.method);
  plan.options = settings;
  planBudget(plan, samples);
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
  const Method& learned = methodById("kb-learned");
  const Method& variable = methodById("kb-variable");
  EXPECT_EQ(learned.allocation, variable.allocation);
  EXPECT_EQ(learned.insertion, variable.insertion);
  EXPECT_FALSE(learned.exact);
  EXPECT_TRUE(learned.counts() && learned.hasBudget() && learned.isKBuffer());
  EXPECT_FALSE(learned.isRacy() || learned.grows());
}

/// What a plan says of networks, in the order of its functions.
struct Said {
  bool usesNetwork, learnsBids, gathersColors, mapsImportance, keepsFrontNormal, slices, findsRange,
      auctions;
  bool operator==(const Said&) const = default;
};

Said saidOf(const OitSettings& settings) {
  OitPlan plan;
  plan.method = &methodById(settings.method);
  plan.options = settings;
  return {plan.usesNetwork(),      plan.learnsBids(), plan.gathersColors(), plan.mapsImportance(),
          plan.keepsFrontNormal(), plan.slices(),     plan.findsRange(),    plan.auctions()};
}

TEST(Plan, SaysWhatANetworkNeeds) {
  const OitSettings learned{.fill = true, .tail = Tail::Mean, .importance = Predictor::Learned};
  //                       uses   bids   colours maps  front  slices range  auctions
  EXPECT_EQ(saidOf({}), (Said{false, false, false, true, true, false, false, false}));
  EXPECT_EQ(saidOf({.cull = Cull::Occupancy}),
            (Said{false, false, false, true, true, false, true, false}));
  EXPECT_EQ(saidOf({.importance = Predictor::Error}),
            (Said{false, false, false, false, false, true, true, true}));
  EXPECT_EQ(saidOf(learned), (Said{true, true, false, false, false, true, true, true}));
  EXPECT_EQ(saidOf({.method = "kb-learned"}),
            (Said{true, false, true, true, false, false, true, false}));
  EXPECT_EQ(saidOf({.method = "kb-learned", .fill = true}),
            (Said{true, false, true, true, false, false, true, true}));
  for (const Method& method : methods()) {
    if (method.allocation == Allocation::ImportanceMap) continue;
    const Said said = saidOf({.method = std::string(method.id)});
    EXPECT_EQ(said, (Said{false, false, false, false, false, false, false, false})) << method.id;
  }
  OitPlan plan;
  plan.method = &methodById("kb-learned");
  EXPECT_EQ(plan.networkModel(), NetworkModel::Thesis);
  plan.method = &methodById("kb-variable");
  plan.options = learned;
  EXPECT_EQ(plan.networkModel(), NetworkModel::Learned);
}

TEST(Sync, AutoPrefersWhatTheMachineDoesItself) {
  gl::Capabilities machine;
  OrderedCheck ordered{.allowed = true, .passed = true, .reason = ""};
  EXPECT_EQ(chooseSync(SyncMode::Auto, machine, ordered), SyncMode::Ordered);
  machine.fragmentShaderInterlock = true;
  EXPECT_EQ(chooseSync(SyncMode::Auto, machine, ordered), SyncMode::Interlock);
  machine.fragmentShaderInterlock = false;
  ordered.passed = false;
  EXPECT_EQ(chooseSync(SyncMode::Auto, machine, ordered), SyncMode::Spinlock);
  EXPECT_THROW((void)chooseSync(SyncMode::Ordered, machine, ordered), InputError);
  EXPECT_THROW((void)chooseSync(SyncMode::Interlock, machine, ordered), InputError);
  EXPECT_EQ(chooseSync(SyncMode::None, machine, ordered), SyncMode::None);
}

}  // namespace
}  // namespace macula::passes
