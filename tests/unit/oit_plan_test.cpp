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
