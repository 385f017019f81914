// Control laws: their estimates and single steps by hand, and what they must never do.
#include "engine/control/law.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/control/work_estimate.h"
#include "engine/core/error.h"

namespace macula::control {
namespace {

using Outcome = WorkEstimate::Outcome;

TEST(WorkEstimate, MovesATenthOfTheWayThroughNoise) {
  WorkEstimate estimate;
  EXPECT_EQ(estimate.observe(20.0), Outcome::First);
  EXPECT_EQ(estimate.observe(20.4), Outcome::Followed);
  EXPECT_NEAR(estimate.level(), 20.04, 1e-12);
}

TEST(WorkEstimate, OneOutlierChangesNothingTwoAreAStep) {
  WorkEstimate estimate;
  estimate.observe(20.0);
  EXPECT_EQ(estimate.observe(40.0), Outcome::Outlier);
  EXPECT_EQ(estimate.level(), 20.0);
  EXPECT_EQ(estimate.observe(20.0), Outcome::Followed);
  EXPECT_EQ(estimate.observe(40.0), Outcome::Outlier);
  EXPECT_EQ(estimate.observe(41.0), Outcome::Stepped);
  EXPECT_NEAR(estimate.level(), 40.5, 1e-12);
}

TEST(WorkEstimate, OutliersThatDisagreeAreNoStep) {
  WorkEstimate estimate;
  estimate.observe(20.0);
  EXPECT_EQ(estimate.observe(40.0), Outcome::Outlier);
  EXPECT_EQ(estimate.observe(10.0), Outcome::Outlier);
  EXPECT_EQ(estimate.observe(400.0), Outcome::Outlier);
  EXPECT_EQ(estimate.level(), 20.0);
}

TEST(WorkEstimate, ADriftIsFollowedQuickly) {
  WorkEstimate estimate;
  double value = 20.0;
  for (int i = 0; i < 100; ++i) estimate.observe(value *= 1.01);
  EXPECT_NEAR(estimate.level() / value, 1.0, 0.015);
}

FrameTimes timesOf(std::uint64_t frame, double resize, double workMs, double fixedMs) {
  FrameTimes times;
  times.frame = frame;
  times.resize = resize;
  times.resizableMs = workMs / (resize * resize);
  times.totalMs = *times.resizableMs + fixedMs;
  return times;
}

LawOptions target(double ms) {
  LawOptions options;
  options.targetMs = ms;
  return options;
}

TEST(MaculaLaw, InvertsTheModelFromTheFirstTime) {
  // Spread 1.5 % at first: the aim is 10 * 1.02 / (1 + 2.6 * 0.015) = 9.817132; for the work
  // 7.817132, so r = sqrt(20 / 7.817132) = 1.599526.
  const auto law = makeLaw("macula", target(10.0));
  const FrameTimes times = timesOf(0, 1.0, 20.0, 2.0);
  EXPECT_EQ(law->next(nullptr, 1.0), 1.0);
  EXPECT_NEAR(law->next(&times, 1.0), 1.599526, 1e-6);
}

TEST(MaculaLaw, PairsATimeWithTheResizeOfItsFrame) {
  const auto law = makeLaw("macula", target(10.0));
  FrameTimes times = timesOf(0, 2.0, 20.0, 2.0);
  // Drawn at r = 2 while r is 3 by now: the same model, the same answer.
  EXPECT_NEAR(law->next(&times, 1.0), 1.599526, 1e-6);
}

TEST(MaculaLaw, ComesBackSlowlyAndStaysInItsDeadBand) {
  const auto law = makeLaw("macula", target(10.0));
  FrameTimes times = timesOf(0, 4.0, 20.0, 2.0);
  EXPECT_NEAR(law->next(&times, 4.0), 4.0 / std::sqrt(1.08), 1e-9);
  EXPECT_EQ(law->next(nullptr, 1.602), 1.602);
}

TEST(MaculaLaw, ComesDownInStepsThatAreCoarserThanItsGrowth) {
  for (const double step : {1.0 / 16.0, 0.1, 0.25, 1.0}) {
    LawOptions options = target(10.0);
    options.resizeStep = step;
    const auto law = makeLaw("macula", options);
    double resize = inSteps(1.9, step);
    for (std::uint64_t i = 0; i < 100; ++i) {
      resize = static_cast<double>(static_cast<float>(resize));  // as a renderer keeps it
      const FrameTimes times = timesOf(i, resize, 20.0, 2.0);
      const double next = law->next(&times, resize);
      EXPECT_GE(next, resize - step - 1e-6);
      resize = next;
    }
    // sqrt(20 / 8) = 1.5811 in calm times, and the next step up.
    EXPECT_NEAR(resize, inSteps(1.583, step), 1e-6) << step;
  }
}

TEST(InSteps, TheNextOneUpAndAFloatIsNoStepMore) {
  EXPECT_EQ(inSteps(1.3, 0.0), 1.3);
  EXPECT_EQ(inSteps(1.3, 0.25), 1.5);
  EXPECT_EQ(inSteps(1.5, 0.25), 1.5);
  EXPECT_NEAR(inSteps(static_cast<double>(1.1F), 0.1), 1.1, 1e-12);  // 1.1F is 1.10000002
}

/// Draws 200 frames of a load under a law, with times that `spoil` may change; gives the last r.
template <typename Spoil>
double settled(Law& law, double workMs, double fixedMs, Spoil spoil) {
  double resize = 1.0;
  FrameTimes times;
  for (std::uint64_t i = 0; i < 200; ++i) {
    resize = law.next(i == 0 ? nullptr : &times, resize);
    EXPECT_GE(resize, kLeastResize);
    EXPECT_LE(resize, kMostResize);
    times = timesOf(i, resize, workMs, fixedMs);
    spoil(i, times);
  }
  return resize;
}

TEST(MaculaLaw, HoldsUnderBadTimes) {
  const auto nothing = [](std::uint64_t, FrameTimes&) {};
  const double good = settled(*makeLaw("macula", target(10.0)), 20.0, 2.0, nothing);
  EXPECT_NEAR(20.0 / (good * good) + 2.0, 10.0, 0.1);
  const auto zero = [](std::uint64_t i, FrameTimes& times) {
    if (i % 3 == 0) times.totalMs = 0.0;
  };
  EXPECT_NEAR(settled(*makeLaw("macula", target(10.0)), 20.0, 2.0, zero), good, 0.02);
  const auto hitch = [](std::uint64_t i, FrameTimes& times) {
    if (i == 150) times.totalMs += 500.0;
  };
  EXPECT_NEAR(settled(*makeLaw("macula", target(10.0)), 20.0, 2.0, hitch), good, 0.02);
  const auto nan = [](std::uint64_t i, FrameTimes& times) {
    if (i % 7 == 0) times.totalMs = std::nan("");
  };
  EXPECT_NEAR(settled(*makeLaw("macula", target(10.0)), 20.0, 2.0, nan), good, 0.02);
}

TEST(MaculaLaw, SaysWhenTheTargetIsOutOfReachAndRecovers) {
  const auto law = makeLaw("macula", target(10.0));
  const auto nothing = [](std::uint64_t, FrameTimes&) {};
  EXPECT_EQ(settled(*law, 20.0, 12.0, nothing), kMostResize);
  EXPECT_NE(law->notice().find("out of reach"), std::string::npos);
  double resize = kMostResize;
  for (std::uint64_t i = 200; i < 300; ++i) {
    const FrameTimes times = timesOf(i, resize, 20.0, 2.0);
    resize = law->next(&times, resize);
  }
  EXPECT_NEAR(20.0 / (resize * resize) + 2.0, 10.0, 0.2);
  EXPECT_EQ(law->notice(), "");
}

TEST(MaculaLaw, AnEasyTargetLeavesFullResolution) {
  const auto nothing = [](std::uint64_t, FrameTimes&) {};
  EXPECT_EQ(settled(*makeLaw("macula", target(100.0)), 20.0, 2.0, nothing), 1.0);
}

TEST(MaculaLaw, SwitchesOffWhereTheClockDoesNotFollow) {
  const auto law = makeLaw("macula", target(10.0));
  const auto vsync = [](std::uint64_t, FrameTimes& times) {
    times.totalMs = 1000.0 / 60.0;  // whatever was drawn
    times.resizableMs.reset();
  };
  settled(*law, 20.0, 2.0, vsync);
  EXPECT_NE(law->notice().find("control is off"), std::string::npos) << law->notice();
}

TEST(MaculaLaw, ReconstructionSwitchedOnIsNoClockThatDoesNotFollow) {
  const auto law = makeLaw("macula", target(10.0));
  // From r = 1 to 1.1 the work falls by 17 %, and reconstruction costs as much.
  for (std::uint64_t i = 0; i < 200; ++i) {
    const double resize = i % 2 == 0 ? 1.0 : 1.1;
    FrameTimes times = timesOf(i, resize, 20.0, 2.0);
    if (i % 2 == 1) times.totalMs = 22.0;
    static_cast<void>(law->next(&times, resize));
    ASSERT_EQ(law->trouble(), Trouble::None) << i;
  }
}

TEST(MaculaLaw, ACpuBoundFrameKeepsItsResolution) {
  const auto law = makeLaw("macula", target(10.0));
  const auto cpu = [](std::uint64_t, FrameTimes& times) {
    times.cpuMs = 25.0;
    times.intervalMs = 25.0;
  };
  EXPECT_EQ(settled(*law, 5.0, 2.0, cpu), 1.0);
  EXPECT_NE(law->notice().find("CPU"), std::string::npos);
}

TEST(MaculaLaw, SaysWhenNoTimesCome) {
  const auto law = makeLaw("macula", target(10.0));
  for (int i = 0; i < 40; ++i) EXPECT_EQ(law->next(nullptr, 1.5), 1.5);
  EXPECT_NE(law->notice().find("no frame times"), std::string::npos);
}

TEST(YangLaw, ByHand) {
  // 1/r^2 = 1 + (10 - 16) / 20 = 0.7, so r = 1.195229; and no more than 0.2 in a frame.
  LawOptions options = target(10.0);
  options.expectedWorkMs = 20.0;
  FrameTimes times = timesOf(0, 1.0, 14.0, 2.0);
  EXPECT_NEAR(makeLaw("yang2008", options)->next(&times, 1.0), 1.195229, 1e-6);
  times = timesOf(0, 1.0, 100.0, 2.0);
  EXPECT_NEAR(makeLaw("yang2008", options)->next(&times, 1.0), 1.2, 1e-12);
  times = timesOf(0, 3.0, 0.1, 0.1);
  EXPECT_NEAR(makeLaw("yang2008", options)->next(&times, 3.0), 2.8, 1e-12);
  EXPECT_EQ(makeLaw("yang2008", options)->next(&times, 1.1), 1.0);
}

TEST(IdLaw, StepsDownAtOnceAndUpAfterFiveFrames) {
  const auto law = makeLaw("id", target(10.0));
  FrameTimes times = timesOf(0, 1.0, 10.0, 2.0);
  EXPECT_NEAR(law->next(&times, 1.0), 1.0 / 0.89, 1e-12);
  times = timesOf(0, 2.0, 10.0, 2.0);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(law->next(&times, 2.0), 2.0);
  EXPECT_NEAR(law->next(&times, 2.0), 1.0 / 0.56, 1e-12);
}

TEST(FilamentLaw, ByHand) {
  // 15 times of 15 ms for 10: e = -0.5; o = -0.1175 * 0.5 - 0.002 * 0.5 = -0.05975; area / 1.05975.
  const auto law = makeLaw("filament", target(10.0));
  const FrameTimes times = timesOf(0, 1.0, 13.0, 2.0);
  for (int i = 0; i < 14; ++i) EXPECT_EQ(law->next(&times, 1.0), 1.0);
  EXPECT_NEAR(law->next(&times, 1.0), std::sqrt(1.05975), 1e-12);
}

TEST(UnrealLaw, PanicsAfterTwoFramesOverTheBudget) {
  const auto law = makeLaw("unreal", target(10.0));
  const FrameTimes times = timesOf(0, 1.0, 18.0, 2.0);
  EXPECT_EQ(law->next(&times, 1.0), 1.0);
  EXPECT_NEAR(law->next(&times, 1.0), 1.0 / std::sqrt(9.0 / 20.0), 1e-12);
}

TEST(UnityLaw, WaitsForFourWindows) {
  const auto law = makeLaw("unity", target(10.0));
  const FrameTimes times = timesOf(0, 1.0, 18.0, 2.0);
  for (int i = 0; i < 59; ++i) EXPECT_EQ(law->next(&times, 1.0), 1.0);
  EXPECT_NEAR(law->next(&times, 1.0), 1.0 / (1.0 - 0.4375), 1e-12);
}

TEST(Laws, StayBelowTheirMostResize) {
  LawOptions options = target(10.0);
  options.mostResize = 2.0;
  for (const std::string& name : lawNames()) {
    const auto law = makeLaw(name, options);
    double resize = 1.0;
    for (std::uint64_t i = 0; i < 300; ++i) {
      const FrameTimes times = timesOf(i, resize, 400.0, 20.0);
      resize = law->next(&times, resize);
      EXPECT_LE(resize, 2.0) << name;
    }
    EXPECT_EQ(resize, law->holdsTarget() ? 2.0 : 1.0) << name;
  }
}

TEST(FilamentLaw, IsNotWoundUpAtItsOwnEnd) {
  LawOptions options = target(10.0);
  options.mostResize = 2.0;
  const auto law = makeLaw("filament", options);
  for (std::uint64_t i = 0; i < 400; ++i) {
    const FrameTimes late = timesOf(i, 2.0, 0.0, 20.0);
    EXPECT_EQ(law->next(&late, 2.0), 2.0);
  }
  double resize = 2.0;
  for (std::uint64_t i = 400; i < 415; ++i) {
    const FrameTimes early = timesOf(i, 2.0, 0.0, 5.0);
    resize = law->next(&early, 2.0);
  }
  EXPECT_LT(resize, 2.0);  // 400 errors of -1, summed, would hold it for 800 frames more
}

TEST(Laws, AnUnknownNameNamesTheNearest) {
  try {
    static_cast<void>(makeLaw("yang", {}));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "control law 'yang' is unknown; the nearest is 'yang2008'");
  }
}

}  // namespace
}  // namespace macula::control
