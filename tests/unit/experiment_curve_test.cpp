// Curves of quality against speed, and targets on points of sweeps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/experiment/curve.h"
#include "engine/experiment/speedup.h"
#include "engine/experiment/target.h"

namespace macula::experiment {
namespace {

constexpr double kExact = std::numeric_limits<double>::infinity();

TEST(ExperimentCurve, AnEnvelopeKeepsWhatNoOtherBeats) {
  // 3x at 30 dB beats 2x at 28 dB; of two at 4x the better one stays.
  const std::vector<CurvePoint> points{{1.5, 40}, {2, 28}, {3, 30}, {4, 20}, {4, 22}};
  const auto envelope = envelopeOf(points);
  ASSERT_EQ(envelope.size(), 3U);
  EXPECT_EQ(envelope[0].speedup, 1.5);
  EXPECT_EQ(envelope[1].speedup, 3.0);
  EXPECT_EQ(envelope[2].quality, 22.0);
}

TEST(ExperimentCurve, ExactPointsBeatOthersAndAreNoPartOfTheLine) {
  const std::vector<CurvePoint> points{{1, 50}, {2, kExact}, {3, 30}};
  const auto envelope = envelopeOf(points);
  ASSERT_EQ(envelope.size(), 1U);
  EXPECT_EQ(envelope[0].speedup, 3.0);
  EXPECT_TRUE(envelopeOf(std::vector<CurvePoint>{{1, kExact}}).empty());
}

TEST(ExperimentCurve, BetweenPointsItIsLinearInTheLogarithm) {
  const std::vector<CurvePoint> line{{1, 40}, {4, 30}};
  EXPECT_DOUBLE_EQ(qualityAt(line, 1.0).value(), 40.0);
  EXPECT_DOUBLE_EQ(qualityAt(line, 2.0).value(), 35.0) << "half way between 1 and 4";
  EXPECT_DOUBLE_EQ(qualityAt(line, 4.0).value(), 30.0);
  EXPECT_FALSE(qualityAt(line, 0.9));
  EXPECT_FALSE(qualityAt(line, 4.1));
  EXPECT_FALSE(qualityAt({}, 1.0));
}

TEST(ExperimentCurve, AGapIsTakenAtThePointsOfBoth) {
  // a: 40 at 1, 30 at 4. b: 33 at 2, 13 at 8, so 23 at 4.
  const std::vector<CurvePoint> a{{1, 40}, {4, 30}};
  const std::vector<CurvePoint> b{{2, 33}, {8, 13}};
  const CurveGap gap = gapBetween(a, b).value();
  EXPECT_EQ(gap.places, 2U) << "at 2 and at 4";
  EXPECT_DOUBLE_EQ(gap.least, 35.0 - 33.0);
  EXPECT_DOUBLE_EQ(gap.leastAt, 2.0);
  EXPECT_DOUBLE_EQ(gap.mean, (2.0 + 7.0) / 2.0);
  EXPECT_DOUBLE_EQ(gap.from, 2.0);
  EXPECT_DOUBLE_EQ(gap.to, 4.0);
  EXPECT_DOUBLE_EQ(gapBetween(b, a).value().least, -7.0) << "the other way round";
  EXPECT_FALSE(gapBetween(a, std::vector<CurvePoint>{{5, 30}, {6, 20}}));
  EXPECT_FALSE(gapBetween(a, {}));
}

/// full, a swept "plain" and a swept "better" whose frames are interleaved.
Experiment sweptExperiment(const std::string& target) {
  return parseExperiment(R"(title = "t"
scenes = ["smoke"]
base = "full"
[[variant]]
id = "full"
[[variant]]
id = "plain"
sweep = { lod.r = [1, 2, 4] }
[[variant]]
id = "better"
sweep = { lod.r = [1, 2, 4] }
[[target]]
name = "t"
)" + target,
                         "x.toml");
}

constexpr const char* kCurve =
    "kind = \"curve\"\nmetric = \"psnr_db\"\nof = \"better\"\nagainst = \"plain\"\nlimit = \"> 0\"";

Point pointOf(const char* variant, double value, double ms, double psnr, const char* batch = "1") {
  const bool exact = std::isinf(psnr);
  return {{"key", variant},
          {"batch", batch},
          {"study", "all"},
          {"scene", "smoke"},
          {"width", 64},
          {"height", 48},
          {"seed", 1},
          {"light", "own"},
          {"variant", variant},
          {"budget", nullptr},
          {"sweep", value > 0 ? Point(value) : Point(nullptr)},
          {"status", "measured"},
          {"ms",
           {{"total", {{"median", ms}, {"p5", ms}, {"p95", ms}}},
            {"shading", {{"median", ms / 2}, {"p5", ms / 2}, {"p95", ms / 2}}},
            {"passes", {{"lod.shade", {{"median", ms / 4}}}, {"lighting", {{"median", ms / 8}}}}}}},
          {"shading", {{"shaded_share", 0.25}, {"holes_share", 0.0625}}},
          {"error",
           {{"rmse", exact ? 0.0 : 0.1},
            {"psnr_db", exact ? Point(nullptr) : Point(psnr)},
            {"flip_gaze", 0.125}}}};
}

/// plain: 10 ms, 5 ms, 2.5 ms of 10 (1x, 2x, 4x); better takes a quarter longer.
std::vector<Point> measuredPoints() {
  return {pointOf("full", 0, 10, kExact),   pointOf("plain", 1, 10, kExact),
          pointOf("plain", 2, 5, 30),       pointOf("plain", 4, 2.5, 20),
          pointOf("better", 1, 12, kExact), pointOf("better", 2, 6.25, 40),
          pointOf("better", 4, 3.125, 30)};
}

TEST(ExperimentCurve, ATargetComparesAtEqualSpeed) {
  const Experiment e = sweptExperiment(kCurve);
  const auto points = measuredPoints();
  const auto rows = judge(e, points);
  ASSERT_EQ(rows.size(), 1U) << "one row, however many points the curve has";
  // better: 40 at 1.6, 30 at 3.2. plain: 30 at 2, 20 at 4. Shared: 2 to 3.2.
  const double at2 = 40.0 - 10.0 * std::log2(2.0 / 1.6) - 30.0;
  const double at32 = 30.0 - (30.0 - 10.0 * std::log2(3.2 / 2.0));
  EXPECT_NEAR(*rows[0].value, std::min(at2, at32), 1e-12);
  EXPECT_EQ(rows[0].state, TargetRow::State::Met);
  EXPECT_EQ(rows[0].where, "smoke 64x48");
  EXPECT_NE(rows[0].note.find("1 of plain exact"), std::string::npos) << rows[0].note;
  const Experiment mean = sweptExperiment(std::string(kCurve) + "\nstatistic = \"mean\"");
  EXPECT_NEAR(*judge(mean, points)[0].value, (at2 + at32) / 2.0, 1e-12);
  EXPECT_EQ(mean.targets[0].limitText(), "mean > 0");
}

TEST(ExperimentCurve, TheLimitItselfIsNotAbove) {
  const Experiment e = sweptExperiment(kCurve);
  const auto rows =
      judge(e, std::vector<Point>{pointOf("full", 0, 10, kExact), pointOf("plain", 2, 5, 30),
                                  pointOf("better", 2, 5, 30)});
  EXPECT_EQ(rows[0].value, 0.0);
  EXPECT_EQ(rows[0].state, TargetRow::State::Missed);
}

TEST(ExperimentCurve, WhatCannotBeComparedIsUnmeasuredAndSaysWhy) {
  const Experiment e = sweptExperiment(kCurve);
  const auto note = [&](const std::vector<Point>& points) {
    const auto rows = judge(e, points);
    EXPECT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].state, TargetRow::State::Unmeasured);
    return rows[0].note;
  };
  EXPECT_NE(note({pointOf("full", 0, 10, kExact), pointOf("plain", 2, 5, 30),
                  pointOf("better", 2, 6, 30)})
                .find("no speed-up that both have"),
            std::string::npos);
  EXPECT_NE(note({pointOf("plain", 2, 5, 30), pointOf("better", 2, 5, 30)}).find("base"),
            std::string::npos);
  EXPECT_NE(note({pointOf("full", 0, 10, kExact, "2"), pointOf("better", 2, 5, 30)}).find("base"),
            std::string::npos);
  EXPECT_NE(note({pointOf("full", 0, 10, kExact), pointOf("plain", 2, 5, kExact),
                  pointOf("better", 2, 5, kExact)})
                .find("1 of better exact"),
            std::string::npos);
}

