// BIDS eye tracking: rows without a header, described by a JSON.
#include <fstream>

#include "engine/gaze/log_reader.h"
#include "gaze_log_cases.h"
#include "temporary_path.h"

namespace macula::gaze {
namespace {

const std::string kSidecar = R"({
  "SamplingFrequency": 500, "StartTime": 0, "PhysioType": "eyetrack", "RecordedEye": "left",
  "SampleCoordinateSystem": "gaze-on-screen",
  "Columns": ["timestamp", "x_coordinate", "y_coordinate", "pupil_size", "blink"],
  "timestamp": {"Units": "ms"}, "x_coordinate": {"Units": "pixel"},
  "y_coordinate": {"Units": "pixel"}, "pupil_size": {"Units": "mm"},
  "StimulusPresentation": {"ScreenResolution": [1000, 500], "ScreenOrigin": ["top", "left"]}})";

/// The sidecar with a piece of it replaced.
std::string changed(const std::string& from, const std::string& to) {
  std::string text = kSidecar;
  text.replace(text.find(from), from.size(), to);
  return text;
}

TEST(Bids, ColumnsUnitsAndScreenFromTheJson) {
  const GazeLog log = parseLog(
      "\xEF\xBB\xBF"
      "1000\t250\t100\t3.5\t0\n1002.5\tn/a\tn/a\tn/a\t1\n1004\t500\t250\t3.5\t1\n",
      {}, kSidecar);
  EXPECT_EQ(log.format, "bids");
  ASSERT_EQ(log.samples.size(), 3U);
  expectPlace(log.samples[0], 0.25, 0.2);
  EXPECT_FLOAT_EQ(log.samples[0].pupilMillimetres.value(), 3.5F);
  expectLost(log.samples[1]);
  expectLost(log.samples[2]);  // in a blink
  EXPECT_EQ(log.samples[1].timeSeconds, 0.0025);
  EXPECT_EQ(log.counters.blinks, 1U);
  EXPECT_EQ(describe(log.coordinates),
            "px (file), origin top left (file), of the screen 1000x500 (file)");
  EXPECT_EQ(log.notes, std::vector<std::string>{"reader: recorded eye: left"});
}

TEST(Bids, TimesFromTheFrequencyWhereTheyHaveNoUnit) {
  const std::string rows = "7\t250\t100\t3\t0\n9\t250\t101\t3\t0\n";
  const GazeLog log = parseLog(rows, {}, changed("\"timestamp\": {\"Units\": \"ms\"},", ""));
  EXPECT_EQ(log.samples.at(1).timeSeconds, 1.0 / 500.0);
  const GazeLog said =
      parseLog(rows, {.timeUnit = TimeUnit::Seconds}, changed("{\"Units\": \"ms\"}", "{}"));
  EXPECT_EQ(said.samples.at(1).timeSeconds, 2.0);
}

TEST(Bids, ADotIsNoValueAndCuresWorkAsNamed) {
  const GazeLog log = parseLog("1000\t   .\t   .\t0.0\t0\n1002\t250\t100\t3\t0\n", {}, kSidecar);
  ASSERT_EQ(log.samples.size(), 2U);
  expectLost(log.samples[0]);
  expectPlace(log.samples[1], 0.25, 0.2);
  // Without a column of times, no unit of times helps.
  const std::string untimed = R"({"Columns": ["x_coordinate", "y_coordinate"],
    "x_coordinate": {"Units": "0..1"}, "ScreenOrigin": ["top", "left"]})";
  EXPECT_EQ(errorOfLog("0.5\t0.5\n", {}, untimed),
            "log.csv: line 1: neither the unit of the timestamps nor SamplingFrequency is said; "
            "write SamplingFrequency into its JSON");
}

