// Targets, tables and pictures that are made from points.
#include <gtest/gtest.h>

#include "engine/experiment/picture.h"
#include "engine/experiment/target.h"
#include "experiment_builder.h"

namespace macula::experiment {
namespace {

Point pointOf(const char* variant, const char* budget, double ms, double loss,
              const char* batch = "1") {
  return {{"key", std::string(variant) + budget},
          {"batch", batch},
          {"study", "all"},
          {"scene", "smoke"},
          {"width", 64},
          {"height", 48},
          {"seed", 1},
          {"light", "own"},
          {"variant", variant},
          {"label", variant},
          {"budget", *budget == 0 ? Point(nullptr) : Point(budget)},
          {"status", "measured"},
          {"ms",
           {{"transparency", {{"median", ms}, {"p5", ms}, {"p95", ms}}},
            {"passes", {{"oit.capture", {{"median", ms / 2}}}}}}},
          {"bytes", {{"budget", 100}}},
          {"fragments", {{"generated", 10}, {"merged", 0}, {"lost", 10 * loss}, {"loss", loss}}}};
}

Target ratioTarget() {
  Target target;
  target.name = "t";
  target.kind = Target::Kind::Ratio;
  target.metric = "ms.transparency";
  target.of = "a";
  target.against = {"b", "c"};
  target.limit = 1.25;
  return target;
}

std::vector<TargetRow> judgeOne(const Target& target, const std::vector<Point>& points) {
  static Experiment experiment;  // rows point into it
  experiment.targets = {target};
  return judge(experiment, points);
}

TEST(ExperimentTarget, ARatioIsOverTheLeastOfTheOthers) {
  const auto rows =
      judgeOne(ratioTarget(), {pointOf("a", "k_ave 2", 5.0, 0), pointOf("b", "k_ave 2", 10.0, 0),
                               pointOf("c", "k_ave 2", 4.0, 0)});
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_DOUBLE_EQ(*rows[0].value, 1.25);
  EXPECT_EQ(rows[0].state, TargetRow::State::Met) << "the limit itself is within";
  EXPECT_EQ(rows[0].where, "smoke 64x48, k_ave 2");
}

TEST(ExperimentTarget, ARatioKeepsToItsBudgetOrToNone) {
  const std::vector<Point> points{pointOf("a", "k_ave 2", 5.0, 0), pointOf("b", "k_ave 4", 1.0, 0),
                                  pointOf("c", "", 2.0, 0)};
  const auto rows = judgeOne(ratioTarget(), points);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_DOUBLE_EQ(*rows[0].value, 2.5);
  EXPECT_EQ(rows[0].state, TargetRow::State::Missed);
  EXPECT_NE(rows[0].note.find("b has no point"), std::string::npos) << rows[0].note;
}

TEST(ExperimentTarget, TimesOfDifferentRoundsAreNotDivided) {
  const auto rows = judgeOne(
      ratioTarget(), {pointOf("a", "k_ave 2", 5.0, 0), pointOf("c", "k_ave 2", 4.0, 0, "2")});
  EXPECT_EQ(rows[0].state, TargetRow::State::Unmeasured);
  EXPECT_NE(rows[0].note.find("interleaved"), std::string::npos) << rows[0].note;
}

TEST(ExperimentTarget, WhatNothingAnswersIsSaid) {
  const auto rows = judgeOne(ratioTarget(), {pointOf("b", "k_ave 2", 5.0, 0)});
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].state, TargetRow::State::Unmeasured);
  Point refused = pointOf("a", "k_ave 2", 0, 0);
  refused.erase("ms");
  refused["reason"] = "too large";
  const auto second = judgeOne(ratioTarget(), {refused, pointOf("b", "k_ave 2", 5.0, 0)});
  EXPECT_EQ(second[0].state, TargetRow::State::Unmeasured);
  EXPECT_NE(second[0].note.find("too large"), std::string::npos);
}

TEST(ExperimentTarget, AnOrderMustFallStrictly) {
  Target target = ratioTarget();
  target.kind = Target::Kind::Order;
  target.metric = "fragments.loss";
  target.against = {"a", "b", "c"};
  const auto state = [&](double a, double b, double c) {
    return judgeOne(target, {pointOf("a", "k_ave 2", 1, a), pointOf("b", "k_ave 2", 1, b),
                             pointOf("c", "k_ave 2", 1, c)})[0]
        .state;
  };
  EXPECT_EQ(state(0.9, 0.5, 0.4), TargetRow::State::Met);
  EXPECT_EQ(state(0.9, 0.5, 0.5), TargetRow::State::Missed);
  EXPECT_EQ(state(0.4, 0.5, 0.6), TargetRow::State::Missed);
}

