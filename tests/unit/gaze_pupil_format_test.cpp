// Pupil Core, Pupil Neon and Invisible: rows made by hand.
#include <algorithm>

#include "gaze_log_cases.h"

namespace macula::gaze {
namespace {

TEST(PupilCore, NewHeaderBeginsAtTheBottomLeftOfTheSceneCamera) {
  const GazeLog log = parseLog(
      "gaze_timestamp,world_index,confidence,norm_pos_x,norm_pos_y,base_data,gaze_point_3d_x\n"
      "3017.25,0,0.98,0.25,0.9,3017.24-0 3017.26-1,1.5\n3017.258333333,0,0.59,0.5,0.5,,\n"
      "3017.266666667,0,0.6,1.1,-0.1,,\n");
  EXPECT_EQ(log.format, "pupil-core");
  ASSERT_EQ(log.samples.size(), 3U);
  expectPlace(log.samples[0], 0.25, 0.1);
  EXPECT_FLOAT_EQ(log.samples[0].confidence.value(), 0.98F);
  expectLost(log.samples[1]);
  EXPECT_FLOAT_EQ(log.samples[1].confidence.value(), 0.59F);
  expectPlace(log.samples[2], 1.1, 1.1);
  EXPECT_EQ(log.samples[2].timeSeconds, 0.016666667);
  EXPECT_EQ(describe(log.coordinates),
            "0..1 (format), origin bottom left (format), of the scene camera");
}

TEST(PupilCore, OldHeaderAndItsOwnConfidence) {
  const std::string text =
      "timestamp,index,confidence,norm_pos_x,norm_pos_y,base\n1.5,0,0.5,0.5,0.75,\n2,0,0.2,0.5,0."
      "75,\n";
  expectLost(parseLog(text).samples.at(0));
  const GazeLog trusting = parseLog(text, {.minConfidence = 0.3});
  expectPlace(trusting.samples.at(0), 0.5, 0.25);
  expectLost(trusting.samples.at(1));
}

TEST(PupilCore, SurfaceAndPupilPositions) {
  const GazeLog log = parseLog(
      "world_timestamp,world_index,gaze_timestamp,x_norm,y_norm,x_scaled,y_scaled,on_surf,"
      "confidence\n"
      "1,0,1.5,0.25,0.75,1,1,True,1.0\n");
  expectPlace(log.samples.at(0), 0.25, 0.25);
  EXPECT_EQ(log.coordinates.of, "surface");
  EXPECT_EQ(
      errorOfLog("timestamp,index,eye_id,confidence,norm_pos_x,norm_pos_y\n1,0,0,1,0.5,0.5\n"),
      "log.csv: line 1: positions of pupils, not of gaze; give gaze_positions.csv");
}

TEST(PupilCore, ZeroIsNoPlaceAndMistakesAreNamed) {
  const std::string head = "gaze_timestamp,world_index,confidence,norm_pos_x,norm_pos_y\n";
  const GazeLog log = parseLog(head + "1,0,0.9,0.0,0.0\n1.1,0,0.9,nan,0.5\n");
  expectLost(log.samples.at(0));
  expectLost(log.samples.at(1));
  EXPECT_EQ(log.counters.sentinels, 1U);
  EXPECT_EQ(errorOfLog(head + "1,0,1.5,0.5,0.5\n2,0,1,0.5,0.5\n"),
            "log.csv: line 2: confidence is '1.5' instead of 0..1; export the log again");
}

const std::string kNeon =
    "section id,recording id,timestamp [ns],gaze x [px],gaze y [px],worn,fixation id,blink id\n";

std::string neonRow(const std::string& time, const std::string& rest) {
  return "s,r," + time + "," + rest + "\n";
}

TEST(PupilNeon, NanosecondsSince1970KeepEveryDigit) {
  const GazeLog log = parseLog(kNeon + neonRow("1700000000000000001", "800,300,True,,") +
                                   neonRow("1700000000005000002", "400,600,1,7,") +
                                   neonRow("1700000000010000003", "400,600,False,,") +
                                   neonRow("1700000000015000004", "400,600,True,,3") +
                                   neonRow("1700000000020000005", "400,600,True,,3") +
                                   neonRow("1700000000025000006", "400,600,True,,4"),
                               {.screen = "1600x1200"});
  EXPECT_EQ(log.format, "pupil-neon");
  ASSERT_EQ(log.samples.size(), 6U);
  expectPlace(log.samples[0], 0.5, 0.25);
  EXPECT_EQ(log.samples[1].timeSeconds, 0.005000001);
  for (const std::size_t lost : {2U, 3U, 4U, 5U}) {
    expectLost(log.samples[lost]);
    EXPECT_EQ(log.samples[lost].position, glm::dvec2(0.25, 0.5));  // kept as the file has it
  }
  EXPECT_EQ(log.counters.blinks, 2U);
  EXPECT_EQ(describe(log.coordinates),
            "px (file), origin top left (format), of the scene camera 1600x1200 (setting)");
}

TEST(PupilNeon, SizeOfTheSceneCameraIsAskedFor) {
  EXPECT_EQ(errorOfLog(kNeon + neonRow("1700000000000000001", "800,300,True,,")),
            "log.csv: line 2: pixels of a scene camera whose size is not said; give --gaze.screen "
            "WIDTHxHEIGHT (Neon: 1600x1200, Invisible: 1088x1080)");
  EXPECT_EQ(errorOfLog(kNeon, {.screen = "1600*1200"}),
            "gaze.screen '1600*1200': write WIDTHxHEIGHT in pixels, for example 1920x1080");
}

TEST(PupilNeon, SemicolonsAndDecimalCommasOfASpreadsheet) {
  std::string header = kNeon;
  std::replace(header.begin(), header.end(), ',', ';');
  const GazeLog log = parseLog(header + "s;r;1700000000000000001;800,5;300,25;True;1;\n" +
                                   "s;r;1700000000005000001;400;600;False;1;\n",
                               {.screen = "1600x1200"});
  ASSERT_EQ(log.samples.size(), 2U);
  expectPlace(log.samples[0], 800.5 / 1600.0, 300.25 / 1200.0);
  EXPECT_EQ(log.samples[1].timeSeconds, 0.005);
  expectLost(log.samples[1]);
}

TEST(PupilNeon, TimesThatASpreadsheetRoundedAreRefused) {
  const auto refused = [](const std::string& time) {
    std::string text = kNeon;
    for (int i = 0; i < 3; ++i) text += neonRow(time, "800,300,True,,");
    return errorOfLog(text, {.screen = "1600x1200"});
  };
  const std::string why =
      ": a spreadsheet has rounded the times; give the file as the tracker's program exported it";
  // Thirteen digits are missing: seen in the first row. Six: only when times come twice.
  EXPECT_EQ(refused("1.65451E+18"), "log.csv: line 2: timestamp [ns] is '1.65451E+18'" + why);
  EXPECT_EQ(refused("1.654510000001e+18"),
            "log.csv: line 3: timestamp [ns] is '1.654510000001e+18'" + why);
  // As programs write doubles: every digit is there.
  EXPECT_EQ(refused("1.700000000000000256e+18"), "no error");
}

TEST(PupilNeon, OffASurfaceTheCoordinatesAreKeptAndTheSampleIsLost) {
  const GazeLog log = parseLog(
      "section id,recording id,timestamp [ns],gaze detected on surface,"
      "gaze position on surface x [normalized],gaze position on surface y [normalized]\n"
      "s,r,1,True,0.25,0.75\ns,r,5000001,False,1.5,0.5\ns,r,10000001,false,,\n");
  ASSERT_EQ(log.samples.size(), 3U);
  expectPlace(log.samples[0], 0.25, 0.75);
  expectLost(log.samples[1]);
  EXPECT_EQ(log.samples[1].position, glm::dvec2(1.5, 0.5));
  expectLost(log.samples[2]);
  EXPECT_EQ(log.coordinates.of, "surface");
}

}  // namespace
}  // namespace macula::gaze
