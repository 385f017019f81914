// The loss rule, each of its times and speeds, on streams whose outcome is worked out by hand.
#include "engine/gaze/tracker.h"

#include <gtest/gtest.h>

#include <cmath>

namespace macula::gaze {
namespace {

// A sample every 20 ms. Places differ in the sixth digit, as no two readings of an eye are equal.
constexpr double kInterval = 0.02;
constexpr double kNoise = 1e-6;
constexpr double kNear = 1e-4;

GazeSample seen(int index, double x, double y) {
  return {.timeSeconds = index * kInterval,
          .position = {x, y + kNoise * (index % 7)},
          .valid = true,
          .confidence = std::nullopt,
          .pupilMillimetres = std::nullopt};
}

GazeSample flagged(int index) {
  GazeSample sample = seen(index, 0.9, 0.9);
  sample.valid = false;
  return sample;
}

/// A tracker that saw (0.1, 0.5) at 0, 20, .. 80 ms.
PointOfInterestTracker afterFiveSamples() {
  PointOfInterestTracker tracker({.sampleInterval = kInterval});
  for (int i = 0; i < 5; ++i) tracker.observe(seen(i, 0.1, 0.5));
  return tracker;
}

void expectPoint(const PointOfInterest& point, GazeState state, double x, double y) {
  EXPECT_EQ(stateName(point.state), stateName(state));
  EXPECT_NEAR(point.position.x, x, kNear);
  EXPECT_NEAR(point.position.y, y, kNear);
}

TEST(GazeEase, FollowsTheStatedSpeeds) {
  const glm::dvec2 from{0.0, 0.25};
  const glm::dvec2 to{1.0, 0.25};
  // 2 /s over 0.8; then braking at 10 /s^2 from 2 to 0.5 /s over 0.1875 in 0.15 s; then 0.0125 at
  // 0.5 /s in 0.025 s.
  EXPECT_NEAR(easeTowards(from, to, 0.1).x, 0.2, 1e-12);
  EXPECT_NEAR(easeTowards(from, to, 0.4).x, 0.8, 1e-12);
  EXPECT_NEAR(easeTowards(from, to, 0.45).x, 0.8875, 1e-12);  // 0.2 - 2 * 0.05 + 5 * 0.05^2 left
  EXPECT_NEAR(easeTowards(from, to, 0.55).x, 0.9875, 1e-12);
  EXPECT_NEAR(easeTowards(from, to, 0.56).x, 0.9925, 1e-12);
  EXPECT_EQ(easeTowards(from, to, 0.5751), to);
  EXPECT_EQ(easeTowards(to, to, 0.1), to);
  EXPECT_EQ(easeTowards(from, to, 0.0), from);
}

TEST(GazeEase, DoesNotDependOnTheSteps) {
  glm::dvec2 point{0.1, 0.9};
  for (int i = 0; i < 40; ++i) point = easeTowards(point, {0.5, 0.5}, 0.01);
  EXPECT_NEAR(glm::distance(point, easeTowards({0.1, 0.9}, {0.5, 0.5}, 0.4)), 0.0, 1e-12);
}

TEST(GazeTracker, StartsWithNoneAtTheCentreAndBelievesTheFirstSample) {
  PointOfInterestTracker tracker({.sampleInterval = kInterval});
  const PointOfInterest before = tracker.at(0.0);
  expectPoint(before, GazeState::None, 0.5, 0.5);
  EXPECT_TRUE(std::isinf(before.ageSeconds));
  EXPECT_TRUE(std::isnan(before.raw.x));
  tracker.observe(seen(1, 0.3, 0.6));
  const PointOfInterest point = tracker.at(0.03);
  expectPoint(point, GazeState::Ok, 0.3, 0.6);
  EXPECT_NEAR(point.ageSeconds, 0.01, 1e-6);
  EXPECT_NEAR(point.raw.x, 0.3, 1e-6);
  EXPECT_EQ(point.radius, kFoveaRadius);
}

TEST(GazeTracker, FollowsSaccadesAtOnceWhileTrusted) {
  PointOfInterestTracker tracker = afterFiveSamples();
  tracker.observe(seen(5, 0.9, 0.2));
  expectPoint(tracker.at(0.1), GazeState::Ok, 0.9, 0.2);
}

TEST(GazeTracker, HoldsFor200MillisecondsThenEasesToTheCentre) {
  PointOfInterestTracker tracker = afterFiveSamples();  // last trusted at 80 ms
  for (int i = 5; i <= 14; ++i) {
    tracker.observe(flagged(i));
    const PointOfInterest point = tracker.at(i * kInterval);
    expectPoint(point, GazeState::Held, 0.1, 0.5);
    EXPECT_NEAR(point.ageSeconds, (i - 4) * kInterval, 1e-6);
  }
  // From 280 ms on: 0.4 to go; 0.2 at 2 /s, then 0.15 + 0.025 s of braking.
  tracker.observe(flagged(15));
  expectPoint(tracker.at(0.30), GazeState::Easing, 0.14, 0.5);
  for (int i = 16; i < 40; ++i) tracker.observe(flagged(i));
  EXPECT_NEAR(tracker.at(0.78).raw.x, 0.9, 1e-6);  // as recorded, although lost
  expectPoint(tracker.at(0.78), GazeState::Lost, 0.5, 0.5);
}

TEST(GazeTracker, EasingTakesTheStatedTime) {
  for (const auto& [time, state, x] :
       {std::tuple{0.380, GazeState::Easing, 0.3}, std::tuple{0.430, GazeState::Easing, 0.3875},
        std::tuple{0.554, GazeState::Easing, 0.4995}, std::tuple{0.556, GazeState::Lost, 0.5}}) {
    PointOfInterestTracker tracker = afterFiveSamples();
    for (int i = 5; i * kInterval <= time; ++i) tracker.observe(flagged(i));
    expectPoint(tracker.at(time), state, x, 0.5);
  }
}

TEST(GazeTracker, DistrustsFor100MillisecondsAfterABlinkAndThenMovesWithoutAJump) {
  PointOfInterestTracker tracker = afterFiveSamples();
  for (int i = 5; i < 10; ++i) tracker.observe(flagged(i));
  // Back at 200 ms at another place: not believed before 300 ms, although 280 ms ended the hold.
  for (int i = 10; i < 15; ++i) {
    tracker.observe(seen(i, 0.7, 0.5));
    expectPoint(tracker.at(i * kInterval + 0.019), GazeState::Held, 0.1, 0.5);
  }
  tracker.observe(seen(15, 0.7, 0.5));
  const PointOfInterest back = tracker.at(0.30);
  expectPoint(back, GazeState::Easing, 0.1, 0.5);
  EXPECT_NEAR(back.ageSeconds, 0.0, 1e-6);
  expectPoint(tracker.at(0.31), GazeState::Easing, 0.12, 0.5);
  // 0.6 to go takes 0.2 + 0.15 + 0.025 s.
  for (int i = 16; i < 35; ++i) tracker.observe(seen(i, 0.7, 0.5));
  expectPoint(tracker.at(0.68), GazeState::Ok, 0.7, 0.5);
  tracker.observe(seen(35, 0.2, 0.5));
  expectPoint(tracker.at(0.70), GazeState::Ok, 0.2, 0.5);
}

TEST(GazeTracker, BlinkWithoutEyeMovementLeavesThePointAlone) {
  PointOfInterestTracker tracker = afterFiveSamples();
  for (int i = 5; i < 10; ++i) tracker.observe(flagged(i));
  for (int i = 10; i < 30; ++i) {
    tracker.observe(seen(i, 0.1, 0.5));
    EXPECT_NEAR(tracker.at(i * kInterval).position.x, 0.1, kNear);
  }
  EXPECT_EQ(tracker.at(0.6).state, GazeState::Ok);
}

TEST(GazeTracker, ReturnWhileEasingWaitsWhereItIs) {
  PointOfInterestTracker tracker = afterFiveSamples();
  for (int i = 5; i <= 19; ++i) tracker.observe(flagged(i));
  expectPoint(tracker.at(0.38), GazeState::Easing, 0.3, 0.5);
  tracker.observe(seen(19, 0.1, 0.5));  // the time of a sample before: ignored
  tracker.observe(seen(20, 0.1, 0.5));
  // Between 380 and 400 ms it still moved: 0.2 - 2 * 0.02 + 5 * 0.02^2 = 0.162 to the centre.
  expectPoint(tracker.at(0.41), GazeState::Lost, 0.338, 0.5);
  for (int i = 21; i < 25; ++i) tracker.observe(seen(i, 0.1, 0.5));
  expectPoint(tracker.at(0.49), GazeState::Lost, 0.338, 0.5);
  tracker.observe(seen(25, 0.1, 0.5));
  expectPoint(tracker.at(0.51), GazeState::Easing, 0.318, 0.5);
}

TEST(GazeTracker, LossDuringDistrustStartsItAgain) {
  PointOfInterestTracker tracker = afterFiveSamples();
  tracker.observe(flagged(5));
  tracker.observe(seen(6, 0.7, 0.5));
  tracker.observe(flagged(7));
  for (int i = 8; i < 13; ++i) tracker.observe(seen(i, 0.7, 0.5));  // back at 160 ms
  expectPoint(tracker.at(0.255), GazeState::Held, 0.1, 0.5);
  tracker.observe(seen(13, 0.7, 0.5));  // 260 ms: believed
  EXPECT_EQ(tracker.at(0.26).state, GazeState::Easing);
}

TEST(GazeTracker, CodesInPlaceOfAPositionAreALoss) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const glm::dvec2 code : {glm::dvec2(0.0), kNoPosition, glm::dvec2(0.5, inf),
                                glm::dvec2(-1e300, 0.5), glm::dvec2(2147483647.0)}) {
    PointOfInterestTracker tracker = afterFiveSamples();
    GazeSample sample = seen(5, 0.0, 0.0);
    sample.position = code;
    tracker.observe(sample);
    const PointOfInterest point = tracker.at(0.1);
    expectPoint(point, GazeState::Held, 0.1, 0.5);
    EXPECT_TRUE(std::isnan(point.raw.x)) << code.x;
  }
}

