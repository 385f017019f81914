// Saccades, the One Euro filter, the landing predictor, and how they work together.
#include "engine/gaze/refiner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "engine/gaze/cells.h"

namespace macula::gaze {
namespace {

TEST(OneEuro, EqualsThePublishedVectors) {
  const std::filesystem::path path =
      MACULA_SOURCE_DIR "/../shared/data/gaze/oneeuro_groundTruth.csv";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
  std::ifstream in(path);
  std::string line;
  std::getline(in, line);
  ASSERT_EQ(line, "timestamp,signal,noisy,filtered");
  OneEuro filter({.minCutoffHz = 1.0, .beta = 0.1, .derivativeCutoffHz = 1.0});
  std::vector<std::string_view> cells;
  int rows = 0;
  while (std::getline(in, line)) {
    splitCells(line, ',', cells);
    // The vectors were made for a constant rate of 120 Hz.
    const glm::dvec2 out = filter.next({*parseNumber(cells[2]), 0.0}, 1.0 / 120.0);
    ASSERT_NEAR(out.x, *parseNumber(cells[3]), 1e-4) << "row " << rows;
    ++rows;
  }
  EXPECT_EQ(rows, 1200);
}

TEST(OneEuro, TreatsAllDirectionsAlike) {
  OneEuro across;
  OneEuro oblique;
  const glm::dvec2 direction{0.6, 0.8};
  for (int i = 0; i < 50; ++i) {
    const double value = std::sin(0.3 * i);
    const glm::dvec2 a = across.next({value, 0.0}, 0.01);
    const glm::dvec2 b = oblique.next(value * direction, 0.01);
    EXPECT_NEAR(b.x, 0.6 * a.x, 1e-12);
    EXPECT_NEAR(b.y, 0.8 * a.x, 1e-12);
  }
}

TEST(OneEuro, ByHand) {
  // At rest the cutoff is 1 Hz: weight 1 / (1 + 1 / (2 pi 0.1)) = 0.3858696 for 0.1 s. The speed of
  // the first step is 10, smoothed to 3.858696; the cutoff 1.3858696 then weighs 0.4654600.
  OneEuro filter({.minCutoffHz = 1.0, .beta = 0.1, .derivativeCutoffHz = 1.0});
  EXPECT_EQ(filter.next({0.0, 0.0}, 0.1).x, 0.0);
  EXPECT_NEAR(filter.next({1.0, 0.0}, 0.1).x, 0.4654600, 1e-6);
}

constexpr double kStep = 0.004;  // 250 Hz

TEST(SaccadeDetector, SeesASaccadeOneStepAfterItsStartAndItsEnd) {
  SaccadeDetector detector;
  double time = 0.0;
  // 125 Hz: each step is a baseline.
  const auto see = [&](double degrees) { detector.observe(time += 0.008, {degrees, 0.0}); };
  see(0.0);
  see(0.2);  // 25 degrees a second
  EXPECT_FALSE(detector.inSaccade());
  EXPECT_NEAR(detector.speed(), 25.0, 1e-9);
  see(1.2);  // 125
  EXPECT_TRUE(detector.inSaccade());
  see(1.8);  // 75: above half of the onset speed
  EXPECT_TRUE(detector.inSaccade());
  see(2.0);  // 25
  EXPECT_FALSE(detector.inSaccade());
}

TEST(SaccadeDetector, NoiseOfAFastTrackerIsNoSaccade) {
  SaccadeDetector detector;
  for (int i = 0; i < 1000; ++i) {  // 1 kHz; 0.2 degrees up and down are 200 degrees a second
    detector.observe(i * 0.001, {i % 2 == 0 ? 0.2 : 0.0, 0.0});
    EXPECT_FALSE(detector.inSaccade());
  }
  for (int i = 0; i < 20; ++i) detector.observe(1.0 + i * 0.001, {0.2 * i, 0.0});
  EXPECT_TRUE(detector.inSaccade());
  EXPECT_NEAR(detector.speed(), 200.0, 1e-6);
}

TEST(SaccadeDetector, TakesNoSpeedOverAGapOrATimeThatStandsStill) {
  SaccadeDetector detector;
  detector.observe(0.0, {0.0, 0.0});
  detector.observe(0.076, {20.0, 0.0});
  EXPECT_FALSE(detector.inSaccade());
  EXPECT_EQ(detector.speed(), 0.0);
  detector.observe(0.076, {30.0, 0.0});
  EXPECT_FALSE(detector.inSaccade());
  detector.reset();
  detector.observe(0.080, {0.0, 0.0});
  EXPECT_FALSE(detector.inSaccade());
}

TEST(SaccadeDetector, IsNotCaughtInATrackerThatDrifts) {
  SaccadeDetector detector;
  int inSaccade = 0;
  for (int i = 0; i < 250; ++i) {
    detector.observe(i * kStep, {i * kStep * 90.0 + (i > 0 ? 1.0 : 0.0), 0.0});
    inSaccade += detector.inSaccade() ? 1 : 0;
  }
  EXPECT_EQ(inSaccade, 61);  // 250 ms from the last sample at rest
}

/// Way covered by a saccade of `amplitude` after `seconds`, by the model of the predictor.
double wayAfter(double seconds, double amplitude) {
  const double u = std::clamp(seconds / (0.0022 * amplitude + 0.021), 0.0, 1.0);
  return amplitude * u * u * u * (10.0 + u * (-15.0 + 6.0 * u));
}

constexpr glm::dvec2 kFrom{1.0, 2.0};

/// Where a model saccade along (0.6, -0.8) is said to land at 60 % of its time.
glm::dvec2 predictedLanding(double amplitude) {
  LandingPredictor predictor;
  for (int i = -20; i < 0; ++i) predictor.rest(i * kStep, kFrom);
  const double duration = 0.0022 * amplitude + 0.021;
  glm::dvec2 landing{0.0};
  for (double time = 0.0; time < 0.6 * duration; time += kStep) {
    const double way = wayAfter(time - 0.001, amplitude);  // it began 1 ms after the sample
    const glm::dvec2 place = kFrom + way * glm::dvec2(0.6, -0.8);
    if (way < 1.0) {
      predictor.rest(time, place);
    } else {
      landing = predictor.moving(time, place);
    }
  }
  return landing;
}

TEST(LandingPredictor, FindsTheEndOfAModelSaccadeSoonAfterItsMiddle) {
  for (const double amplitude : {4.0, 8.0, 16.0, 24.0}) {
    const glm::dvec2 landing = predictedLanding(amplitude);
    EXPECT_NEAR(glm::length(landing - kFrom), amplitude, 0.2 * amplitude) << amplitude;
    EXPECT_NEAR((landing - kFrom).x / glm::length(landing - kFrom), 0.6, 1e-9);
  }
}

TEST(LandingPredictor, NeverPredictsLessThanWasCovered) {
  LandingPredictor predictor;
  predictor.rest(0.0, {0.0, 0.0});
  for (int i = 1; i < 100; ++i) {
    const double way = 0.4 * i;
    EXPECT_GE(predictor.moving(i * kStep, {way, 0.0}).x, way - 1e-9);
  }
}

PipelineSettings settingsOf(FilterChoice filter, Prediction prediction = Prediction::None) {
  PipelineSettings settings;
  settings.filter = filter;
  settings.prediction = prediction;
  return settings;
}

/// Fixation with noise of some 0.2 degrees, a saccade of 0.3 windows in 5 samples, and rest.
std::vector<glm::dvec2> stream() {
  std::mt19937 random(3);
  const auto noise = [&] { return 0.004 * (static_cast<double>(random() % 1000) / 1000.0 - 0.5); };
  std::vector<glm::dvec2> places;
  for (int i = 0; i < 100; ++i) places.emplace_back(0.3 + noise(), 0.5 + noise());
  for (const double way : {0.04, 0.12, 0.2, 0.27, 0.3}) places.emplace_back(0.3 + way, 0.5);
  for (int i = 0; i < 100; ++i) places.emplace_back(0.6 + noise(), 0.5 + noise());
  return places;
}

TEST(GazeRefiner, WithoutFilterGivesBackTheSameBits) {
  for (const bool live : {false, true}) {
    GazeRefiner refiner(settingsOf(live ? FilterChoice::None : FilterChoice::Auto), {}, live);
    double time = 0.0;
    for (const glm::dvec2& place : stream()) EXPECT_EQ(refiner.refine(time += kStep, place), place);
  }
}

TEST(GazeRefiner, AutoFiltersLiveTrackers) {
  GazeRefiner refiner(settingsOf(FilterChoice::Auto), {}, true);
  static_cast<void>(refiner.refine(0.0, {0.5, 0.5}));
  EXPECT_NE(refiner.refine(kStep, {0.501, 0.5}).x, 0.501);
}

TEST(GazeRefiner, CalmsFixationsAndDoesNotDragBehindSaccades) {
  GazeRefiner refiner(settingsOf(FilterChoice::OneEuro), {}, false);
  const std::vector<glm::dvec2> places = stream();
  double time = 0.0;
  double rawSquares = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::dvec2 out = refiner.refine(time += kStep, places[i]);
    if (i >= 20 && i < 100) {
      rawSquares += (places[i].x - 0.3) * (places[i].x - 0.3);
      squares += (out.x - 0.3) * (out.x - 0.3);
    }
    if (i >= 100 && i < 105) {
      EXPECT_TRUE(refiner.inSaccade()) << i;
      EXPECT_EQ(out, places[i]) << "bypassed in saccades: " << i;
    }
    if (i >= 106) {
      EXPECT_NEAR(out.x, 0.6, 0.004) << i;
    }
  }
  EXPECT_LT(squares, 0.2 * rawSquares);
}

TEST(GazeRefiner, StartsAnewAfterALossAndAGap) {
  GazeRefiner refiner(settingsOf(FilterChoice::OneEuro), {}, false);
  static_cast<void>(refiner.refine(0.0, {0.2, 0.2}));
  static_cast<void>(refiner.refine(kStep, {0.2, 0.2}));
  refiner.reset();
  EXPECT_NEAR(refiner.refine(0.05, {0.8, 0.8}).x, 0.8, 1e-12);
  EXPECT_FALSE(refiner.inSaccade());
  EXPECT_NEAR(refiner.refine(0.2, {0.4, 0.8}).x, 0.4, 1e-12);  // 150 ms later
}

TEST(GazeRefiner, PredictionRunsAheadOfTheEye) {
  GazeRefiner refiner(settingsOf(FilterChoice::None, Prediction::Landing), {}, false);
  for (int i = -10; i <= 0; ++i) EXPECT_EQ(refiner.refine(i * kStep, {0.3, 0.5}).x, 0.3);
  const double degreesAcross = 2.0 * std::atan(298.5 / 750.0) * 180.0 / 3.14159265358979;
  double ahead = 0.0;
  for (int i = 1; i <= 5; ++i) {
    const double x = 0.3 + wayAfter(i * kStep, 12.0) / degreesAcross;
    ahead = refiner.refine(i * kStep, {x, 0.5}).x - x;
  }
  EXPECT_TRUE(refiner.inSaccade());
  EXPECT_GT(ahead, 0.08);  // after 20 ms of 47 the eye has covered a third of 0.28 windows
}

}  // namespace
}  // namespace macula::gaze
