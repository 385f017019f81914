// The controller: its controls' order, what it says, and what bad clocks and changes do to it.
#include "engine/control/controller.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/control/plant.h"

namespace macula::control {
namespace {

using ::testing::HasSubstr;

constexpr double kTargetMs = 16.0;
constexpr ControlWork kAll{.resize = true, .fovea = true, .layers = true};

ControlSettings settingsFor(double targetMs) {
  ControlSettings settings;
  settings.law = "macula";
  settings.targetMs = targetMs;
  return settings;
}

PlantCase plantCase(int frames, std::function<Load(int)> load) {
  PlantCase c;
  c.frames = frames;
  c.load = std::move(load);
  return c;
}

PlantRun run(Controller& controller, const PlantCase& c, double targetMs = kTargetMs,
             std::uint32_t seed = 1) {
  const Chooser choose = [&](const FrameTimes* newest, double resize, int frame) {
    return controller.next(newest, resize, c.load(frame).controls());
  };
  return runPlant(choose, c, targetMs, seed);
}

FrameTimes timesOf(std::uint64_t frame, double resize, double workMs, double restMs) {
  FrameTimes times;
  times.frame = frame;
  times.resize = resize;
  times.resizableMs = workMs / (resize * resize);
  times.totalMs = *times.resizableMs + restMs;
  return times;
}

TEST(Controller, IsAtRestWhereNothingIsAskedFor) {
  const ControlSettings settings;
  Controller controller(settings);
  const FrameTimes late = timesOf(0, 1.0, 100.0, 100.0);
  EXPECT_EQ(controller.next(nullptr, 1.0, kAll), ControlValues{});
  EXPECT_EQ(controller.next(&late, 1.0, kAll), ControlValues{});
  EXPECT_FALSE(controller.active());
  EXPECT_EQ(controller.notice(), "");
}

TEST(Controller, StartsAtRestAndFollowsTheFirstTime) {
  const ControlSettings settings = settingsFor(10.0);
  Controller controller(settings);
  EXPECT_EQ(controller.next(nullptr, 1.0, kAll), ControlValues{});
  EXPECT_TRUE(controller.active());
  const FrameTimes first = timesOf(0, 1.0, 20.0, 2.0);
  // As the law's own test has it by hand.
  EXPECT_NEAR(controller.next(&first, 1.0, kAll)[QualityControl::Resize], 1.599526, 1e-6);
}

TEST(Controller, AnEasyTargetLeavesAllControlsAtRest) {
  const ControlSettings settings = settingsFor(kTargetMs);
  Controller controller(settings);
  const PlantRun drawn = run(controller, plantCase(300, [](int) {
                               return Load{5.0, 3.0, 4.0, 0.5};
                             }));
  for (const PlantFrame& frame : drawn.frames) EXPECT_EQ(frame.controls, ControlValues{});
  EXPECT_EQ(controller.notice(), "");
}

/// Frames at which a control first left rest and last was away from it; -1: never.
struct Away {
  int first = -1;
  int last = -1;
};
Away awayOf(const PlantRun& drawn, QualityControl control) {
  Away away;
  for (std::size_t i = 0; i < drawn.frames.size(); ++i) {
    if (drawn.frames[i].controls[control] == 1.0) continue;
    if (away.first < 0) away.first = static_cast<int>(i);
    away.last = static_cast<int>(i);
  }
  return away;
}

TEST(Controller, ControlsComeInTheirOrderAndGoInTheOther) {
  const ControlSettings settings = settingsFor(kTargetMs);
  // At r = 4: 10 + 20 + 4 ms at first, out of reach of r and the fovea; later all is easy.
  const auto load = [](int frame) {
    return frame < 500 ? Load{160.0, 4.0, 20.0, 0.8} : Load{6.0, 2.0, 2.0, 0.8};
  };
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    Controller controller(settings);
    const PlantRun drawn = run(controller, plantCase(1000, load), kTargetMs, seed);
    const Away resize = awayOf(drawn, QualityControl::Resize);
    const Away fovea = awayOf(drawn, QualityControl::FoveaSlope);
    const Away layers = awayOf(drawn, QualityControl::LayerShare);
    EXPECT_LT(resize.first, fovea.first);
    EXPECT_LT(fovea.first, layers.first);
    EXPECT_LT(layers.last, fovea.last);
    EXPECT_LT(fovea.last, resize.last);
    EXPECT_LT(resize.last, 999);
    EXPECT_GT(layers.first, 0);
    EXPECT_EQ(controller.notice(), "");
    // While another control is away from rest, r stays at its end.
    for (int i = fovea.first; i < fovea.last; ++i) {
      EXPECT_EQ(drawn.frames[static_cast<std::size_t>(i)].resize, settings.mostResize) << i;
    }
  }
}

TEST(Controller, SlowControlsHoldWhatRCannotAndDoNotSwing) {
  const ControlSettings settings = settingsFor(kTargetMs);
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    for (const int dead : {1, 3, 6}) {
      Controller controller(settings);
      PlantCase c = plantCase(900, [](int) { return Load{80.0, 4.0, 14.0, 0.0}; });
      c.deadFrames = dead;
      const PlantRun drawn = run(controller, c, kTargetMs, seed);
      int changes = 0;
      for (std::size_t i = 400; i < drawn.frames.size(); ++i) {
        EXPECT_LE(drawn.frames[i].trueMs, 1.05 * kTargetMs);
        EXPECT_GE(drawn.frames[i].trueMs, 0.75 * kTargetMs);
        changes += drawn.frames[i].controls == drawn.frames[i - 1].controls ? 0 : 1;
      }
      EXPECT_LE(changes, 1) << "seed " << seed << ", dead time " << dead;
    }
  }
}