TEST(ExperimentTarget, AnOrderOfNothingIsNotMet) {
  Target target = ratioTarget();
  target.kind = Target::Kind::Order;
  target.metric = "fragments.loss";
  target.against = {"a", "b", "c"};
  const auto row = [&](double a, double b, double c) {
    return judgeOne(target, {pointOf("a", "k_ave 2", 1, a), pointOf("b", "k_ave 2", 1, b),
                             pointOf("c", "k_ave 2", 1, c)})[0];
  };
  EXPECT_EQ(row(0, 0, 0).state, TargetRow::State::NotApplicable);
  EXPECT_EQ(row(0, 0, 0).reason, "everything fits");
  EXPECT_EQ(row(0.5, 0, 0).state, TargetRow::State::NotApplicable);
  EXPECT_EQ(row(0.5, 0, 0).reason, "b is at 0 already");
  EXPECT_EQ(row(0.5, 0.1, 0).state, TargetRow::State::Met);
  EXPECT_EQ(row(0, 0, 0.1).state, TargetRow::State::Missed) << "an exemption excuses no rise";
  EXPECT_EQ(row(0, 0.1, 0).reason, "");
}

TEST(ExperimentTarget, ARatioOfNothingToNothingIsNotApplicable) {
  Target target = ratioTarget();
  target.metric = "fragments.loss";
  const auto row =
      judgeOne(target, {pointOf("a", "k_ave 2", 1, 0.0), pointOf("b", "k_ave 2", 1, 0.0)})[0];
  EXPECT_EQ(row.state, TargetRow::State::NotApplicable);
  EXPECT_EQ(row.reason, "both are 0");
  EXPECT_EQ(
      judgeOne(target, {pointOf("a", "k_ave 2", 1, 0.5), pointOf("b", "k_ave 2", 1, 0.0)})[0].state,
      TargetRow::State::Unmeasured);
}

TEST(ExperimentTarget, SummariesAndJsonKeepWhatIsNotApplicableApart) {
  Target target = ratioTarget();
  target.kind = Target::Kind::Order;
  target.metric = "fragments.loss";
  target.against = {"a", "b"};
  std::vector<Point> points;
  for (const auto& [budget, b] : {std::pair{"k_ave 2", 0.2}, {"k_ave 4", 0.9}, {"k_ave 8", 0.0}}) {
    points.push_back(pointOf("a", budget, 1, b == 0.0 ? 0.0 : 0.5));
    points.push_back(pointOf("b", budget, 1, b));
  }
  const auto rows = judgeOne(target, points);
  EXPECT_EQ(summaryOf(rows), "1 met, 1 missed, 1 n/a, 0 unmeasured");
  const auto json = toJson(std::span<const TargetRow>(rows));
  EXPECT_EQ(json[0]["state"], "met");
  EXPECT_TRUE(json[0]["reason"].is_null());
  EXPECT_EQ(json[2]["state"], "n/a");
  EXPECT_EQ(json[2]["reason"], "everything fits");
}

TEST(ExperimentTarget, AValueMayLeaveOutScenesThatFit) {
  Target target = ratioTarget();
  target.kind = Target::Kind::Value;
  target.metric = "ms.passes.oit.capture";
  target.bound = Target::Bound::AtLeast;
  target.limit = 3.0;
  const std::vector<Point> fits{pointOf("a", "k_ave 2", 4.0, 0.0)};
  EXPECT_EQ(judgeOne(target, fits)[0].state, TargetRow::State::Missed);
  target.unlessAllStored = true;
  EXPECT_EQ(judgeOne(target, fits)[0].state, TargetRow::State::NotApplicable);
  EXPECT_EQ(judgeOne(target, fits)[0].reason, "everything fits");
  EXPECT_TRUE(judgeOne(target, fits)[0].value);
  EXPECT_EQ(judgeOne(target, {pointOf("a", "k_ave 2", 4.0, 0.1)})[0].state,
            TargetRow::State::Missed);
}

TEST(ExperimentCsv, HasAColumnForEveryPassAndQuotesTexts) {
  Point point = pointOf("a", "k_ave 2", 4.0, 0.25);
  point["label"] = "a, \"b\"";
  const std::string csv = toCsv(std::vector<Point>{point});
  EXPECT_EQ(csv.rfind("study,scene,width,", 0), 0U);
  EXPECT_NE(csv.find(",ms.passes.oit.capture\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find("all,smoke,64,48,1,own,a,\"a, \"\"b\"\"\",k_ave 2,,measured"),
            std::string::npos)
      << csv;
  EXPECT_EQ(csv.substr(csv.size() - 3), ",2\n") << "half of 4 ms in the last column";
}

TEST(ExperimentPicture, Base64OfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xFF\xFE"), "//4=");
}

TEST(ExperimentPicture, ShrinkingTakesMeans) {
  const image::Image8 wide{4, 2, 1, {0, 100, 10, 20, 100, 200, 30, 40}};
  const image::Image8 small = shrink(wide, 2);
  EXPECT_EQ(small.width, 2);
  EXPECT_EQ(small.height, 1);
  EXPECT_EQ(small.pixels, (std::vector<std::uint8_t>{100, 25}));
  // 3 to 2: each pixel covers one and a half. (0 + 30 / 2) / 1.5 = 10, (30 / 2 + 60) / 1.5 = 50
  const image::Image8 three{3, 1, 1, {0, 30, 60}};
  EXPECT_EQ(shrink(three, 2).pixels, (std::vector<std::uint8_t>{10, 50}));
  EXPECT_EQ(shrink(three, 3).pixels, three.pixels);
}

}  // namespace
}  // namespace macula::experiment
