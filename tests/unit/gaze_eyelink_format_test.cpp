// EyeLink ASC: blocks made by hand, and two real recordings.
#include "gaze_log_cases.h"

namespace macula::gaze {
namespace {

const std::string kHead =
    "** CONVERTED FROM a.edf\n** DATE: today\n\nMSG\t99 DISPLAY_COORDS 0 0 99 99\n"
    ">>>>>>> CALIBRATION (HV9,P-CR) FOR LEFT: <<<<<<<<<\n\t  -63     7   -44     4\n"
    "MSG\t100 GAZE_COORDS 0.00 0.00 999.00 499.00\n";

std::string block(const std::string& eyes, const std::string& rate = "1000.00") {
  return "START\t100 \t" + eyes + "\tSAMPLES\tEVENTS\nPRESCALER\t1\nPUPIL\tAREA\nEVENTS\tGAZE\t" +
         eyes + "\tRATE\t" + rate + "\nSAMPLES\tGAZE\t" + eyes + "\tRATE\t" + rate +
         "\tTRACKING\tCR\tFILTER\t2\n";
}

TEST(EyeLink, OneEyeWithBlinkAndSaccadeEvents) {
  const GazeLog log =
      parseLog(kHead + block("LEFT") +
               "100\t  250.0\t  100.0\t  300.0\t...\nSBLINK L 101\n101\t   .\t   .\t    0.0\t...\n"
               "SSACC L  101\nEBLINK L 101\t101\t1\nESACC L 101\t102\t2\t.\t.\t1\t1\t2.3e+06\t9\n"
               "102\t  500.0\t  250.0\t  300.0\t...\nINPUT\t102\t127\nEFIX L 1 2 3 4 5 6\nEND\t103 "
               "\tSAMPLES\n");
  EXPECT_EQ(log.format, "eyelink");
  ASSERT_EQ(log.samples.size(), 3U);
  expectPlace(log.samples[0], 0.25, 0.2);
  expectLost(log.samples[1]);
  expectPlace(log.samples[2], 0.5, 0.5);
  EXPECT_EQ(log.samples[2].timeSeconds, 0.002);
  EXPECT_EQ(log.startSeconds, 0.1);
  EXPECT_EQ(log.counters.blinks, 1U);
  EXPECT_EQ(log.counters.saccades, 1U);
  EXPECT_EQ(log.counters.blocks, 1U);
  EXPECT_EQ(log.counters.twoEyeSamples, 0U);
  EXPECT_FALSE(log.samples[0].pupilMillimetres.has_value());  // in the tracker's own units
  EXPECT_EQ(log.coordinates.screenPixels, glm::dvec2(1000, 500));
  EXPECT_EQ(log.coordinates.screenBy, "file");
}

TEST(EyeLink, BothEyesAreAveragedWhereBothAreSeen) {
  const GazeLog log = parseLog(kHead + block("LEFT\tRIGHT") +
                               "100\t200.0\t100.0\t300\t400.0\t300.0\t300\t.....\n"
                               "101\t.\t.\t0.0\t400.0\t300.0\t300\t.C...\n"
                               "102\t200.0\t100.0\t300\t.\t.\t0.0\t.....\n"
                               "103\t.\t.\t0.0\t.\t.\t0.0\t.....\n");
  ASSERT_EQ(log.samples.size(), 4U);
  expectPlace(log.samples[0], 0.3, 0.4);
  expectPlace(log.samples[1], 0.4, 0.6);
  expectPlace(log.samples[2], 0.2, 0.2);
  expectLost(log.samples[3]);
  EXPECT_EQ(log.counters.leftLost, 2U);
  EXPECT_EQ(log.counters.rightLost, 2U);
  EXPECT_EQ(log.counters.bothLost, 1U);
}

TEST(EyeLink, RemoteModeHasATargetBehindTheGaze) {
  const GazeLog log =
      parseLog(kHead + block("RIGHT") +
               "100\t  250.0\t  100.0\t  300.0\t...\t -1860.0\t 1070.0\t  553.1\t.............\n");
  expectPlace(log.samples.at(0), 0.25, 0.2);
}

TEST(EyeLink, BlocksMayHaveOtherEyesAndLieFarApart) {
  const GazeLog log =
      parseLog(kHead + block("LEFT") + "100\t250\t100\t1\t...\nEND\t101\n" + block("LEFT\tRIGHT") +
               "900000\t200\t100\t1\t400\t300\t1\t.....\nEND\t900001\n");
  expectPlace(log.samples.at(0), 0.25, 0.2);
  expectPlace(log.samples.at(1), 0.3, 0.4);
  EXPECT_EQ(log.counters.blocks, 2U);
  EXPECT_EQ(log.counters.gaps, 1U);
  EXPECT_EQ(log.counters.twoEyeSamples, 1U);
}

TEST(EyeLink, HalfMillisecondsAndWholeOnesTwiceAtTwoKilohertz) {
  const GazeLog written =
      parseLog(kHead + block("LEFT", "2000.00") +
               "100.0\t1\t1\t1\t...\n100.5\t1\t2\t1\t...\n101.0\t1\t3\t1\t...\n");
  EXPECT_EQ(written.samples.at(1).timeSeconds, 0.0005);
  EXPECT_EQ(written.samples.at(2).timeSeconds, 0.001);
  const std::string twice =
      "100\t1\t1\t1\t...\n100\t1\t2\t1\t...\n101\t1\t3\t1\t...\n101\t1\t4\t1\t...\n";
  const GazeLog whole = parseLog(kHead + block("LEFT", "2000.00") + twice);
  EXPECT_EQ(whole.samples.at(1).timeSeconds, 0.0005);
  EXPECT_EQ(whole.samples.at(3).timeSeconds, 0.0015);
  EXPECT_EQ(whole.counters.duplicateTimes, 0U);
  // At any other rate a time that stands twice is a mistake of the recording.
  EXPECT_EQ(parseLog(kHead + block("LEFT") + twice).counters.duplicateTimes, 2U);
}

TEST(EyeLink, OddCornersAreTheLastPixelAndEvenOnesTheSize) {
  const std::string sample = block("LEFT") + "100\t960\t540\t1\t...\n";
  for (const char* const corners :
       {"0 0 1919 1079", "0.00 0.00 1920.00 1080.00", "= 0, 0, 1919, 1079"}) {
    const GazeLog log = parseLog("MSG\t1 GAZE_COORDS " + std::string(corners) + "\n" + sample);
    EXPECT_EQ(log.coordinates.screenPixels, glm::dvec2(1920, 1080)) << corners;
    expectPlace(log.samples.at(0), 0.5, 0.5);
  }
  const GazeLog moved = parseLog("MSG\t1 GAZE_COORDS -960 -540 959 539\n" + sample);
  expectPlace(moved.samples.at(0), 1.0, 1.0);
}

TEST(EyeLink, MistakesAreNamedWithLineAndMend) {
  const std::string end = "101\t1\t1\t1\t...\n";
  EXPECT_EQ(errorOfLog("** CONVERTED\n" + block("LEFT") + "100\t1\t1\t1\t...\n" + end),
            "log.csv: line 7: pixels of a screen whose size is not said; give --gaze.screen "
            "WIDTHxHEIGHT; no GAZE_COORDS or DISPLAY_COORDS stands before it");
  EXPECT_EQ(errorOfLog(kHead + "100\t1\t1\t1\t...\n" + end),
            "log.csv: line 8: a sample before START and SAMPLES say which eyes; convert the EDF "
            "with them");
  EXPECT_EQ(errorOfLog(kHead + "SAMPLES\tHREF\tLEFT\n" + end),
            "log.csv: line 8: samples are HREF instead of GAZE; convert the EDF with gaze samples");
  EXPECT_EQ(errorOfLog(kHead + block("LEFT") + "100\tx\t1\t1\t...\n" + end),
            "log.csv: line 13: 'x' instead of a coordinate; convert the EDF again");
  EXPECT_EQ(errorOfLog(kHead + block("LEFT\tRIGHT") + "100\t1\t1\t1\t...\n" + end),
            "log.csv: line 13: 5 numbers instead of 7 of both eyes; convert the EDF again");
  EXPECT_EQ(parseLog(kHead + block("LEFT") + end + "102\t1\t").counters.truncatedRows, 1U);
}

TEST(EyeLink, SettingsSayWhatTheFileDoesNot) {
  const GazeLog log = parseLog("** CONVERTED\n" + block("LEFT") + "100\t0\t-100\t1\t...\n",
                               {.origin = GazeOrigin::CentreUp, .screen = "1000x500"});
  expectPlace(log.samples.at(0), 0.5, 0.7);
  EXPECT_EQ(describe(log.coordinates),
            "px (format), origin centre, y up (setting), of the screen 1000x500 (setting)");
}

TEST(EyeLink, RealRecordingOfBothEyes) {
  MACULA_RECORDING(path, "eyelink_bino_1000hz_blinks.asc");
  const GazeLog log = readGazeLog(path);
  const GazeQuality quality = assess(log);
  EXPECT_EQ(log.format, "eyelink");
  EXPECT_EQ(quality.samples, 368U);
  EXPECT_EQ(log.counters.leftLost, 97U);
  EXPECT_EQ(log.counters.rightLost, 80U);
  EXPECT_EQ(log.counters.bothLost, 80U);
  EXPECT_EQ(quality.lost, 80U);
  EXPECT_EQ(log.counters.blinks, 2U);
  EXPECT_EQ(log.coordinates.screenPixels, glm::dvec2(1920, 1080));
  EXPECT_NEAR(quality.rateHz, 1000.0, 1e-9);
}

TEST(EyeLink, RealRecordingOfOneEyeWithAHole) {
  MACULA_RECORDING(path, "eyelink_mono_500hz_long_blink.asc");
  const GazeLog log = readGazeLog(path);
  const GazeQuality quality = assess(log);
  EXPECT_EQ(quality.samples, 297U);
  EXPECT_EQ(quality.lost, 69U);
  EXPECT_EQ(log.coordinates.screenPixels, glm::dvec2(1920, 1080));
  EXPECT_GT(quality.longestDropoutSeconds, 4.58);
  EXPECT_LT(quality.longestDropoutSeconds, 4.65);
  EXPECT_GE(log.counters.gaps, 1U);
  EXPECT_NEAR(quality.rateHz, 500.0, 1e-9);
}

}  // namespace
}  // namespace macula::gaze