TEST(Controller, AStepThatSavesMoreThanAQuarterIsKept) {
  ControlSettings settings = settingsFor(kTargetMs);
  settings.mostResize = 1.0;
  // 14 + 3 = 17 ms is late; one step of the slope leaves 14 / 1.5625 + 3 = 11.96.
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    Controller controller(settings);
    PlantCase c = plantCase(400, [](int) { return Load{14.0, 3.0, 0.0, 1.0}; });
    const PlantRun drawn = run(controller, c, kTargetMs, seed);
    for (std::size_t i = 50; i < drawn.frames.size(); ++i) {
      ASSERT_EQ(drawn.frames[i].controls[QualityControl::FoveaSlope], 1.25)
          << "seed " << seed << ", " << i;
    }
  }
}

TEST(Controller, ATargetOutOfReachIsSaidAndRecoveredFrom) {
  const ControlSettings settings = settingsFor(kTargetMs);
  Controller controller(settings);
  PlantCase c = plantCase(500, [](int) { return Load{40.0, 25.0, 8.0, 0.0}; });
  run(controller, c);
  EXPECT_THAT(controller.notice(), HasSubstr("the target of 16 ms is out of reach: 29"));
  EXPECT_EQ(controller.controls()[QualityControl::LayerShare], 0.25);
  EXPECT_EQ(controller.controls()[QualityControl::Resize], settings.mostResize);
  // Times go on; the plant counts from 0 again, so they are given by hand.
  double resize = settings.mostResize;
  for (std::uint64_t frame = 500; frame < 800; ++frame) {
    const FrameTimes times = timesOf(frame - 1, resize, 20.0, 2.0);
    resize = controller.next(&times, resize, kAll)[QualityControl::Resize];
  }
  EXPECT_EQ(controller.controls()[QualityControl::LayerShare], 1.0);
  EXPECT_NEAR(20.0 / (resize * resize) + 2.0, kTargetMs, 0.2);
  EXPECT_EQ(controller.notice(), "");
}

TEST(Controller, ATimeOutOfReachIsSaidAnewOnceItHasMoved) {
  const ControlSettings settings = settingsFor(kTargetMs);
  Controller controller(settings);
  const auto load = [](int frame) { return Load{40.0, frame < 300 ? 25.0 : 45.0, 0.0, 0.0}; };
  PlantCase c = plantCase(500, load);
  c.noise = 0.0;
  run(controller, c);
  EXPECT_THAT(controller.notice(), HasSubstr("47.5 ms with every quality control at its end"));
}

