// What a held run comes to: by hand, and against runs that must fail.
#include "engine/control/hold_measures.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace macula::control {
namespace {

/// K and C at r, beside a fixed time.
HeldFrame frameOf(double workMs, double restMs, double resize, double fixedMs = 20.0) {
  HeldFrame frame;
  frame.resize = resize;
  frame.resizableMs = workMs / (resize * resize);
  frame.ms = frame.resizableMs + restMs;
  frame.fixedMs = fixedMs;
  return frame;
}

/// 100 frames of K 24, C 4 and 100 of K 48, C 4 for T = 10: r = 2 and 2.828427.
std::vector<HeldFrame> heldFrames() {
  std::vector<HeldFrame> frames(100, frameOf(24.0, 4.0, 2.0));
  frames.insert(frames.end(), 3, frameOf(48.0, 4.0, 2.0));  // 16 ms
  frames.insert(frames.end(), 97, frameOf(48.0, 4.0, 2.828427));
  return frames;
}

TEST(HoldMeasures, ByHand) {
  const std::vector<HeldFrame> frames = heldFrames();
  const HoldMeasures m = measureHold({10.0, 4.0, frames, {100}});
  ASSERT_EQ(m.parts.size(), 2U);
  EXPECT_NEAR(m.parts[0].idealResize, 2.0, 1e-9);
  EXPECT_NEAR(m.parts[1].idealResize, 2.828427, 1e-6);
  EXPECT_NEAR(m.parts[1].workMs, 48.0, 1e-9);
  EXPECT_NEAR(m.parts[1].restMs, 4.0, 1e-9);
  EXPECT_EQ(m.parts[0].settleFrames, 0U);
  // The median of 16, 16, 10, 10, 10 is in: two late frames are outvoted.
  EXPECT_EQ(m.parts[1].settleFrames, 1U);
  EXPECT_NEAR(m.parts[1].usedPixels.value(), 1.0, 1e-6);
  EXPECT_EQ(m.fixedSpread, 0.0);
  EXPECT_DOUBLE_EQ(m.tolerance, 0.05);
  EXPECT_EQ(m.judged, 180U);
  EXPECT_EQ(m.withinTolerance, 1.0);
  EXPECT_EQ(m.over102, 0.0);
  EXPECT_EQ(m.longestOver, 3U);
  EXPECT_EQ(m.met, true);
  EXPECT_EQ(m.reversals, 0.0);
}

TEST(HoldMeasures, TheSpreadOfTheFixedRWidensTheGateAlone) {
  std::vector<HeldFrame> frames(200, frameOf(24.0, 4.0, 2.0));
  for (std::size_t i = 0; i < frames.size(); ++i) {
    frames[i].ms = i % 4 == 0 ? 10.7 : 10.0;  // a quarter lies 7 % off
    frames[i].fixedMs = i % 2 == 0 ? 20.0 : 20.8;
  }
  const HoldMeasures m = measureHold({10.0, 4.0, frames, {}});
  EXPECT_NEAR(m.fixedSpread, 0.04, 0.002);  // half of the frames are 4 % from the median
  EXPECT_NEAR(m.withinFive, 0.75, 0.01);
  EXPECT_EQ(m.withinTolerance, 1.0);
  EXPECT_EQ(m.met, true);
  for (HeldFrame& frame : frames) frame.fixedMs = 20.0;
  EXPECT_EQ(measureHold({10.0, 4.0, frames, {}}).met, false);
}

TEST(HoldMeasures, ACameraThatMovesIsNoSpread) {
  std::vector<HeldFrame> frames(200, frameOf(24.0, 4.0, 2.0));
  for (std::size_t i = 0; i < frames.size(); ++i) {
    frames[i].fixedMs = 20.0 + 0.05 * static_cast<double>(i);  // 20 to 30 ms
  }
  // The running median lags behind at the ends alone, by 7 frames of 0.25 % at the most; they are
  // more than the tenth of the frames that the spread leaves out.
  EXPECT_LT(measureHold({10.0, 4.0, frames, {}}).fixedSpread, 0.01);
}

TEST(HoldMeasures, FullRateInTimeIsHeldAndATargetOutOfReachIsNot) {
  const std::vector<HeldFrame> easy(50, frameOf(5.0, 1.0, 1.0));
  const HoldMeasures fits = measureHold({10.0, 4.0, easy, {}});
  EXPECT_EQ(fits.parts[0].idealResize, 1.0);
  EXPECT_NEAR(fits.parts[0].reachableMs, 6.0, 1e-9);
  EXPECT_EQ(fits.met, true);
  // The same time at r = 2 is not: there was room for more pixels.
  const std::vector<HeldFrame> timid(50, frameOf(20.0, 1.0, 2.0));
  EXPECT_EQ(measureHold({10.0, 4.0, timid, {}}).met, false);
  const std::vector<HeldFrame> hard(50, frameOf(16.0, 12.0, 4.0));
  const HoldMeasures fails = measureHold({10.0, 4.0, hard, {}});
  EXPECT_EQ(fails.parts[0].idealResize, 4.0);
  EXPECT_NEAR(fails.parts[0].reachableMs, 13.0, 1e-9);
  EXPECT_EQ(fails.met, false);
  EXPECT_EQ(fails.over110, 1.0);
  EXPECT_EQ(fails.parts[0].settleFrames, std::nullopt);
}

TEST(HoldMeasures, CountsReversalsOfR) {
  std::vector<HeldFrame> frames(100, frameOf(24.0, 4.0, 2.0));
  for (std::size_t i = 0; i < frames.size(); ++i) frames[i].resize = i % 2 == 0 ? 2.0 : 2.1;
  EXPECT_DOUBLE_EQ(measureHold({10.0, 4.0, frames, {}}).reversals, 98.0);
}

TEST(HoldMeasures, WhatLeavesTheTargetAgainHasNotSettled) {
  std::vector<HeldFrame> frames(60, frameOf(24.0, 4.0, 2.0));
  for (std::size_t i = 30; i < 40; ++i) frames[i].ms = 16.0;
  // The last median outside is that of 37 to 41: three of 16 and two of 10.
  EXPECT_EQ(measureHold({10.0, 4.0, frames, {}}).parts[0].settleFrames, 38U);
  for (std::size_t i = 57; i < 60; ++i) frames[i].ms = 16.0;
  EXPECT_EQ(measureHold({10.0, 4.0, frames, {}}).parts[0].settleFrames, std::nullopt);
}

TEST(HoldMeasures, SpreadBiasAndChangesByHand) {
  std::vector<HeldFrame> frames(50, frameOf(24.0, 4.0, 2.0));
  for (std::size_t i = 10; i < 50; ++i) frames[i].ms = i % 2 == 0 ? 9.0 : 12.0;
  for (std::size_t i = 25; i < 50; ++i) frames[i].resize = 2.1;
  const HoldMeasures m = measureHold({10.0, 4.0, frames, {}});
  EXPECT_NEAR(m.biasMs, 0.5, 1e-12);
  EXPECT_NEAR(m.sigmaMs, 1.5, 1e-12);
  EXPECT_DOUBLE_EQ(m.changes, 2.0);  // one in 50
  EXPECT_EQ(m.reversals, 0.0);
}

TEST(HoldMeasures, WhatIsTooShortIsNotJudged) {
  const std::vector<HeldFrame> frames(14, frameOf(24.0, 4.0, 2.0));
  const HoldMeasures m = measureHold({10.0, 4.0, frames, {4}});
  EXPECT_EQ(m.judged, 0U);
  EXPECT_EQ(m.met, std::nullopt);
  EXPECT_EQ(m.parts[0].settleFrames, std::nullopt);  // four frames have no median of five
  EXPECT_EQ(m.parts[0].usedPixels, std::nullopt);
  EXPECT_EQ(m.parts[1].settleFrames, 0U);
  EXPECT_EQ(m.parts[1].usedPixels, std::nullopt);
}

TEST(HoldMeasures, NothingToShadeLeavesR) {
  const std::vector<HeldFrame> frames(20, frameOf(0.0, 12.0, 1.0));
  EXPECT_EQ(modelOf(frames, 10.0, 4.0).idealResize, 1.0);
  EXPECT_THROW(static_cast<void>(measureHold({10.0, 4.0, {}, {}})), std::invalid_argument);
}

}  // namespace
}  // namespace macula::control
