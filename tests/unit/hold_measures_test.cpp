// What a held run comes to: by hand, and against runs that must fail.
#include "engine/control/hold_measures.h"

#include <gtest/gtest.h>

#include <algorithm>
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
  for (std::size_t i = 100; i < frames.size(); ++i) frames[i].load = 2;
  return frames;
}

TEST(HoldMeasures, ByHand) {
  const std::vector<HeldFrame> frames = heldFrames();
  const HoldMeasures m = measureHold({10.0, 4.0, frames, {100}});
  ASSERT_EQ(m.parts.size(), 2U);
  EXPECT_NEAR(m.parts[0].model.idealResize, 2.0, 1e-9);
  EXPECT_NEAR(m.parts[1].model.idealResize, 2.828427, 1e-6);
  EXPECT_NEAR(m.parts[1].model.workMs, 48.0, 1e-9);
  EXPECT_NEAR(m.parts[1].model.restMs, 4.0, 1e-9);
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
  // Times that spread by more than themselves make nothing held.
  for (std::size_t i = 0; i < frames.size(); ++i) {
    frames[i].ms = i % 2 == 0 ? 5.0 : 14.0;
    frames[i].fixedMs = i % 3 == 0 ? 10.0 : i % 3 == 1 ? 20.0 : 50.0;
  }
  EXPECT_GT(measureHold({10.0, 4.0, frames, {}}).fixedSpread, 1.0);
  EXPECT_EQ(measureHold({10.0, 4.0, frames, {}}).tolerance, kMostTolerance);
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
  EXPECT_EQ(fits.parts[0].model.idealResize, 1.0);
  EXPECT_NEAR(fits.parts[0].model.reachableMs, 6.0, 1e-9);
  EXPECT_EQ(fits.met, true);
  // The same time at r = 2 is not: there was room for more pixels.
  const std::vector<HeldFrame> timid(50, frameOf(20.0, 1.0, 2.0));
  EXPECT_EQ(measureHold({10.0, 4.0, timid, {}}).met, false);
  const std::vector<HeldFrame> hard(50, frameOf(16.0, 12.0, 4.0));
  const HoldMeasures fails = measureHold({10.0, 4.0, hard, {}});
  EXPECT_EQ(fails.parts[0].model.idealResize, 4.0);
  EXPECT_NEAR(fails.parts[0].model.reachableMs, 13.0, 1e-9);
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

TEST(HoldMeasures, ALoadHasOneIdealWhereverItIsAndSaysWhatLimitsIt) {
  // Once, twice, once again; the camera has moved to cheaper pixels by then.
  std::vector<HeldFrame> frames(40, frameOf(24.0, 4.0, 2.0));
  frames.insert(frames.end(), 40, frameOf(48.0, 4.0, 2.828427));
  frames.insert(frames.end(), 30, frameOf(20.0, 4.0, 1.825742));
  for (std::size_t i = 40; i < 80; ++i) frames[i].load = 2;
  const HoldMeasures m = measureHold({10.0, 4.0, frames, {40, 80}});
  ASSERT_EQ(m.loads.size(), 2U);
  ASSERT_EQ(m.parts.size(), 3U);
  EXPECT_EQ(m.loads[1].times, 2);
  EXPECT_NEAR(m.loads[0].model.idealResize, 2.0, 1e-9);  // the median of 70 frames
  for (const HoldPart& part : m.parts) {
    const auto load = std::ranges::find(m.loads, part.load, &HoldLoad::times);
    EXPECT_EQ(part.model.idealResize, load->model.idealResize);
  }
  const auto limit = [](double work, double rest) {
    const ResizeModel model = modelOf(std::vector<HeldFrame>{frameOf(work, rest, 2.0)}, 10.0, 4.0);
    return std::pair(textOf(model.limit, 4.0), model.idealResize);
  };
  EXPECT_EQ(limit(24.0, 4.0), std::pair(std::string("target within reach"), 2.0));
  EXPECT_EQ(limit(5.0, 4.0), std::pair(std::string("r at its end 1"), 1.0));
  EXPECT_EQ(limit(200.0, 4.0), std::pair(std::string("r at its end 4"), 4.0));
  EXPECT_EQ(limit(24.0, 10.0),
            std::pair(std::string("floor of the cost that does not shrink"), 4.0));
  EXPECT_EQ(limit(0.0, 4.0), std::pair(std::string("nothing is computed at 1/r"), 1.0));
}

TEST(HoldMeasures, TheIdealIsThatOfRAlone) {
  // Of 12 ms that do not shrink, fewer layers take 6 away: the target is met, and not by r.
  std::vector<HeldFrame> frames(12, frameOf(48.0, 12.0, 4.0));
  frames.insert(frames.end(), 100, frameOf(48.0, 6.0, 4.0));
  for (std::size_t i = 12; i < frames.size(); ++i) frames[i].othersAtRest = false;
  const HoldMeasures m = measureHold({10.0, 4.0, frames, {}});
  EXPECT_EQ(m.loads[0].model.limit, ResizeLimit::Floor);
  EXPECT_EQ(m.loads[0].model.idealResize, 4.0);
  EXPECT_EQ(m.parts[0].usedPixels, 1.0);
}

TEST(HoldMeasures, HeldIsSaidOfWhatWasHeld) {
  std::vector<HeldFrame> frames = heldFrames();
  EXPECT_EQ(verdictOf(measureHold({10.0, 4.0, frames, {100}})), "held");
  for (std::size_t i = 180; i < 200; ++i) frames[i].ms = 16.0;  // a fifth of the second load
  HoldMeasures m = measureHold({10.0, 4.0, frames, {100}});
  EXPECT_EQ(m.parts[0].met, true);
  EXPECT_EQ(m.parts[1].met, false);
  EXPECT_NEAR(m.parts[1].within, 7.0 / 9.0, 1e-9);
  EXPECT_NEAR(m.withinTolerance, 8.0 / 9.0, 1e-9);
  EXPECT_EQ(verdictOf(m), "held in part");
  for (std::size_t i = 0; i < 100; ++i) frames[i].ms = 16.0;
  EXPECT_EQ(verdictOf(measureHold({10.0, 4.0, frames, {100}})), "not held");
  frames.resize(9);
  m = measureHold({10.0, 4.0, frames, {}});
  EXPECT_EQ(m.parts[0].met, std::nullopt);
  EXPECT_EQ(verdictOf(m), "not judged");
  // 90 % of all frames are not 90 % of each part: the gate is met, and a short load was not held.
  std::vector<HeldFrame> uneven(400, frameOf(24.0, 4.0, 2.0));
  for (std::size_t i = 370; i < 400; ++i) uneven[i].ms = 16.0;
  m = measureHold({10.0, 4.0, uneven, {360}});
  EXPECT_EQ(m.met, true);
  EXPECT_EQ(verdictOf(m), "held in part");
}

TEST(HoldMeasures, NothingToShadeLeavesR) {
  const std::vector<HeldFrame> frames(20, frameOf(0.0, 12.0, 1.0));
  EXPECT_EQ(modelOf(frames, 10.0, 4.0).idealResize, 1.0);
  EXPECT_THROW(static_cast<void>(measureHold({10.0, 4.0, {}, {}})), std::invalid_argument);
}

}  // namespace
}  // namespace macula::control