TEST(Controller, WhatHasNoWorkIsLeftOut) {
  const ControlSettings settings = settingsFor(kTargetMs);
  Controller controller(settings);
  // No fovea: layers follow r at once.
  const PlantRun drawn = run(controller, plantCase(300, [](int) {
                               return Load{80.0, 4.0, 14.0, 0.0};
                             }));
  EXPECT_EQ(awayOf(drawn, QualityControl::FoveaSlope).first, -1);
  EXPECT_GT(awayOf(drawn, QualityControl::LayerShare).first, 0);
  // Nothing at 1/r, which times show: layers alone.
  Controller other(settings);
  const PlantRun plain = run(other, plantCase(300, [](int) { return Load{0.0, 4.0, 16.0, 0.0}; }));
  EXPECT_EQ(awayOf(plain, QualityControl::Resize).first, -1);
  EXPECT_GT(awayOf(plain, QualityControl::LayerShare).first, 0);
  // Not wanted: r alone, and out of reach.
  ControlSettings bare = settings;
  bare.fovea = bare.layers = false;
  Controller alone(bare);
  run(alone, plantCase(300, [](int) { return Load{80.0, 4.0, 24.0, 0.5}; }));
  EXPECT_EQ(alone.controls()[QualityControl::LayerShare], 1.0);
  EXPECT_EQ(alone.controls()[QualityControl::FoveaSlope], 1.0);
  EXPECT_THAT(alone.notice(), HasSubstr("out of reach"));
}

TEST(Controller, FoveationSwitchedOffAndOnAgain) {
  const ControlSettings settings = settingsFor(kTargetMs);
  Controller controller(settings);
  const auto load = [](int frame) {
    const bool foveated = frame < 300 || frame >= 600;
    return Load{224.0, 4.0, 0.0, foveated ? 0.8 : 0.0};
  };
  const PlantRun drawn = run(controller, plantCase(900, load));
  EXPECT_GT(drawn.frames[299].controls[QualityControl::FoveaSlope], 1.0);
  EXPECT_EQ(drawn.frames[300].controls[QualityControl::FoveaSlope], 1.0);  // at once, without work
  EXPECT_EQ(drawn.frames[599].controls[QualityControl::FoveaSlope], 1.0);
  EXPECT_GT(drawn.frames[899].controls[QualityControl::FoveaSlope], 1.0);
  EXPECT_LE(drawn.frames[899].trueMs, 1.05 * kTargetMs);
}

TEST(Controller, AHitchMovesNothingForLongerThanTheDeadTime) {
  const ControlSettings settings = settingsFor(kTargetMs);
  Controller controller(settings);
  PlantCase c = plantCase(600, [](int) { return Load{40.0, 4.0, 0.0, 0.0}; });
  c.hitchMs = 500.0;
  c.steadyFrom = 300;
  const PlantRun drawn = run(controller, c);
  int dipped = 0;
  for (std::size_t i = 300; i < drawn.frames.size(); ++i) {
    dipped += drawn.frames[i].trueMs < 0.9 * kTargetMs ? 1 : 0;
  }
  EXPECT_LE(dipped, c.deadFrames);
}

TEST(Controller, HoldsUnderZeroAndStaleTimes) {
  const ControlSettings settings = settingsFor(kTargetMs);
  for (const auto& [zero, stale] : {std::pair{0.3, 0.0}, {0.0, 0.3}, {0.2, 0.2}}) {
    Controller controller(settings);
    PlantCase c = plantCase(600, [](int) { return Load{40.0, 4.0, 0.0, 0.0}; });
    c.zeroShare = zero;
    c.staleShare = stale;
    const PlantRun drawn = run(controller, c);
    for (std::size_t i = 100; i < drawn.frames.size(); ++i) {
      EXPECT_NEAR(drawn.frames[i].trueMs / kTargetMs, 0.97, 0.06);
    }
    EXPECT_EQ(controller.notice(), "");
  }
}

