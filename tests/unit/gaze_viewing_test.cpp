// What degrees rest on: the display by settings, files or assumption, and logs that have none.
#include <filesystem>

#include "engine/core/file.h"
#include "engine/gaze/canonical_csv.h"
#include "engine/gaze/point_error.h"
#include "engine/gaze/viewing.h"
#include "gaze_log_cases.h"
#include "temporary_path.h"

namespace macula::gaze {
namespace {

const std::string kCore = "gaze_timestamp,confidence,norm_pos_x,norm_pos_y\n1,1,0.25,0.75\n";
const std::string kStudio =
    "Timestamp\tValidityLeft\tValidityRight\tGazePointX\tGazePointY\tDistanceLeft\t"
    "DistanceRight\tRecordingResolution\n";

std::string displayOf(const std::string& text, const LogOptions& options = {},
                      const std::string& sidecar = {}) {
  return describe(viewingOf(parseLog(text, options, sidecar), options).display);
}

TEST(GazeViewing, SettingsGoBeforeTheFileAndTheFileBeforeTheDefault) {
  const std::string rows =
      "0\t0\t0\t9\t9\t600\t610\t1600 x 900\n20\t4\t0\t9\t9\t-1\t620\t1600 x 900\n";
  EXPECT_EQ(displayOf(kCore), "597x336 mm (assumed) at 750 mm (assumed)");
  // Of the eyes that were seen: 600, 610 and 620 mm.
  EXPECT_EQ(displayOf(kStudio + rows), "597x336 mm (assumed) at 610 mm (file)");
  LogOptions options;
  settings::Registry registry;
  registerSettings(registry, options.display);
  registry.setText("display.distanceMm", "750", "test");  // the default, but said
  EXPECT_EQ(displayOf(kStudio + rows, options), "597x336 mm (assumed) at 750 mm (setting)");
  registry.setText("display.widthMm", "320", "test");
  EXPECT_EQ(displayOf(kCore, options), "320x336 mm (setting) at 750 mm (setting)");
}

TEST(GazeViewing, DistancesAndSizesOfOtherFormats) {
  EXPECT_EQ(displayOf("device_time_stamp;left_gaze_point_on_display_area;left_gaze_point_validity;"
                      "right_gaze_point_on_display_area;right_gaze_point_validity;"
                      "left_gaze_origin_in_user_coordinate_system\n"
                      "1;(0.2, 0.2);1;(0.2, 0.2);1;(1.5, 2.5, 640.0)\n"),
            "597x336 mm (assumed) at 640 mm (file)");
  EXPECT_EQ(displayOf("TIME,BPOGX,BPOGY,BPOGV,LEYEZ,REYEZ\n0,0.5,0.4,1,0.6,0.64\n"),
            "597x336 mm (assumed) at 620 mm (file)");
  EXPECT_EQ(displayOf("Recording timestamp [ms]\tSensor\tGaze point X [DACS px]\t"
                      "Gaze point Y [DACS px]\tEye position left Z [DACS mm]\tRecording resolution "
                      "width\tRecording resolution height\n1\tEye Tracker\t9\t9\t655\t1600\t900\n"),
            "597x336 mm (assumed) at 655 mm (file)");
  EXPECT_EQ(
      displayOf("MSG\t1 screen_phys_coords = -200, 150, 200, -150\nMSG\t1 SCREEN_DISTANCE 680 "
                "720\nMSG\t1 GAZE_COORDS 0 0 1023 767\nSTART\t1 LEFT SAMPLES\n"
                "2\t500.0\t300.0\t900.0\n"),
      "400x300 mm (file) at 700 mm (file)");
  const std::string json = R"({"SamplingFrequency": 500, "Columns": ["x_coordinate",
    "y_coordinate"], "x_coordinate": {"Units": "UNIT"}, "StimulusPresentation":
    {"ScreenResolution": [1000, 500], "ScreenOrigin": ["top", "left"], "ScreenSize": [0.4, 0.2],
    "ScreenDistance": 0.9}})";
  const auto withUnit = [&](const std::string& unit) {
    std::string text = json;
    return text.replace(text.find("UNIT"), 4, unit);
  };
  EXPECT_EQ(displayOf("9\t9\n", {}, withUnit("pixel")), "400x200 mm (file) at 900 mm (file)");
  // The file's display is also what its degrees are mapped by: 0.5 + 900 tan 5 / 400.
  const GazeLog degrees = parseLog("5\t0\n", {.origin = GazeOrigin::Centre}, withUnit("deg"));
  EXPECT_NEAR(degrees.samples.at(0).position.x, 0.5 + 900.0 * 0.0874886635 / 400.0, 1e-9);
}

