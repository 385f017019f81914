// Means of a ratio over scenes.
#include <gtest/gtest.h>

#include "engine/experiment/target.h"
#include "experiment_builder.h"

namespace macula::experiment {
namespace {

const std::string kMean = R"(
[[target]]
name = "m"
kind = "mean"
metric = "rmse"
of = "limited"
against = "exact"
limit = "<= 0.75"
)";

Point pointOf(const char* variant, const char* scene, const char* budget, double rmse) {
  return {{"key", std::string(variant) + scene + budget},
          {"batch", "1"},
          {"study", "all"},
          {"scene", scene},
          {"width", 64},
          {"height", 48},
          {"seed", 1},
          {"light", "own"},
          {"variant", variant},
          {"budget", *budget == 0 ? Point(nullptr) : Point(budget)},
          {"sweep", nullptr},
          {"status", "measured"},
          {"error", {{"rmse", rmse}}}};
}

/// Ratios of 0.5 on smoke and 0.9 on bottles at k_ave 2, twice as much at share 0.3.
std::vector<Point> twoScenes() {
  return {pointOf("exact", "smoke", "", 0.1),
          pointOf("limited", "smoke", "k_ave 2", 0.05),
          pointOf("limited", "smoke", "share 0.3", 0.1),
          pointOf("exact", "bottles", "", 0.01),
          pointOf("limited", "bottles", "k_ave 2", 0.009),
          pointOf("limited", "bottles", "share 0.3", 0.018)};
}

struct Judged {
  Experiment experiment;  ///< rows point into it
  std::vector<TargetRow> rows;
};

Judged judged(const std::string& text, const std::vector<Point>& points) {
  Judged result{parseExperiment(text, "x.toml"), {}};
  result.rows = judge(result.experiment, points);
  return result;
}

TEST(ExperimentMean, IsOverScenesAtEachBudget) {
  const Judged made = judged(kSmall + kMean, twoScenes());
  const auto& rows = made.rows;
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_NEAR(*rows[0].value, 0.7, 1e-12);  // the ratio of the means would be 0.059 / 0.11
  EXPECT_EQ(rows[0].state, TargetRow::State::Met);
  EXPECT_EQ(rows[0].where, "mean of 2 scenes, 64x48, k_ave 2");
  EXPECT_EQ(rows[0].note, "0.5 (smoke), 0.9 (bottles)");
  EXPECT_NEAR(*rows[1].value, 1.4, 1e-12);
  EXPECT_EQ(rows[1].state, TargetRow::State::Missed);
}

TEST(ExperimentMean, IsUnmeasuredWhileASceneIsMissing) {
  std::vector<Point> points = twoScenes();
  points.erase(points.begin() + 4);  // bottles at k_ave 2
  const Judged made = judged(kSmall + kMean, points);
  ASSERT_EQ(made.rows.size(), 2U);
  EXPECT_EQ(made.rows[0].state, TargetRow::State::Unmeasured);
  EXPECT_NE(made.rows[0].note.find("bottles"), std::string::npos) << made.rows[0].note;
  EXPECT_EQ(made.rows[1].state, TargetRow::State::Missed) << "the other budget is whole";
}

TEST(ExperimentMean, ARefusedPointSaysWhy) {
  std::vector<Point> points = twoScenes();
  points[4].erase("error");
  points[4]["reason"] = "too large";
  const Judged made = judged(kSmall + kMean, points);
  EXPECT_EQ(made.rows[0].state, TargetRow::State::Unmeasured);
  EXPECT_NE(made.rows[0].note.find("too large"), std::string::npos) << made.rows[0].note;
}

TEST(ExperimentMean, OptionalScenesCountOnlyWhereTheyAreNamed) {
  const std::string optional = smallWith("sizes =", "optional_scenes = [\"a.glb\"]\nsizes =");
  std::vector<Point> points = twoScenes();
  EXPECT_NEAR(*judged(optional + kMean, points).rows[0].value, 0.7, 1e-12) << "it is not here";
  points.push_back(pointOf("exact", "a.glb", "", 0.1));
  points.push_back(pointOf("limited", "a.glb", "k_ave 2", 0.01));
  EXPECT_NEAR(*judged(optional + kMean, points).rows[0].value, 0.7, 1e-12) << "it is";
  const Judged named = judged(optional + kMean + "scenes = [\"smoke\", \"a.glb\"]\n", points);
  EXPECT_NEAR(*named.rows[0].value, 0.3, 1e-12);
}

TEST(ExperimentMean, ABudgetOfOneSceneIsOverThatScene) {
  const std::string text =
      smallWith("{ k_ave = 2 }", "{ k_ave = 2, scenes = [\"smoke\"] }") + kMean;
  std::vector<Point> points = twoScenes();
  points.erase(points.begin() + 4);
  const Judged made = judged(text, points);
  EXPECT_NEAR(*made.rows[0].value, 0.5, 1e-12);
  EXPECT_EQ(made.rows[0].where, "mean of 1 scene, 64x48, k_ave 2");
}

}  // namespace
}  // namespace macula::experiment