TEST(Controller, AClockThatWaitsForADisplaySwitchesControlOffAndRests) {
  const ControlSettings settings = settingsFor(10.0);
  Controller controller(settings);
  PlantCase c = plantCase(600, [](int) { return Load{40.0, 4.0, 0.0, 0.0}; });
  c.refreshMs = 50.0;  // so long that every frame fits into one
  run(controller, c, 10.0);
  EXPECT_FALSE(controller.active());
  EXPECT_EQ(controller.controls(), ControlValues{});
  EXPECT_THAT(controller.notice(), HasSubstr("control is off: frame times do not follow"));
}

TEST(Controller, NoiseIsNotTakenForAClockThatDoesNotFollow) {
  const ControlSettings settings = settingsFor(kTargetMs);
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    Controller controller(settings);
    // Steps down and up make r travel; a tenth of the time is noise.
    PlantCase c = plantCase(900, [](int frame) {
      return Load{frame / 100 % 2 == 0 ? 20.0 : 60.0, 4.0, 0.0, 0.0};
    });
    c.noise = 0.1;
    run(controller, c, kTargetMs, seed);
    EXPECT_TRUE(controller.active()) << seed << ": " << controller.notice();
  }
}

TEST(Controller, AClockThatFailedAtTheStartIsSaid) {
  EXPECT_EQ(clockFault(5.0, 20.0), "");
  EXPECT_EQ(clockFault(5.0, 31.0), "");
  EXPECT_THAT(clockFault(16.7, 16.7), HasSubstr("no clock can be trusted"));
  EXPECT_NE(clockFault(0.0, 0.0), "");
  EXPECT_NE(clockFault(std::nan(""), 3.0), "");
  EXPECT_NE(clockFault(1.0, std::numeric_limits<double>::infinity()), "");
  const ControlSettings settings = settingsFor(kTargetMs);
  Controller controller(settings, clockFault(16.7, 16.7));
  const FrameTimes times = timesOf(0, 1.0, 40.0, 4.0);
  EXPECT_EQ(controller.next(&times, 1.0, kAll), ControlValues{});
  EXPECT_FALSE(controller.active());
  EXPECT_THAT(controller.notice(), HasSubstr("16.700 and 16.700 ms"));
}

TEST(Controller, ScalesWhatItKnowsWithTheWindow) {
  const ControlSettings settings = settingsFor(kTargetMs);
  Controller controller(settings);
  const PlantRun drawn = run(controller, plantCase(100, [](int) {
                               return Load{20.0, 1.0, 0.0, 0.0};
                             }));
  const double before = drawn.frames.back().resize;
  controller.resized(4.0);
  // A time of the old size comes late: it must not be taken for one of the new.
  const FrameTimes old = timesOf(99, before, 20.0, 1.0);
  const double after = controller.next(&old, before, kAll)[QualityControl::Resize];
  EXPECT_NEAR(80.0 / (after * after) + 4.0, kTargetMs, 0.06 * kTargetMs);
}

TEST(Controller, LawsThatCannotScaleForget) {
  ControlSettings settings = settingsFor(10.0);
  settings.law = "filament";
  Controller controller(settings);
  // 14 times: the law's window is full with the next one.
  for (std::uint64_t i = 0; i < 14; ++i) {
    const FrameTimes times = timesOf(i, 1.0, 20.0, 2.0);
    controller.next(&times, 1.0, kAll);
  }
  controller.resized(2.0);
  for (std::uint64_t i = 14; i < 28; ++i) {
    const FrameTimes times = timesOf(i, 1.0, 20.0, 2.0);
    EXPECT_EQ(controller.next(&times, 1.0, kAll)[QualityControl::Resize], 1.0) << i;
  }
}