TEST(GazeTracker, LostFromTheStartStaysAtTheCentreAndEasesToTheFirstTrustedPlace) {
  PointOfInterestTracker tracker({.sampleInterval = kInterval});
  for (int i = 0; i < 5; ++i) tracker.observe(flagged(i));
  const PointOfInterest lost = tracker.at(0.09);
  expectPoint(lost, GazeState::Lost, 0.5, 0.5);
  EXPECT_TRUE(std::isinf(lost.ageSeconds));
  for (int i = 5; i <= 10; ++i) tracker.observe(seen(i, 0.1, 0.5));
  expectPoint(tracker.at(0.21), GazeState::Easing, 0.48, 0.5);
}

TEST(GazeTracker, FrozenPlaceIsALossSinceItsFirstRepeat) {
  PointOfInterestTracker tracker = afterFiveSamples();
  GazeSample frozen = seen(5, 0.3, 0.4);
  for (int i = 5; i < 10; ++i) {  // 100 to 180 ms
    frozen.timeSeconds = i * kInterval;
    tracker.observe(frozen);
    EXPECT_EQ(tracker.at(frozen.timeSeconds).state, GazeState::Ok);
  }
  frozen.timeSeconds = 0.20;
  tracker.observe(frozen);
  const PointOfInterest point = tracker.at(0.20);
  EXPECT_EQ(point.state, GazeState::Held);
  EXPECT_NEAR(point.ageSeconds, 0.1, 1e-6);  // the place was new at 100 ms
  for (int i = 11; i < 17; ++i) {
    frozen.timeSeconds = i * kInterval;
    tracker.observe(frozen);
  }
  EXPECT_EQ(tracker.at(0.30).state, GazeState::Easing);  // 200 ms after 100 ms have passed
}

