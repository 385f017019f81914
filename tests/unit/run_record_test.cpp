// report.json: nulls, sums and the summary, by hand.
#include "engine/measure/run_record.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace macula::measure {
namespace {

FrameRecord frame(double ms, double rmse, std::uint64_t lost,
                  std::optional<double> flip = std::nullopt) {
  FrameRecord f;
  f.set("ms.total", ms);
  f.passMs = {{"tonemap", 0.5 * ms}};
  f.set("gaze.raw_x", std::numeric_limits<double>::quiet_NaN());
  f.set("gaze.raw_y", 0.0);
  f.set("gaze.age_s", std::numeric_limits<double>::infinity());
  f.set("gaze.state", "none");
  f.set("fragments.generated", 10 + lost);
  f.set("fragments.stored", std::uint64_t{10});
  f.set("fragments.merged", std::uint64_t{0});
  f.set("fragments.lost", lost);
  f.set("lock_failures", lost);
  setError(f, ImageError{rmse, std::nullopt, 2.0 * rmse, flip, 0.25 * rmse});
  return f;
}

TEST(RunRecord, WhatDoesNotApplyIsNull) {
  RunRecord run;
  FrameRecord bare;
  bare.set("gaze.state", "ok");
  run.frames = {bare};
  const auto json = toJson(run);
  EXPECT_EQ(json["schema"], 1);
  EXPECT_TRUE(json["sync"].is_null());
  EXPECT_TRUE(json["gaze_log"].is_null());
  EXPECT_TRUE(json["bytes"]["budget"].is_null());
  EXPECT_TRUE(json["frames"][0]["fragments"]["generated"].is_null());
  EXPECT_TRUE(json["frames"][0]["k"]["mean"].is_null());
  EXPECT_TRUE(json["frames"][0]["error"]["flip"].is_null());
  EXPECT_TRUE(json["frames"][0]["error"]["flip_gaze"].is_null());
  EXPECT_TRUE(json["frames"][0]["flicker"].is_null());
  EXPECT_TRUE(json["summary"]["flicker"].is_null());
  EXPECT_TRUE(json["bytes"]["buffers"].empty());
  EXPECT_TRUE(json["summary"]["error"]["rmse"].is_null());
  EXPECT_TRUE(json["summary"]["fragments"]["lost"].is_null());
  EXPECT_FALSE(json.contains("recording"));
  EXPECT_TRUE(toJson(RunRecord{})["summary"]["ms"]["median"].is_null());
}

TEST(RunRecord, PlacesAndAgesThatDoNotExistAreNull) {
  RunRecord run;
  run.frames = {frame(1, 0, 0)};
  const auto gaze = toJson(run)["frames"][0]["gaze"];
  EXPECT_TRUE(gaze["raw_x"].is_null());
  EXPECT_EQ(gaze["raw_y"], 0.0);
  EXPECT_TRUE(gaze["age_s"].is_null());
}

TEST(RunRecord, FlickerIsOverAllFramesButTheFirst) {
  RunRecord run;
  run.frames = {frame(1, 0, 0), frame(1, 0, 0), frame(1, 0, 0)};
  run.frames[1].set("flicker", 0.25);
  run.frames[2].set("flicker", 0.5);
  const auto json = toJson(run);
  EXPECT_TRUE(json["frames"][0]["flicker"].is_null());
  EXPECT_EQ(json["frames"][2]["flicker"], 0.5);
  EXPECT_EQ(json["summary"]["flicker"], 0.375);
}

TEST(RunRecord, HazardsAreOfRacyMethodsOnly) {
  RunRecord run;
  run.frames = {frame(1, 0, 0), frame(1, 0, 0)};
  run.frames[1].set("hazards", std::uint64_t{7});
  const auto json = toJson(run);
  EXPECT_TRUE(json["frames"][0]["hazards"].is_null());
  EXPECT_EQ(json["frames"][1]["hazards"], 7);
}

TEST(RunRecord, AMeanOfSomeFramesIsNone) {
  RunRecord run;
  run.frames = {frame(1, 0.1, 0, 0.05), frame(1, 0.1, 0)};
  EXPECT_TRUE(toJson(run)["summary"]["error"]["flip"].is_null());
  run.frames[1] = frame(1, 0.1, 0, 0.15);
  EXPECT_NEAR(toJson(run)["summary"]["error"]["flip"].get<double>(), 0.1, 1e-12);
}

TEST(RunRecord, BytesAreThoseOfTheLastFrame) {
  RunRecord run;
  run.frames = {frame(1, 0, 0), frame(1, 0, 0)};
  run.frames[0].set("bytes.oit", std::uint64_t{8});
  run.frames[1].set("bytes.oit", std::uint64_t{64});
  run.transparencyBytes = {{"fragment keys", 64}, {"fragment range", 8}};
  const auto bytes = toJson(run)["bytes"];
  EXPECT_EQ(bytes["oit"], 64);
  EXPECT_EQ(bytes["buffers"].dump(), R"({"fragment keys":64,"fragment range":8})");
}

TEST(RunRecord, SummaryIsOverAllFrames) {
  RunRecord run;
  run.frames = {frame(10, 0.3, 1, 0.15), frame(30, 0.4, 2, 0.2), frame(20, 0.0, 0, 0.0)};
  const auto json = toJson(run);
  const auto& summary = json["summary"];
  EXPECT_EQ(summary["ms"]["median"], 20.0);
  // Mean square (0.09 + 0.16 + 0) / 3 = 0.083333.
  EXPECT_NEAR(summary["error"]["rmse"].get<double>(), std::sqrt(0.25 / 3.0), 1e-12);
  EXPECT_NEAR(summary["error"]["psnr_db"].get<double>(), 10.7918, 1e-4);
  EXPECT_EQ(summary["error"]["max"], 0.8);
  EXPECT_NEAR(summary["error"]["flip"].get<double>(), 0.35 / 3.0, 1e-12);
  EXPECT_NEAR(summary["error"]["flip_gaze"].get<double>(), 0.175 / 3.0, 1e-12);
  EXPECT_EQ(summary["fragments"]["generated"], 33);
  EXPECT_EQ(summary["fragments"]["lost"], 3);
  EXPECT_EQ(summary["lock_failures"], 3);
  EXPECT_EQ(json["frames"][1]["lock_failures"], 2);
  EXPECT_EQ(json["frames"][1]["ms"].dump(), R"({"total":30.0,"tonemap":15.0})");
}

}  // namespace
}  // namespace macula::measure