TEST(Controller, AnotherSceneBeginsAtRest) {
  const ControlSettings settings = settingsFor(kTargetMs);
  Controller controller(settings);
  run(controller, plantCase(300, [](int) { return Load{80.0, 4.0, 14.0, 0.0}; }));
  EXPECT_LT(controller.controls()[QualityControl::LayerShare], 1.0);
  controller.restart();
  const FrameTimes old = timesOf(299, 4.0, 80.0, 18.0);
  EXPECT_EQ(controller.next(&old, 4.0, kAll)[QualityControl::LayerShare], 1.0);
}

TEST(Controller, SettingsTakeEffectWithTheNextFrame) {
  ControlSettings settings = settingsFor(kTargetMs);
  Controller controller(settings);
  run(controller, plantCase(100, [](int) { return Load{40.0, 4.0, 0.0, 0.0}; }));
  EXPECT_GT(controller.controls()[QualityControl::Resize], 1.5);
  settings.law = "fixed";
  settings.fixedResize = 2.1;
  settings.resizeStep = 0.25;
  EXPECT_EQ(controller.next(nullptr, 1.8, kAll)[QualityControl::Resize], 2.25);  // the next step up
  settings.law = "off";
  EXPECT_EQ(controller.next(nullptr, 2.25, kAll), ControlValues{});
  EXPECT_FALSE(controller.active());
}

TEST(Controller, AnotherLawTakesTheSlowControlsBack) {
  ControlSettings settings = settingsFor(kTargetMs);
  Controller controller(settings);
  run(controller, plantCase(300, [](int) { return Load{80.0, 4.0, 14.0, 0.0}; }));
  ASSERT_LT(controller.controls()[QualityControl::LayerShare], 1.0);
  settings.law = "yang2008";
  EXPECT_EQ(controller.next(nullptr, 4.0, kAll)[QualityControl::LayerShare], 1.0);
}

TEST(Controller, AFixedRMovesNoControlAndHasNoEndOfItsOwn) {
  ControlSettings settings = settingsFor(kTargetMs);
  settings.law = "fixed";
  settings.fixedResize = 6.0;
  settings.mostResize = 4.0;
  Controller controller(settings);
  run(controller, plantCase(200, [](int) { return Load{400.0, 40.0, 14.0, 0.5}; }));
  ControlValues expected;
  expected[QualityControl::Resize] = 6.0;
  EXPECT_EQ(controller.controls(), expected);
  EXPECT_EQ(controller.notice(), "");
}

TEST(Controller, SaysWhatHoldsTheFrameInstead) {
  const ControlSettings settings = settingsFor(20.0);
  Controller controller(settings);
  FrameTimes times = timesOf(0, 1.0, 8.0, 2.0);
  times.cpuMs = 1.0;
  times.intervalMs = 33.3;
  controller.next(&times, 1.0, kAll);
  EXPECT_THAT(controller.notice(), HasSubstr("a frame every 33.3 ms, 22.3 of it waiting"));
  times = timesOf(1, 1.0, 8.0, 2.0);
  times.cpuMs = 25.0;
  times.intervalMs = 35.0;
  EXPECT_EQ(controller.next(&times, 1.0, kAll), ControlValues{});
  EXPECT_THAT(controller.notice(), HasSubstr("the CPU needs longer than the target"));
  times = timesOf(2, 1.0, 8.0, 2.0);
  times.cpuMs = 1.0;
  times.intervalMs = 11.1;
  controller.next(&times, 1.0, kAll);
  EXPECT_EQ(controller.notice(), "");
}

TEST(Controller, WhatOverlapsIsNotAddedUp) {
  const ControlSettings settings = settingsFor(20.0);
  for (const bool overlapped : {false, true}) {
    Controller controller(settings);
    FrameTimes times = timesOf(0, 1.0, 8.0, 4.0);
    times.cpuMs = 10.0;
    times.intervalMs = 33.0;
    times.overlapped = overlapped;
    controller.next(&times, 1.0, kAll);
    EXPECT_THAT(controller.notice(), HasSubstr(overlapped ? "21.0 of it" : "11.0 of it"));
  }
}

}  // namespace
}  // namespace macula::control
