// Tobii Studio text export: rows made by hand, and a real recording.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "gaze_log_cases.h"

namespace macula::gaze {
namespace {

const char* const kHeader =
    "Timestamp\tGazePointXLeft\tGazePointYLeft\tPupilLeft\tValidityLeft\tGazePointXRight\t"
    "GazePointYRight\tPupilRight\tValidityRight\tGazePointX\tGazePointY\tEvent\tMediaWidth\t"
    "MediaHeight\tMediaPosX\tMediaPosY\tMicroSecondTimestamp\t\r\n";

/// One row; `eyes` is left x, y, pupil, validity and the same of the right, `point` x and y.
std::string row(const std::string& ms, const std::string& eyes, const std::string& point,
                const std::string& media, const std::string& us) {
  return ms + "\t" + eyes + "\t" + point + "\t\t" + media + "\t" + us + "\t\r\n";
}

const std::string kSeen = "600,5\t300,5\t4,0\t0\t680,5\t310,5\t5,0\t0";
const std::string kScreen = "1000\t500\t0\t0";

GazeLog parse(const std::string& text, const LogOptions& options = {}) {
  return parseLog(text, options);
}

std::string errorOf(const std::string& text, const LogOptions& options = {}) {
  return errorOfLog(text, options);
}

void expectPosition(const GazeSample& sample, double x, double y) {
  EXPECT_TRUE(sample.valid);
  EXPECT_DOUBLE_EQ(sample.position.x, x);
  EXPECT_DOUBLE_EQ(sample.position.y, y);
}

TEST(TobiiStudio, DecimalCommaByteOrderMarkMicroSecondsAndPupil) {
  const GazeLog log =
      parse("\xEF\xBB\xBF" + std::string(kHeader) + row("18", kSeen, "640\t300", kScreen, "18138") +
            row("38", kSeen, "640,5\t301,25", kScreen, "38008"));
  EXPECT_EQ(log.format, "tobii-studio");
  ASSERT_EQ(log.samples.size(), 2U);
  EXPECT_DOUBLE_EQ(log.startSeconds, 0.018138);
  EXPECT_EQ(log.samples[0].timeSeconds, 0.0);
  EXPECT_EQ(log.samples[1].timeSeconds, 0.01987);  // 38008 - 18138 = 19870 microseconds
  expectPosition(log.samples[0], 0.64, 0.6);
  expectPosition(log.samples[1], 0.6405, 0.6025);
  EXPECT_FLOAT_EQ(log.samples[0].pupilMillimetres.value(), 4.5F);
  EXPECT_EQ(log.coordinates.screenPixels, glm::dvec2(1000, 500));
}

TEST(TobiiStudio, LostSamplesAndSentinelsAreNoPlaces) {
  const std::string none = "-1280\t-1280\t-1\t4\t-1280\t-1280\t-1\t4";
  const std::string right = "-1280\t-1280\t-1\t4\t700\t400\t5,0\t0";
  const std::string wrongFlag = "-1280\t-1280\t-1\t0\t-1280\t-1280\t-1\t0";
  const GazeLog log = parse(
      kHeader + row("0", none, "0\t0", kScreen, "0") + row("20", right, "0\t0", kScreen, "20000") +
      row("40", kSeen, "\t", kScreen, "40000") + row("60", wrongFlag, "0\t0", kScreen, "60000") +
      row("80", none, "640\t300", kScreen, "80000") +
      row("100", right, "2147483647\t1", kScreen, "100000"));
  ASSERT_EQ(log.samples.size(), 6U);
  EXPECT_FALSE(log.samples[0].valid);
  EXPECT_TRUE(std::isnan(log.samples[0].position.x));
  expectPosition(log.samples[1], 0.7, 0.8);       // the right eye alone
  expectPosition(log.samples[2], 0.6405, 0.611);  // mean of 600.5, 680.5 and of 300.5, 310.5
  EXPECT_FALSE(log.samples[3].valid);
  EXPECT_FALSE(log.samples[4].valid);
  expectPosition(log.samples[5], 0.7, 0.8);
  EXPECT_FLOAT_EQ(log.samples[1].pupilMillimetres.value(), 5.0F);
  EXPECT_EQ(assess(log).lost, 3U);
}

TEST(TobiiStudio, EventRowsAreCountedAndTheLastRowMayBeCutOff) {
  const std::string event = "25\t\t\t\t\t\t\t\t\t\t\tKeyPress\t\t\t\t\t\t\r\n";
  const GazeLog log = parse(kHeader + row("0", kSeen, "640\t300", kScreen, "0") + event +
                            row("40", kSeen, "640\t301", kScreen, "40000") + "60\t600,5\t30");
  EXPECT_EQ(log.samples.size(), 2U);
  EXPECT_EQ(log.counters.eventRows, 1U);
  EXPECT_EQ(log.counters.truncatedRows, 1U);
}

TEST(TobiiStudio, PixelsAreOfTheScreenWhereAMediumShowsIt) {
  const GazeLog log = parse(kHeader + row("0", kSeen, "640\t300", "200\t100\t400\t200", "0") +
                            row("20", kSeen, "640\t300", kScreen, "20000") +
                            row("40", kSeen, "640\t300", "\t\t\t", "40000"));
  for (const GazeSample& sample : log.samples) expectPosition(sample, 0.64, 0.6);
}

TEST(TobiiStudio, PixelsAreOfTheMediumWhereNoneShowsTheScreen) {
  const GazeLog log = parse(kHeader + row("0", kSeen, "640\t250", "\t\t\t", "0") +
                            row("20", kSeen, "450\t250", "200\t100\t400\t200", "20000") +
                            row("40", kSeen, "650\t250", "100\t100\t600\t200", "40000"));
  EXPECT_FALSE(log.samples[0].valid);
  expectPosition(log.samples[1], 0.25, 0.5);
  expectPosition(log.samples[2], 0.5, 0.5);
  EXPECT_FALSE(log.coordinates.screenPixels.has_value());
  EXPECT_EQ(log.coordinates.of, "medium of each sample");
}

TEST(TobiiStudio, ScreenByASettingGoesBeforeTheMedia) {
  const GazeLog log =
      parse(kHeader + row("0", kSeen, "640\t300", kScreen, "0"), {.screen = "1280x600"});
  expectPosition(log.samples.at(0), 0.5, 0.5);
  EXPECT_EQ(log.coordinates.screenBy, "setting");
  // Nothing but the setting is needed then.
  expectPosition(parse(kHeader + row("0", kSeen, "640\t300", "\t\t\t", "0"), {.screen = "1280x600"})
                     .samples.at(0),
                 0.5, 0.5);
}

TEST(TobiiStudio, VersionThreeColumns) {
  const GazeLog log = parse(
      "RecordingTimestamp\tEyeTrackerTimestamp\tRecordingResolution\tValidityLeft\tValidityRight"
      "\tGazePointX (ADCSpx)\tGazePointY (ADCSpx)\n"
      "7\t1000100\t1000 x 500\t0\t0\t250\t100\n23\t1016767\t1000 x 500\t4\t4\t\t\n");
  expectPosition(log.samples.at(0), 0.25, 0.2);
  EXPECT_FALSE(log.samples.at(1).valid);
  EXPECT_EQ(log.samples.at(1).timeSeconds, 0.016667);
}

TEST(TobiiStudio, MilliSecondsWhereNoMicroSecondsAre) {
  const GazeLog log = parse(
      "Timestamp\tValidityLeft\tValidityRight\tGazePointX\tGazePointY\tMediaWidth\tMediaHeight\n"
      "100\t0\t0\t5\t5\t10\t10\n120,5\t0\t0\t6\t5\t10\t10\n");
  EXPECT_EQ(log.samples.at(1).timeSeconds, 0.0205);
}

TEST(TobiiStudio, MistakesAreNamedWithLineAndMend) {
  const std::string good = row("0", kSeen, "640\t300", kScreen, "0");
  const std::string bad = row("20", "1\t1\t4\t7\t1\t1\t4\t0", "640\t300", kScreen, "20000");
  EXPECT_EQ(errorOf(kHeader + good + bad + good),
            "log.csv: line 3: ValidityLeft is '7' instead of 0 to 4; export the log again");
  EXPECT_EQ(errorOf(kHeader + row("0", kSeen, "1\t1", kScreen, "1:00") + good),
            "log.csv: line 2: MicroSecondTimestamp is '1:00' instead of microseconds; export the "
            "log again");
  EXPECT_EQ(errorOf(kHeader + std::string("1\t2\r\n") + good),
            "log.csv: line 2: 2 cells under a header of 17; export the log again");
  EXPECT_EQ(errorOf(kHeader + row("0", kSeen, "640\t300", "\t\t\t", "0")),
            "log.csv: line 1: no row gives MediaWidth and MediaHeight; export them from Tobii "
            "Studio, or give --gaze.screen WIDTHxHEIGHT");
  EXPECT_EQ(errorOf("GazePointX\tGazePointY\n1\t1\n"),
            "log.csv: line 1: column 'ValidityLeft' is missing; export it too");
}

TEST(TobiiStudio, RealRecording) {
  const std::filesystem::path path =
      MACULA_SOURCE_DIR "/../shared/data/gaze/tobii_studio_50hz_decimal_comma.tsv";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
  const GazeLog log = readGazeLog(path);
  const GazeQuality quality = assess(log);
  EXPECT_EQ(log.format, "tobii-studio");
  EXPECT_EQ(quality.samples, 1231U);
  EXPECT_EQ(quality.lost, 23U);
  EXPECT_EQ(quality.offScreen, 129U);
  EXPECT_EQ(log.counters.eventRows, 6U);
  EXPECT_EQ(log.counters.truncatedRows, 0U);
  EXPECT_EQ(log.counters.duplicateTimes, 0U);
  EXPECT_EQ(log.counters.backwardTimes, 0U);
  EXPECT_EQ(log.counters.bothLost, 23U);
  EXPECT_EQ(log.coordinates.screenPixels, glm::dvec2(1280, 1024));
  EXPECT_EQ(log.coordinates.screenBy, "file");
  EXPECT_NEAR(quality.rateHz, 1e6 / 19923.0, 1e-6);
  EXPECT_DOUBLE_EQ(quality.durationSeconds, 24.573907 - 0.018138);
  // Eleven samples in a row are lost: about eleven intervals of 20 ms.
  EXPECT_NEAR(quality.longestDropoutSeconds, 0.22, 0.005);
  EXPECT_EQ(log.samples.front().position, glm::dvec2(640.0 / 1280.0, 269.0 / 1024.0));
  for (const GazeSample& sample : log.samples) {
    EXPECT_NE(sample.valid, std::isnan(sample.position.x));
  }
}

}  // namespace
}  // namespace macula::gaze