TEST(Bids, BottomLeftAndBothEyes) {
  const std::string rows = "1\t250\t100\t3\t0\n";
  expectPlace(
      parseLog(rows, {}, changed("[\"top\", \"left\"]", "[\"bottom\", \"left\"]")).samples.at(0),
      0.25, 0.8);
  const GazeLog both = parseLog(
      "1\t200\t100\t400\t300\n2\tn/a\tn/a\t400\t300\n", {},
      changed(
          "\"x_coordinate\", \"y_coordinate\", \"pupil_size\", \"blink\"",
          "\"eye1_x_coordinate\", \"eye1_y_coordinate\", \"eye2_x_coordinate\", "
          "\"eye2_y_coordinate\"], \"SampleCoordinateUnits\": \"pixel\", \"EyeNames\": [\"a\""));
  expectPlace(both.samples.at(0), 0.3, 0.4);
  expectPlace(both.samples.at(1), 0.4, 0.6);
  EXPECT_EQ(both.counters.leftLost, 1U);
}

TEST(Bids, WhatTheJsonDoesNotSayIsAskedFor) {
  const std::string rows = "1\t250\t100\t3\t0\n";
  EXPECT_EQ(
      errorOfLog(rows, {}, changed("\"x_coordinate\": {\"Units\": \"pixel\"}", "\"z\": {}")),
      "log.csv: line 1: the unit of the coordinates is not said; give --gaze.unit px, 0..1 or "
      "deg");
  EXPECT_EQ(errorOfLog(rows, {}, changed("\"ScreenOrigin\"", "\"Origin\"")),
            "log.csv: line 1: the origin of the coordinates is not said; give --gaze.origin "
            "top-left, bottom-left, centre or centre-up");
  EXPECT_EQ(errorOfLog(rows, {}, changed("\"ScreenResolution\"", "\"Resolution\"")),
            "log.csv: line 1: pixels of a screen whose size is not said; give --gaze.screen "
            "WIDTHxHEIGHT, or write ScreenResolution into its JSON");
  EXPECT_EQ(errorOfLog(rows, {.format = "bids"}),
            "log.csv: line 1: a BIDS recording needs its JSON, as NAME.json beside NAME.tsv; copy "
            "it there or give --gaze.sidecar FILE.json");
  EXPECT_EQ(errorOfLog(rows, {.format = "bids"}, "{\"Columns\": 5"),
            "log.csv: line 1: the JSON beside it lists no 'x_coordinate' in 'Columns'; check it");
  EXPECT_EQ(
      errorOfLog(rows + "2\tx\t100\t3\t0\n" + rows, {}, kSidecar),
      "log.csv: line 2: x_coordinate is 'x' instead of a number or n/a; export the log again");
}

TEST(Bids, FilesThatLieBesideTheRecording) {
  const std::filesystem::path folder = std::filesystem::path(macula::test::temporaryPath("bids"));
  std::filesystem::create_directories(folder);
  const auto write = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder / name) << text;
  };
  std::string sidecar = kSidecar;
  sidecar.resize(sidecar.find(",\n  \"StimulusPresentation\""));
  write("sub-01_task-look_recording-eye1_physio.tsv", "1\t250\t100\t3\t0\n2\t250\t100\t3\t0\n");
  write("sub-01_task-look_recording-eye1_physio.json", sidecar + "}");
  write(
      "sub-01_task-look_events.json",
      R"({"StimulusPresentation": {"ScreenResolution": [1000, 500], "ScreenOrigin": ["top", "left"]}})");
  const GazeLog log = readGazeLog(folder / "sub-01_task-look_recording-eye1_physio.tsv");
  EXPECT_EQ(log.format, "bids");
  ASSERT_EQ(log.samples.size(), 2U);
  expectPlace(log.samples[0], 0.25, 0.2);
  const auto beside = sidecarFiles(folder / "sub-01_task-look_recording-eye1_physio.tsv", {});
  ASSERT_EQ(beside.size(), 2U);
  EXPECT_EQ(beside[0].filename(), "sub-01_task-look_recording-eye1_physio.json");
  EXPECT_EQ(beside[1].filename(), "sub-01_task-look_events.json");
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace macula::gaze
