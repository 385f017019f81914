// Gazepoint's all_gaze CSV and GazeBase: rows made by hand, and a real excerpt.
#include "gaze_log_cases.h"

namespace macula::gaze {
namespace {

const std::string kHead =
    "MEDIA_ID,MEDIA_NAME,CNT,TIME(2022/01/27 09:39:32.995),TIMETICK(f=10000000),FPOGX,FPOGY,FPOGV,"
    "BPOGX,BPOGY,BPOGV,LPV,RPV,BKID,LPMM,LPMMV,RPMM,RPMMV,\n";

TEST(Gazepoint, TicksGoOnWhereTheTimeRestarts) {
  const GazeLog log = parseLog(kHead +
                               "0,a,1,0.5,700000000000,0.1,0.1,1,0.25,0.5,1,1,1,0,3.5,1,4.5,1,\n"
                               "0,a,2,0.516,700000166667,0.1,0.1,1,0.75,0.5,1,1,0,0,3.5,1,9,0,\n"
                               "1,b,3,0.0,700000333334,0.1,0.1,1,0.5,0.25,1,0,1,0,3.5,1,4.5,1,\n");
  EXPECT_EQ(log.format, "gazepoint");
  ASSERT_EQ(log.samples.size(), 3U);
  expectPlace(log.samples[0], 0.25, 0.5);  // of the sample, not of the tracker's fixation
  EXPECT_FLOAT_EQ(log.samples[0].pupilMillimetres.value(), 4.0F);
  EXPECT_FLOAT_EQ(log.samples[1].pupilMillimetres.value(), 3.5F);
  EXPECT_EQ(log.samples[2].timeSeconds, 0.0333334);
  EXPECT_EQ(log.counters.backwardTimes, 0U);
  EXPECT_EQ(log.counters.clockRestarts, 0U);
  EXPECT_EQ(log.counters.leftLost, 1U);
  EXPECT_EQ(log.counters.rightLost, 1U);
}

TEST(Gazepoint, WithoutTicksTheTimeIsCarriedOnAtANewMedium) {
  const std::string head = "MEDIA_ID,TIME,BPOGX,BPOGY,BPOGV\n";
  const GazeLog log = parseLog(
      head +
      "0,1.5,0.5,0.5,1\n0,1.516,0.5,0.5,1\n1,0,0.5,0.5,1\n1,0.016,0.5,0.5,1\n1,0.01,0.5,0.5,1\n");
  ASSERT_EQ(log.samples.size(), 5U);
  EXPECT_EQ(log.samples[2].timeSeconds, 0.032);
  EXPECT_EQ(log.samples[3].timeSeconds, 0.048);
  EXPECT_EQ(log.counters.clockRestarts, 1U);
  EXPECT_EQ(log.counters.backwardTimes, 1U);  // the same medium: the file's mistake
  ASSERT_FALSE(log.notes.empty());
  EXPECT_NE(log.notes.back().find("carried on"), std::string::npos);
}

TEST(Gazepoint, LossFreezesTheLastPlace) {
  std::string text = "MEDIA_ID,TIMETICK(f=1000),BPOGX,BPOGY,BPOGV,BKID\n0,0,0.25,0.5,1,0\n";
  for (int ms = 16; ms <= 160; ms += 16) {
    text += "0," + std::to_string(ms) + ",0.75,0.5,0," + (ms < 100 ? "1" : "0") + "\n";
  }
  const GazeLog log = parseLog(text);
  const GazeQuality quality = assess(log);
  EXPECT_EQ(quality.samples, 11U);
  EXPECT_EQ(quality.lost, 10U);
  EXPECT_EQ(quality.frozenRuns, 1U);
  EXPECT_EQ(log.counters.blinks, 1U);
  EXPECT_EQ(log.samples[5].position, glm::dvec2(0.75, 0.5));
}

TEST(Gazepoint, TheTrackersFixationFilterIsNamed) {
  const GazeLog log = parseLog("TIME,FPOGX,FPOGY,FPOGV\n0,0.5,0.5,1\n");
  expectPlace(log.samples.at(0), 0.5, 0.5);
  ASSERT_FALSE(log.notes.empty());
  EXPECT_NE(log.notes[0].find("fixation filter"), std::string::npos);
}

TEST(Gazepoint, MistakesAreNamed) {
  const std::string good = "1,0.5,0.5,1\n";
  const std::string head = "TIMETICK(f=10000000),BPOGX,BPOGY,BPOGV\n";
  EXPECT_EQ(errorOfLog(head + "1,0.5,0.5,x\n" + good),
            "log.csv: line 2: BPOGV is 'x' instead of 0 or 1; export the log again");
  EXPECT_EQ(errorOfLog("TIMETICK,BPOGX,BPOGY,BPOGV\n" + good),
            "log.csv: line 1: 'TIMETICK' has no frequency; export TIMETICK(f=10000000)");
  EXPECT_EQ(errorOfLog("TIME,BPOGX,BPOGY\n" + good),
            "log.csv: line 1: column 'BPOGV' is missing; export it too");
}

TEST(GazeBase, DegreesFromTheCentreUpwards) {
  const GazeLog log = parseLog(
      "n,x,y,val,dP,lab,xT,yT\n0,0,0,0,3198,0,NaN,NaN\n1,10,5,0,3198,0,1,1\n2,NaN,NaN,1,0,0,1,1\n"
      "3,10,5,4,0,0,1,1\n",
      {.display = {.widthMm = 500.0, .heightMm = 250.0, .distanceMm = 1000.0}});
  EXPECT_EQ(log.format, "gazebase");
  ASSERT_EQ(log.samples.size(), 4U);
  expectPlace(log.samples[0], 0.5, 0.5);  // the middle is a place, not a sentinel
  // 1000 mm tan(10 deg) = 176.327 mm of 500; 1000 mm tan(5 deg) = 87.4887 mm of 250, upwards.
  EXPECT_NEAR(log.samples[1].position.x, 0.5 + 176.3269807 / 500.0, 1e-9);
  EXPECT_NEAR(log.samples[1].position.y, 0.5 - 87.4886635 / 250.0, 1e-9);
  expectLost(log.samples[2]);
  expectLost(log.samples[3]);
  EXPECT_EQ(describe(log.coordinates),
            "deg (format), origin centre, y up (format), of the screen; degrees mapped by "
            "a display of 500x250 mm (assumed) at 1000 mm (assumed)");
}

TEST(GazeBase, OriginByASetting) {
  const std::string text = "n,x,y,val\n0,0,5,0\n";
  EXPECT_LT(parseLog(text).samples.at(0).position.y, 0.5);
  EXPECT_GT(parseLog(text, {.origin = GazeOrigin::Centre}).samples.at(0).position.y, 0.5);
  EXPECT_EQ(errorOfLog(text, {.origin = GazeOrigin::TopLeft}),
            "log.csv: line 1: degrees begin at the centre; give --gaze.origin centre or centre-up");
}

TEST(GazeBase, RealExcerpt) {
  MACULA_RECORDING(path, "gazebase_example_10rows.csv");
  const GazeLog log = readGazeLog(path);
  EXPECT_EQ(log.format, "gazebase");
  EXPECT_EQ(log.samples.size(), 10U);
  EXPECT_EQ(assess(log).lost, 0U);
  EXPECT_NEAR(assess(log).rateHz, 1000.0, 1e-9);
}

}  // namespace
}  // namespace macula::gaze