TEST(ExperimentCurve, CostsOtherThanTheFrameCanBeNamed) {
  const Experiment e = sweptExperiment(std::string(kCurve) + "\ncost = \"ms.passes.lod.shade\"");
  EXPECT_EQ(judge(e, measuredPoints())[0].state, TargetRow::State::Met);
  const Experiment none = sweptExperiment(std::string(kCurve) + "\ncost = \"ms.passes.lod.shde\"");
  EXPECT_EQ(judge(none, measuredPoints())[0].state, TargetRow::State::Unmeasured);
}

TEST(ExperimentSpeedup, IsOverTheBaseOfTheSameRounds) {
  const Experiment e = sweptExperiment(kCurve);
  auto points = measuredPoints();
  points.push_back(pointOf("better", 4, 1, 30, "2"));
  giveSpeedups(e, points);
  EXPECT_EQ(metricOf(points[0], "speedup"), 1.0);
  EXPECT_EQ(metricOf(points[3], "speedup"), 4.0);
  EXPECT_EQ(metricOf(points[6], "speedup"), 3.2);
  EXPECT_FALSE(metricOf(points.back(), "speedup")) << "other rounds";
}

std::vector<TargetRow> rowsOf(const std::string& target) {
  static Experiment experiment;  // rows point into it
  experiment = sweptExperiment(target);
  return judge(experiment, measuredPoints());
}