TEST(GazeTracker, TwoEqualPlacesOfASlowTrackerAreNotFrozen) {
  PointOfInterestTracker tracker({.sampleInterval = 0.1});
  GazeSample sample = seen(0, 0.3, 0.4);
  tracker.observe(sample);
  sample.timeSeconds = 0.1;
  tracker.observe(sample);
  EXPECT_EQ(tracker.at(0.1).state, GazeState::Ok);
  sample.timeSeconds = 0.2;
  tracker.observe(sample);
  EXPECT_EQ(tracker.at(0.2).state, GazeState::Held);
}

TEST(GazeTracker, FrozenPlaceIsNotBelievedWhenOnlyTheFlagReturns) {
  PointOfInterestTracker tracker = afterFiveSamples();
  GazeSample frozen = seen(5, 0.3, 0.4);
  for (int i = 5; i < 30; ++i) {
    frozen.timeSeconds = i * kInterval;
    frozen.valid = i < 6 || i > 8;  // flagged from 120 to 160 ms
    tracker.observe(frozen);
    const PointOfInterest point = tracker.at(frozen.timeSeconds);
    EXPECT_EQ(point.state == GazeState::Ok, i == 5) << i;
    EXPECT_NEAR(point.ageSeconds, (i - 5) * kInterval, 1e-6);
  }
  EXPECT_NEAR(tracker.at(0.58).ageSeconds, 0.48, 1e-6);
}

