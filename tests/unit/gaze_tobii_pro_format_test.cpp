// Tobii Pro Lab exports and dumps of the Tobii Pro SDK: rows made by hand, and a real recording.
#include "gaze_log_cases.h"

namespace macula::gaze {
namespace {

const std::string kLab =
    "Recording timestamp [ms]\tSensor\tRecording resolution height\tRecording resolution width\t"
    "Event\tGaze point X [DACS px]\tGaze point Y [DACS px]\tGaze point left X [DACS px]\t"
    "Gaze point left Y [DACS px]\tGaze point right X [DACS px]\tGaze point right Y [DACS px]\t"
    "Pupil diameter left [mm]\tPupil diameter right [mm]\tValidity left\tValidity right\t"
    "Eye movement type\r\n";

std::string labRow(const std::string& time, const std::string& gaze, const std::string& pupils,
                   const std::string& validity, const std::string& type = "Fixation") {
  return time + "\tEye Tracker\t500\t1000\t\t" + gaze + "\t" + pupils + "\t" + validity + "\t" +
         type + "\r\n";
}

TEST(TobiiProLab, BothEyesOneEyeAndNone) {
  const GazeLog log =
      parseLog(kLab + labRow("10", "300\t200\t200\t100\t400\t300", "3,5\t4,5", "Valid\tValid") +
               "15\t\t500\t1000\tKeyboardEvent\t\t\t\t\t\t\t\t\t\t\t\r\n" +
               "16\tMouse\t500\t1000\t\t\t\t\t\t\t\t\t\t\t\t\r\n" +
               labRow("26,5", "\t\t200\t100\t400\t300", "\t", "Valid\tValid") +
               labRow("43", "\t\t\t\t400\t300", "\t4,5", "Invalid\tValid") +
               labRow("60", "\t\t\t\t\t", "\t", "Invalid\tInvalid", "EyesNotFound"));
  EXPECT_EQ(log.format, "tobii-pro-lab");
  ASSERT_EQ(log.samples.size(), 4U);
  expectPlace(log.samples[0], 0.3, 0.4);
  EXPECT_FLOAT_EQ(log.samples[0].pupilMillimetres.value(), 4.0F);
  expectPlace(log.samples[1], 0.3, 0.4);  // the mean of the eyes
  expectPlace(log.samples[2], 0.4, 0.6);
  expectLost(log.samples[3]);
  EXPECT_EQ(log.samples[1].timeSeconds, 0.0165);
  EXPECT_EQ(log.counters.eventRows, 2U);
  EXPECT_EQ(log.counters.leftLost, 2U);
  EXPECT_EQ(log.counters.rightLost, 1U);
  EXPECT_EQ(log.counters.bothLost, 1U);
  EXPECT_EQ(describe(log.coordinates),
            "px (file), origin top left (format), of the screen 1000x500 (file)");
}

TEST(TobiiProLab, TimesInMicrosecondsAndWithoutAUnit) {
  const std::string row =
      "1000000\tEye Tracker\t500\t1000\t\t300\t200\t\t\t\t\t\t\tValid\tValid\t\n"
      "1016667\tEye Tracker\t500\t1000\t\t300\t200\t\t\t\t\t\t\tValid\tValid\t\n";
  const std::string rest = kLab.substr(kLab.find("\tSensor"));
  for (const char* const name : {"Recording timestamp [\xCE\xBCs]", "Recording timestamp [us]"}) {
    EXPECT_EQ(parseLog(name + rest + row).samples.at(1).timeSeconds, 0.016667) << name;
  }
  EXPECT_EQ(errorOfLog("Recording timestamp" + rest + row),
            "log.csv: line 1: 'Recording timestamp' has no unit; give --gaze.timeUnit ms or us");
  EXPECT_EQ(parseLog("Recording timestamp" + rest + row, {.timeUnit = TimeUnit::Microseconds})
                .samples.at(1)
                .timeSeconds,
            0.016667);
}

TEST(TobiiProLab, ScreenIsAskedForWhereTheFileDoesNotSayIt) {
  const std::string text =
      "Recording timestamp [ms]\tGaze point X [DACS px]\tGaze point Y [DACS px]\tValidity left\t"
      "Validity right\n1\t500\t250\tValid\tValid\n2\t500\t250\tValid\tValid\n";
  EXPECT_EQ(errorOfLog(text),
            "log.csv: line 2: pixels of a screen whose size is not said; give --gaze.screen "
            "WIDTHxHEIGHT");
  expectPlace(parseLog(text, {.screen = "1000x1000"}).samples.at(0), 0.5, 0.25);
}

TEST(TobiiProLab, GlassesGivePixelsOfTheirSceneCamera) {
  const std::string suffixed =
      "Recording timestamp [ms]\tSensor\tGaze point X [MCS px]\tGaze point Y [MCS px]\t"
      "Recording media width [px]\tRecording media height [px]\n";
  const std::string old =
      "Recording timestamp\tSensor\tGaze point X\tGaze point Y\tRecording media width\t"
      "Recording media height\n";
  const std::string rows =
      "5\tGyroscope\t\t\t1920\t1080\n20\tEye Tracker\t480\t540\t1920\t1080\n40\tEye "
      "Tracker\t\t\t1920\t1080\n";
  for (const std::string& header : {suffixed, old}) {
    const GazeLog log = parseLog(header + rows, {.timeUnit = TimeUnit::Milliseconds});
    ASSERT_EQ(log.samples.size(), 2U);
    expectPlace(log.samples[0], 0.25, 0.5);
    expectLost(log.samples[1]);
    EXPECT_TRUE(isOfSceneCamera(log.coordinates)) << describe(log.coordinates);
    EXPECT_EQ(log.coordinates.screenPixels, glm::dvec2(1920, 1080));
    // A size by a setting does not make the camera a screen.
    EXPECT_TRUE(isOfSceneCamera(
        parseLog(header + rows, {.timeUnit = TimeUnit::Milliseconds, .screen = "960x540"})
            .coordinates));
  }
  EXPECT_EQ(errorOfLog(old + rows),
            "log.csv: line 1: 'Recording timestamp' has no unit; give --gaze.timeUnit ms or us");
  const std::string noSize =
      "Recording timestamp [ms]\tSensor\tGaze point X [MCS px]\t"
      "Gaze point Y [MCS px]\n20\tEye Tracker\t480\t540\n";
  EXPECT_EQ(errorOfLog(noSize),
            "log.csv: line 2: pixels of a medium whose size is not said; give --gaze.screen "
            "WIDTHxHEIGHT");
  expectPlace(parseLog(noSize, {.screen = "1920x1080"}).samples.at(0), 0.25, 0.5);
  EXPECT_EQ(errorOfLog("Recording timestamp [ms]\tSensor\tFixation point X\n1\tEye Tracker\t5\n"),
            "log.csv: line 1: column 'Gaze point X' is missing; export it too");
}

TEST(TobiiProLab, OldNamesBesideAResolutionAreOfTheScreen) {
  const GazeLog log = parseLog(
      "Recording timestamp [ms]\tSensor\tGaze point X\tGaze point Y\tRecording resolution width\t"
      "Recording resolution height\tRecording media width\tRecording media height\n"
      "20\tEye Tracker\t480\t540\t1920\t1080\t800\t600\n");
  expectPlace(log.samples.at(0), 0.25, 0.5);
  EXPECT_EQ(log.coordinates.of, "screen");
}

TEST(TobiiProLab, SentinelsThatAreCalledValid) {
  const GazeLog log = parseLog(kLab + labRow("10", "0\t0\t0\t0\t0\t0", "\t", "Valid\tValid") +
                               labRow("26", "\t\t-1280\t-1280\t400\t300", "\t", "Valid\tValid"));
  expectLost(log.samples.at(0));
  expectPlace(log.samples.at(1), 0.4, 0.6);
  EXPECT_EQ(log.counters.sentinels, 3U);
}

const std::string kSdk =
    "left_gaze_point_on_display_area;left_gaze_point_validity;left_pupil_diameter;"
    "right_gaze_point_on_display_area;right_gaze_point_validity;right_pupil_diameter;"
    "device_time_stamp;system_time_stamp\r\r\n";

TEST(TobiiSdk, TuplesBothEyesAndNan) {
  const GazeLog log = parseLog(kSdk +
                               "(0.2, 0.2);1;3.0;(0.4, 0.6);1;4.0;1000000;1.56466617033e+15\r\r\n"
                               "(nan, nan);0;nan;(0.4, 0.6);1;4.0;1011111;1.56466617034e+15\r\r\n"
                               "(nan, nan);0;nan;(nan, nan);0;nan;1022222;1.56466617035e+15\r\r\n"
                               "(0.0, 0.0);1;3.0;(nan, nan);0;nan;1033333;1.56466617035e+15\r\r\n"
                               "(0.2, 0.2);1;3.0;(0.4");
  EXPECT_EQ(log.format, "tobii-sdk");
  ASSERT_EQ(log.samples.size(), 4U);
  expectPlace(log.samples[0], 0.3, 0.4);
  EXPECT_FLOAT_EQ(log.samples[0].pupilMillimetres.value(), 3.5F);
  expectPlace(log.samples[1], 0.4, 0.6);
  expectLost(log.samples[2]);
  expectLost(log.samples[3]);
  EXPECT_EQ(log.samples[1].timeSeconds, 0.011111);
  EXPECT_EQ(log.counters.sentinels, 1U);
  EXPECT_EQ(log.counters.truncatedRows, 1U);
}

TEST(TobiiSdk, QuotedTuplesBetweenCommasAndSplitColumns) {
  const GazeLog quoted = parseLog(
      "device_time_stamp,left_gaze_point_on_display_area,left_gaze_point_validity,"
      "right_gaze_point_on_display_area,right_gaze_point_validity\n"
      "10,\"(0.2, 0.2)\",1,\"(0.4, 0.6)\",1\n");
  expectPlace(quoted.samples.at(0), 0.3, 0.4);
  const GazeLog split = parseLog(
      "device_time_stamp,left_gaze_point_on_display_area_x,left_gaze_point_on_display_area_y,"
      "left_gaze_point_validity,right_gaze_point_on_display_area_x,"
      "right_gaze_point_on_display_area_y,right_gaze_point_validity\n10,0.2,0.2,1,0.4,0.6,1\n");
  expectPlace(split.samples.at(0), 0.3, 0.4);
}

TEST(TobiiSdk, MistakesAreNamed) {
  const std::string good = "(0.2, 0.2);1;3.0;(0.4, 0.6);1;4.0;1000000;1\n";
  EXPECT_EQ(errorOfLog(kSdk + "(0.2, 0.2);2;3.0;(0.4, 0.6);1;4.0;1000000;1\n" + good),
            "log.csv: line 2: left_gaze_point_validity is '2' instead of 0 or 1; export the log "
            "again");
  EXPECT_EQ(errorOfLog(kSdk + "(0.2, 0.2);1;3.0;x;1;4.0;1000000;1\n" + good),
            "log.csv: line 2: right_gaze_point_on_display_area is 'x' instead of (x, y); export "
            "the log again");
}

TEST(TobiiSdk, RealRecording) {
  MACULA_RECORDING(path, "tobii4c_prosdk_semicolon.csv");
  const GazeLog log = readGazeLog(path);
  const GazeQuality quality = assess(log);
  EXPECT_EQ(log.format, "tobii-sdk");
  EXPECT_EQ(quality.samples, 453U);
  EXPECT_EQ(log.counters.truncatedRows, 1U);
  EXPECT_EQ(log.counters.leftLost, 5U);
  EXPECT_EQ(log.counters.rightLost, 38U);
  EXPECT_EQ(log.counters.bothLost, 1U);
  EXPECT_EQ(quality.lost, 1U);
  EXPECT_NEAR(quality.rateHz, 90.0, 0.1);
}

}  // namespace
}  // namespace macula::gaze