TEST(ExperimentSweepTarget, ARatioKeepsToItsValue) {
  const auto rows = rowsOf(
      "kind = \"ratio\"\nmetric = \"ms.total\"\nof = \"better\"\nagainst = \"plain\"\n"
      "limit = \"<= 1.25\"");
  ASSERT_EQ(rows.size(), 3U) << "a row for each value";
  EXPECT_DOUBLE_EQ(*rows[0].value, 1.2);
  EXPECT_DOUBLE_EQ(*rows[2].value, 1.25);
  EXPECT_EQ(rows[2].where, "smoke 64x48, r=4");
  EXPECT_NE(rows[2].note.find("(plain r=4)"), std::string::npos) << rows[2].note;
}

TEST(ExperimentSweepTarget, OnePointCanBeNamed) {
  const auto rows = rowsOf(
      "kind = \"ratio\"\nmetric = \"ms.total\"\nof = \"better\"\nat = 2\nagainst = \"full\"\n"
      "limit = \"<= 0.5\"");
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_DOUBLE_EQ(*rows[0].value, 0.625);
  EXPECT_EQ(rows[0].state, TargetRow::State::Missed);
}

TEST(ExperimentSweepTarget, PointsOfOneSweepCanBeDivided) {
  const auto rows = rowsOf(
      "kind = \"ratio\"\nmetric = \"ms.passes.lod.shade\"\nof = \"plain\"\nat = 4\n"
      "against = \"plain\"\nagainst_at = 1\nlimit = \"<= 0.3\"");
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_DOUBLE_EQ(*rows[0].value, 0.25);
  EXPECT_EQ(rows[0].state, TargetRow::State::Met);
}

TEST(ExperimentSweepTarget, ADifferentMetricCanBeDividedBy) {
  const auto rows = rowsOf(
      "kind = \"ratio\"\nmetric = \"ms.passes.lod.shade\"\nof = \"plain\"\nat = 4\n"
      "against = \"full\"\nagainst_metric = \"ms.passes.lighting\"\nlimit = \">= 0.5\"");
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_DOUBLE_EQ(*rows[0].value, (2.5 / 4) / (10.0 / 8));
  EXPECT_EQ(rows[0].state, TargetRow::State::Met);
}

TEST(ExperimentSweepTarget, AValueOfOnePoint) {
  const auto rows = rowsOf(
      "kind = \"value\"\nmetric = \"shading.shaded_share\"\nof = \"plain\"\nat = 2\n"
      "limit = \"<= 0.2\"");
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_DOUBLE_EQ(*rows[0].value, 0.25);
  EXPECT_EQ(rows[0].state, TargetRow::State::Missed);
}

TEST(ExperimentCsv, PointsOfASweepHaveTheirColumns) {
  auto points = std::vector<Point>{pointOf("full", 0, 10, kExact), pointOf("plain", 2, 5, 30)};
  giveSpeedups(sweptExperiment(kCurve), points);
  const std::string csv = toCsv(points);
  const auto line = [&](int index) {
    std::size_t begin = 0;
    for (int i = 0; i < index; ++i) begin = csv.find('\n', begin) + 1;
    std::vector<std::string> cells;
    std::string cell;
    for (std::size_t i = begin; csv[i] != '\n'; ++i) {
      if (csv[i] == ',') {
        cells.push_back(std::exchange(cell, {}));
      } else {
        cell += csv[i];
      }
    }
    cells.push_back(cell);
    return cells;
  };
  const auto heads = line(0);
  const auto at = [&](int row, const std::string& head) {
    const auto found = std::find(heads.begin(), heads.end(), head);
    return found == heads.end() ? "no " + head
                                : line(row)[static_cast<std::size_t>(found - heads.begin())];
  };
  EXPECT_EQ(at(1, "sweep"), "");
  EXPECT_EQ(at(1, "psnr_db"), "") << "the exact image";
  EXPECT_EQ(at(2, "sweep"), "2.0");
  EXPECT_EQ(at(2, "speedup"), "2");
  EXPECT_EQ(at(2, "ms.shading"), "2.5");
  EXPECT_EQ(at(2, "shading.shaded_share"), "0.25");
  EXPECT_EQ(at(2, "shading.holes_share"), "0.0625");
  EXPECT_EQ(at(2, "flip_gaze"), "0.125");
  EXPECT_EQ(at(2, "ms.passes.lod.shade"), "1.25");
}

}  // namespace
}  // namespace macula::experiment
