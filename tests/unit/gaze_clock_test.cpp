// A device's clock: whether it is believed, its fit to the host's, resets; and the way to the
// window.
#include "engine/gaze/clock_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/gaze/clock_judge.h"
#include "engine/gaze/display_mapping.h"

namespace macula::gaze {
namespace {

constexpr double kMillisecond = 1e-3;

TEST(ClockFit, KnowsNothingBeforeTheFirstPair) {
  EXPECT_FALSE(ClockFit().toHost(1.0));
}

TEST(ClockFit, TheQuickestArrivalTellsTheOffset) {
  ClockFit fit;
  fit.add(10.00, 110.004);
  fit.add(10.02, 110.021);  // 1 ms late, the least
  fit.add(10.04, 110.049);
  EXPECT_NEAR(*fit.toHost(10.04), 110.041, 1e-9);
  EXPECT_NEAR(fit.offsetSeconds(), 100.001, 1e-9);
  EXPECT_EQ(fit.driftPpm(), 0.0);
}

/// Feeds `seconds` at 250 Hz by a device clock that runs `ppm` slower than the host's, with delays
/// of 0.2 to 5 ms, and gives the worst error of the newest sample's time after the first minute.
double worstError(ClockFit& fit, double seconds, double ppm) {
  std::mt19937 random(7);  // fixed: the same delays each run
  double worst = 0.0;
  for (int i = 0; i < static_cast<int>(seconds * 250.0); ++i) {
    const double device = i * 4.0 * kMillisecond;
    const double taken = 5000.0 + device * (1.0 + ppm * 1e-6);
    const double delay = kMillisecond * (0.2 + 4.8 * static_cast<double>(random() % 1000) / 1000.0);
    fit.add(device, taken + delay);
    if (device > 60.0) worst = std::max(worst, std::abs(*fit.toHost(device) - taken));
  }
  return worst;
}

TEST(ClockFit, FollowsADriftForAnHour) {
  // A constant offset would be off by 3600 s * 100 ppm = 360 ms at the end.
  ClockFit fit;
  EXPECT_LT(worstError(fit, 3600.0, 100.0), 0.5 * kMillisecond);
  EXPECT_NEAR(fit.driftPpm(), 100.0, 2.0);
  EXPECT_LT(fit.residualSeconds(), 0.1 * kMillisecond);
  EXPECT_EQ(fit.restarts(), 0U);
}

TEST(ClockFit, AShortRunHasNoDrift) {
  ClockFit fit;
  worstError(fit, 5.0, 100.0);
  EXPECT_EQ(fit.driftPpm(), 0.0);
}

TEST(ClockFit, StartsAgainWhenTheDeviceIsSet) {
  ClockFit fit;
  for (int i = 0; i < 100; ++i) fit.add(1000.0 + 0.01 * i, 50.0 + 0.01 * i);
  fit.add(0.0, 51.5);  // power cycle: its clock begins at 0
  EXPECT_EQ(fit.restarts(), 1U);
  EXPECT_NEAR(*fit.toHost(0.25), 51.75, 1e-9);
  fit.add(86400.0, 51.6);  // set to the time of day
  EXPECT_EQ(fit.restarts(), 2U);
  EXPECT_NEAR(*fit.toHost(86400.0), 51.6, 1e-9);
}

TEST(ClockFit, AStalledReaderIsNoNewClock) {
  ClockFit fit;
  for (int i = 0; i < 100; ++i) fit.add(0.01 * i, 50.0 + 0.01 * i);
  // The kernel keeps 63 reports; all are read together when the reader goes on.
  for (int i = 100; i < 163; ++i) fit.add(0.01 * i, 51.63);
  for (int i = 163; i < 400; ++i) fit.add(0.01 * i, 50.0 + 0.01 * i);
  EXPECT_EQ(fit.restarts(), 0U);
  EXPECT_NEAR(*fit.toHost(2.0), 52.0, 0.01);
}

TEST(ClockFit, AClockThatPausedIsFittedAgain) {
  for (const double step : {0.1, 0.5, -0.5}) {
    ClockFit fit;
    for (int i = 0; i < 3000; ++i) fit.add(0.01 * i, 50.0 + 0.01 * i);
    for (int i = 3000; i < 3300; ++i) fit.add(0.01 * i, 50.0 + 0.01 * i + step);
    EXPECT_EQ(fit.restarts(), 1U) << step;
    EXPECT_NEAR(*fit.toHost(33.0), 83.0 + step, 1e-3) << step;
    EXPECT_NEAR(fit.driftPpm(), 0.0, 1.0) << step;
  }
}

TEST(ClockFit, AStoppedClockIsNotBelieved) {
  ClockFit fit;
  for (int i = 0; i < 300; ++i) fit.add(5.0, 50.0 + 0.01 * i);
  EXPECT_GE(fit.restarts(), 2U);  // each second
  EXPECT_GT(*fit.toHost(5.0), 51.5);
}

/// The judge of a clock that is read 250 times a second, by times of the host.
template <typename Device>
ClockJudge judged(double seconds, Device&& device) {
  ClockJudge judge;
  for (int i = 0; i * 0.004 <= seconds; ++i) judge.add(device(i * 0.004), i * 0.004);
  return judge;
}

TEST(ClockJudge, BelievesAClockOnceItHasRunWithTheHost) {
  EXPECT_EQ(judged(0.4, [](double t) { return t + 1000.0; }).verdict(),
            ClockJudge::Verdict::Unknown);
  EXPECT_TRUE(judged(2.0, [](double t) { return t * 1.001 + 1000.0; }).believes());
}

TEST(ClockJudge, WholeSecondsAndOtherWrongUnitsAreNotTimestamps) {
  const auto verdict = [](auto&& device) { return judged(3.0, device).verdict(); };
  constexpr auto kWrong = ClockJudge::Verdict::Wrong;
  // Whole seconds in a field of microseconds, as seconds, and as microseconds rounded to seconds.
  EXPECT_EQ(verdict([](double t) { return std::floor(t) * 1e-6; }), kWrong);
  EXPECT_EQ(verdict([](double t) { return std::floor(t); }), kWrong);
  EXPECT_EQ(verdict([](double t) { return t * 1e-3; }), kWrong);
  EXPECT_EQ(verdict([](double t) { return 10.0 - t; }), kWrong);
  EXPECT_EQ(verdict([](double) { return 5.0; }), kWrong);
  // Every second sample repeats the time of the one before: it does not tell samples apart.
  EXPECT_EQ(verdict([](double t) { return std::floor(t / 0.008) * 0.008; }), kWrong);
}

TEST(ClockJudge, AClockThatFailsLaterIsWithdrawn) {
  ClockJudge judge = judged(1.0, [](double t) { return t; });
  EXPECT_TRUE(judge.believes());
  for (int i = 0; i < 500; ++i) judge.add(1.0, 1.0 + i * 0.004);
  EXPECT_FALSE(judge.believes());
}

WindowPlacement placement() {
  return {.monitorOrigin = {0.0, 0.0},
          .monitorSize = {1920.0, 1080.0},
          .clientOrigin = {480.0, 270.0},
          .clientSize = {960.0, 540.0},
          .pixelsPerUnit = 1.0};
}

TEST(DisplayMapping, AWindowAwayFromTheOrigin) {
  EXPECT_EQ(displayToWindow({0.5, 0.5}, placement()), glm::dvec2(0.5));
  EXPECT_EQ(displayToWindow({0.25, 0.25}, placement()), glm::dvec2(0.0));
  // 1,440 of 1,920 across is the right edge; 135 down is 135 above the window.
  EXPECT_EQ(displayToWindow({0.75, 0.125}, placement()), glm::dvec2(1.0, -0.25));
}

TEST(DisplayMapping, ASecondMonitorLeftOfTheFirst) {
  WindowPlacement left = placement();
  left.monitorOrigin = {-1280.0, 56.0};
  left.monitorSize = {1280.0, 1024.0};
  left.clientOrigin = {-1280.0 + 320.0, 56.0 + 256.0};
  left.clientSize = {640.0, 512.0};
  EXPECT_EQ(displayToWindow({0.5, 0.5}, left), glm::dvec2(0.5));
  EXPECT_EQ(displayToWindow({0.25, 0.75}, left), glm::dvec2(0.0, 1.0));
  // A window on the first monitor while the tracker watches the second: far to the right.
  left.clientOrigin = {0.0, 56.0};
  EXPECT_EQ(displayToWindow({0.5, 0.0}, left), glm::dvec2(-1.0, 0.0));
}

TEST(DisplayMapping, PixelsFollowTheContentScaleAwayFromTheOrigin) {
  // 3840x2160 pixels under 1920x1080 coordinates. At (0, 0) a forgotten scale would not show.
  WindowPlacement scaled = placement();
  scaled.pixelsPerUnit = 2.0;
  const glm::dvec2 share = shareOfDisplay({1920.0, 1080.0}, DeviceUnit::Pixels, scaled, {});
  EXPECT_EQ(share, glm::dvec2(0.5));
  EXPECT_EQ(displayToWindow(share, scaled), glm::dvec2(0.5));
  EXPECT_EQ(
      displayToWindow(shareOfDisplay({2880.0, 540.0}, DeviceUnit::Pixels, scaled, {}), scaled),
      glm::dvec2(1.0, 0.0));
}

TEST(DisplayMapping, MicrometresAreSharesOfTheCalibratedDisplay) {
  const glm::dvec2 size{597000.0, 336000.0};
  EXPECT_EQ(shareOfDisplay({298500.0, 84000.0}, DeviceUnit::Micrometres, placement(), size),
            glm::dvec2(0.5, 0.25));
  EXPECT_EQ(shareOfDisplay({0.3, 0.4}, DeviceUnit::Share, placement(), {}), glm::dvec2(0.3, 0.4));
}

TEST(DisplayMapping, AWindowWithoutAreaHoldsNoGaze) {
  WindowPlacement minimised = placement();
  minimised.clientSize = {0.0, 0.0};
  EXPECT_TRUE(std::isnan(displayToWindow({0.5, 0.5}, minimised).x));
}

}  // namespace
}  // namespace macula::gaze
