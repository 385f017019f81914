// report.json: nulls, sums and the summary, by hand.
#include "engine/measure/run_record.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace macula::measure {
namespace {

FrameRecord frame(double ms, double rmse, std::uint64_t lost) {
  FrameRecord f;
  f.totalMs = ms;
  f.passMs = {{"tonemap", 0.5 * ms}};
  f.rawX = std::numeric_limits<double>::quiet_NaN();
  f.gazeAgeSeconds = std::numeric_limits<double>::infinity();
  f.gazeState = "none";
  f.fragments = FragmentNumbers{10 + lost, 10, 0, lost};
  f.error = ImageError{rmse, std::nullopt, 2.0 * rmse, 0.5 * rmse, 0.25 * rmse};
  return f;
}

TEST(RunRecord, WhatDoesNotApplyIsNull) {
  RunRecord run;
  FrameRecord bare;
  bare.gazeState = "ok";
  run.frames = {bare};
  const auto json = toJson(run);
  EXPECT_EQ(json["schema"], 1);
  EXPECT_TRUE(json["sync"].is_null());
  EXPECT_TRUE(json["bytes"]["budget"].is_null());
  EXPECT_TRUE(json["frames"][0]["fragments"]["generated"].is_null());
  EXPECT_TRUE(json["frames"][0]["k"]["mean"].is_null());
  EXPECT_TRUE(json["frames"][0]["error"]["flip"].is_null());
  EXPECT_TRUE(json["frames"][0]["error"]["flip_gaze"].is_null());
  EXPECT_TRUE(json["frames"][0]["flicker"].is_null());
  EXPECT_TRUE(json["summary"]["flicker"].is_null());
  EXPECT_TRUE(json["bytes"]["buffers"].empty());
  EXPECT_TRUE(json["summary"]["error"]["rmse"].is_null());
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
  run.frames[1].flicker = 0.25;
  run.frames[2].flicker = 0.5;
  const auto json = toJson(run);
  EXPECT_TRUE(json["frames"][0]["flicker"].is_null());
  EXPECT_EQ(json["frames"][2]["flicker"], 0.5);
  EXPECT_EQ(json["summary"]["flicker"], 0.375);
}

TEST(RunRecord, HazardsAreOfRacyMethodsOnly) {
  RunRecord run;
  run.frames = {frame(1, 0, 0), frame(1, 0, 0)};
  run.frames[1].hazards = 7;
  const auto json = toJson(run);
  EXPECT_TRUE(json["frames"][0]["hazards"].is_null());
  EXPECT_EQ(json["frames"][1]["hazards"], 7);
}

TEST(RunRecord, AMeanOfSomeFramesIsNone) {
  RunRecord run;
  run.frames = {frame(1, 0.1, 0), frame(1, 0.1, 0)};
  run.frames[1].error->flip.reset();
  EXPECT_TRUE(toJson(run)["summary"]["error"]["flip"].is_null());
}

TEST(RunRecord, BuffersByName) {
  RunRecord run;
  run.transparencyBytes = {{"fragment keys", 64}, {"fragment range", 8}};
  EXPECT_EQ(toJson(run)["bytes"]["buffers"].dump(), R"({"fragment keys":64,"fragment range":8})");
}

TEST(RunRecord, SummaryIsOverAllFrames) {
  RunRecord run;
  run.frames = {frame(10, 0.3, 1), frame(30, 0.4, 2), frame(20, 0.0, 0)};
  const auto summary = toJson(run)["summary"];
  EXPECT_EQ(summary["ms"]["median"], 20.0);
  // Mean square (0.09 + 0.16 + 0) / 3 = 0.083333.
  EXPECT_NEAR(summary["error"]["rmse"].get<double>(), std::sqrt(0.25 / 3.0), 1e-12);
  EXPECT_NEAR(summary["error"]["psnr_db"].get<double>(), 10.7918, 1e-4);
  EXPECT_EQ(summary["error"]["max"], 0.8);
  EXPECT_NEAR(summary["error"]["flip"].get<double>(), 0.35 / 3.0, 1e-12);
  EXPECT_NEAR(summary["error"]["flip_gaze"].get<double>(), 0.175 / 3.0, 1e-12);
  EXPECT_EQ(summary["fragments"]["generated"], 33);
  EXPECT_EQ(summary["fragments"]["lost"], 3);
}

}  // namespace
}  // namespace macula::measure
