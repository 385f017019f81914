// Budgets and the method table, by hand.
#include "passes/oit/plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/core/error.h"

namespace macula::passes {
namespace {

OitPlan planned(const OitSettings& settings, std::uint64_t samples) {
  OitPlan plan;
  plan.method = &methodById("kb-variable");
  planBudget(plan, settings, samples);
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