TEST(GazeViewing, CodesForNoEyeAreNoDistances) {
  RecordedDisplay display;
  for (const double code : {-1.0, 0.0, 99.0, 1e6, std::nan("")}) display.noteDistance(code);
  display.setSize({0.0, 300.0});
  EXPECT_EQ(display.distanceMm(), std::nullopt);
  EXPECT_EQ(display.sizeMm(), std::nullopt);
}

TEST(GazeViewing, ADisplayOfAnotherShapeThanTheScreenIsAWarning) {
  const auto warningsWith = [](const std::string& screen) {
    return viewingOf(parseLog(kStudio + "0\t0\t0\t9\t9\t600\t600\t" + screen + "\n"), {})
        .warnings.size();
  };
  EXPECT_EQ(warningsWith("1920 x 1080"), 0U);
  EXPECT_EQ(warningsWith("1366 x 768"), 0U);
  EXPECT_EQ(warningsWith("1920 x 1200"), 1U);  // 11 % off
  EXPECT_EQ(warningsWith("1280 x 1024"), 1U);
}

TEST(GazeViewing, SceneCamerasHaveNoDegreesUnlessASettingTakesThem) {
  const GazeLog log = parseLog(kCore);
  const Viewing refused = viewingOf(log, {});
  EXPECT_FALSE(refused.hasDegrees);
  ASSERT_EQ(refused.warnings.size(), 1U);
  LogOptions options;
  settings::Registry registry;
  registerSettings(registry, options);
  registry.setText("gaze.sceneCameraAsDisplay", "on", "test");
  EXPECT_TRUE(viewingOf(log, options).hasDegrees);
  EXPECT_EQ(viewingOf(log, options).warnings.size(), 1U);  // still said
  EXPECT_TRUE(viewingOf(parseLog("time_s,x,y,valid\n0,0.5,0.5,1\n"), {}).hasDegrees);
}

TEST(GazeViewing, ConversionDoesNotHideTheSceneCamera) {
  const std::filesystem::path in = macula::test::temporaryPath("core.csv");
  const std::filesystem::path out = macula::test::temporaryPath("converted.csv");
  writeFileAtomically(in, kCore);
  (void)convertGazeLog(in, out);
  const GazeLog log = readGazeLog(out);
  EXPECT_TRUE(isOfSceneCamera(log.coordinates)) << describe(log.coordinates);
  EXPECT_FALSE(viewingOf(log, {}).hasDegrees);
  std::filesystem::remove(in);
  std::filesystem::remove(out);
}

TEST(GazeViewing, ErrorsThatAreZeroByDefinitionAreKnown) {
  GazeSettings settings;
  EXPECT_TRUE(isUndelayed(settings));
  EXPECT_TRUE(isUndelayed(undelayed(settings)));
  settings.latencyMs = 1.0;
  EXPECT_FALSE(isUndelayed(settings));
  settings = {};
  settings.pipeline.filter = FilterChoice::OneEuro;
  EXPECT_FALSE(isUndelayed(settings));
  settings = {};
  settings.pipeline.prediction = Prediction::Landing;
  EXPECT_FALSE(isUndelayed(settings));
}

}  // namespace
}  // namespace macula::gaze
