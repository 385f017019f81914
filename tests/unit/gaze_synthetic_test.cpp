// The synthetic gaze: the same bits as the shipped file, and the shape of real gaze.
// MACULA_UPDATE=1 writes assets/gallery_gaze.csv.
#include "engine/gaze/synthetic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/gaze/quality.h"

namespace macula::gaze {
namespace {

const std::filesystem::path kDemoLog = MACULA_SOURCE_DIR "/assets/gallery_gaze.csv";

TEST(SyntheticGaze, DemoLogIsWhatTheCodeMakes) {
  const std::string text = canonicalCsv(synthesizeGaze({}));
  if (std::getenv("MACULA_UPDATE") != nullptr) writeFileAtomically(kDemoLog, text);
  // Compared as a bool: a difference of 2,400 lines helps nobody.
  EXPECT_TRUE(readTextFile(kDemoLog) == text) << "run with MACULA_UPDATE=1 and look at the change";
}

TEST(SyntheticGaze, DemoLogIsLabelledAndHoldsWhatItSays) {
  const GazeLog log = readGazeLog(kDemoLog);
  ASSERT_FALSE(log.notes.empty());
  EXPECT_TRUE(log.notes[0].starts_with("SYNTHETIC")) << log.notes[0];
  const GazeQuality quality = assess(log);
  EXPECT_NEAR(quality.rateHz, 120.0, 0.01);
  EXPECT_NEAR(quality.durationSeconds, 20.0, 0.01);
  // Four or so blinks of 0.1 to 0.25 s and one flagged dropout; the other dropout leaves rows out.
  EXPECT_GT(quality.lost, 60U);
  EXPECT_LT(quality.lost, 300U);
  EXPECT_GT(2400U - quality.samples, 40U);
  EXPECT_GT(quality.longestDropoutSeconds, 0.35);
  EXPECT_LT(quality.longestDropoutSeconds, 0.95);
  EXPECT_GT(quality.offScreen, 0U);
  EXPECT_LT(quality.offScreen, quality.samples / 10);
}

TEST(SyntheticGaze, FixatesMostOfTheTimeAndMovesInSaccades) {
  const GazeLog log = synthesizeGaze({.seed = 5, .blinksPerMinute = 0.0, .dropouts = 0});
  ASSERT_EQ(log.samples.size(), 2400U);
  int slow = 0;
  int saccades = 0;
  bool moving = false;
  for (std::size_t i = 3; i < log.samples.size(); ++i) {
    // Over three samples, so that jitter does not count as movement.
    const glm::dvec2 degrees =
        (log.samples[i].position - log.samples[i - 3].position) * glm::dvec2(43.5, 25.2);
    const double speed = glm::length(degrees) * 120.0 / 3.0;
    if (speed < 30.0) ++slow;
    if (speed > 60.0 && !moving) ++saccades;
    moving = speed > 60.0;
  }
  EXPECT_GT(slow, 1600);  // saccades take a sixth of the time, widened by three samples
  EXPECT_GT(saccades, 30);
  EXPECT_LT(saccades, 75);  // 2 to 3 a second
}

TEST(SyntheticGaze, PlacesAroundBlinksRunDownTheScreen) {
  const GazeLog calm = synthesizeGaze({.seed = 3, .blinksPerMinute = 0.0, .dropouts = 0});
  const GazeLog log = synthesizeGaze({.seed = 3, .blinksPerMinute = 20.0, .dropouts = 0});
  ASSERT_EQ(calm.samples.size(), log.samples.size());
  int returns = 0;
  for (std::size_t i = 1; i < log.samples.size(); ++i) {
    const GazeSample& sample = log.samples[i];
    if (!sample.valid || log.samples[i - 1].valid) continue;
    // At most 8.3 of the 90 ms after the blink have passed: 0.82 to 1 of 6 degrees in 25.2.
    const double shift = sample.position.y - calm.samples[i].position.y;
    EXPECT_GT(shift, 0.19) << i;
    EXPECT_LT(shift, 0.24) << i;
    EXPECT_EQ(sample.position.x, calm.samples[i].position.x);
    EXPECT_LT(sample.confidence.value(), 0.85F);
    ++returns;
  }
  EXPECT_GE(returns, 4);  // 20 a minute, in 20 s
}

TEST(SyntheticGaze, SeedsDifferAndOptionsAreChecked) {
  EXPECT_EQ(canonicalCsv(synthesizeGaze({.seed = 7, .durationSeconds = 1.0})),
            canonicalCsv(synthesizeGaze({.seed = 7, .durationSeconds = 1.0})));
  EXPECT_NE(canonicalCsv(synthesizeGaze({.seed = 7, .durationSeconds = 1.0})),
            canonicalCsv(synthesizeGaze({.seed = 8, .durationSeconds = 1.0})));
  EXPECT_THROW((void)synthesizeGaze({.durationSeconds = 0.0}), InputError);
  EXPECT_THROW((void)synthesizeGaze({.durationSeconds = 1e9}), InputError);
  EXPECT_THROW((void)synthesizeGaze({.rateHz = std::nan("")}), InputError);
  EXPECT_THROW((void)synthesizeGaze({.blinksPerMinute = 1000.0}), InputError);
  EXPECT_THROW((void)synthesizeGaze({.dropouts = -1}), InputError);
}

}  // namespace
}  // namespace macula::gaze