TEST(GazeTracker, SilenceOfThreeIntervalsIsALoss) {
  PointOfInterestTracker tracker = afterFiveSamples();  // the last sample at 80 ms
  EXPECT_EQ(tracker.at(0.139).state, GazeState::Ok);
  expectPoint(tracker.at(0.145), GazeState::Held, 0.1, 0.5);
  tracker.observe(seen(8, 0.7, 0.5));  // 160 ms: a return, so distrusted
  expectPoint(tracker.at(0.17), GazeState::Held, 0.1, 0.5);
}

TEST(GazeTracker, SilenceBetweenTwoFramesIsNoticed) {
  PointOfInterestTracker tracker = afterFiveSamples();
  tracker.observe(seen(8, 0.7, 0.5));  // 80 ms after the last, and no frame in between
  expectPoint(tracker.at(0.16), GazeState::Held, 0.1, 0.5);
}

TEST(GazeTracker, OneMissingSampleIsNoLoss) {
  PointOfInterestTracker tracker = afterFiveSamples();
  tracker.observe(seen(6, 0.7, 0.5));
  expectPoint(tracker.at(0.12), GazeState::Ok, 0.7, 0.5);
}

TEST(GazeTracker, SilenceLimitIsAtLeast60Milliseconds) {
  PointOfInterestTracker tracker({.sampleInterval = 0.001});
  tracker.observe(seen(0, 0.1, 0.5));
  EXPECT_EQ(tracker.at(0.059).state, GazeState::Ok);
  EXPECT_EQ(tracker.at(0.061).state, GazeState::Held);
}

TEST(GazeTracker, PlacesOffTheWindowClampToItsEdgeAndRawKeepsThem) {
  PointOfInterestTracker tracker = afterFiveSamples();
  tracker.observe(seen(5, -0.5, 1.7));
  const PointOfInterest point = tracker.at(0.1);
  expectPoint(point, GazeState::Ok, 0.0, 1.0);
  EXPECT_NEAR(point.raw.x, -0.5, 1e-6);
  EXPECT_NEAR(point.raw.y, 1.7, 1e-4);
}

TEST(GazeTracker, DuplicateAndBackwardTimesAreIgnored) {
  PointOfInterestTracker tracker = afterFiveSamples();
  GazeSample late = seen(4, 0.9, 0.9);
  tracker.observe(late);
  late.timeSeconds = 0.01;
  tracker.observe(late);
  late.timeSeconds = std::numeric_limits<double>::quiet_NaN();
  tracker.observe(late);
  expectPoint(tracker.at(0.08), GazeState::Ok, 0.1, 0.5);
}

}  // namespace
}  // namespace macula::gaze
