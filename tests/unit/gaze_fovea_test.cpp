// The fovea's radius under age and saccades; latency; and every recording that there is.
#include "engine/gaze/fovea.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <numeric>

#include "engine/gaze/delay.h"
#include "engine/gaze/point_error.h"
#include "engine/gaze/quality.h"
#include "engine/gaze/source.h"
#include "engine/gaze/synthetic.h"

namespace macula::gaze {
namespace {

constexpr double kFrame = 1.0 / 60.0;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

TEST(FoveaRadius, WidensWithAgeBeyondTheSamplingInterval) {
  FoveaRadius fovea(0.02);
  EXPECT_FLOAT_EQ(fovea.at(0.0, 0.0, false), kFoveaRadius);
  EXPECT_FLOAT_EQ(fovea.at(0.02, 0.02, false), kFoveaRadius);
  EXPECT_FLOAT_EQ(fovea.at(0.12, 0.12, false), kFoveaRadius + 0.05F);  // 0.5 a second, 100 ms
  EXPECT_FLOAT_EQ(fovea.at(2.0, kInfinite, false), kFoveaRadius + 0.3F);
}

TEST(FoveaRadius, GrowsAndShrinksAtLimitedSpeeds) {
  FoveaRadius fovea(0.0);
  static_cast<void>(fovea.at(0.0, 0.0, false));
  EXPECT_NEAR(fovea.at(0.05, 0.0, true), kFoveaRadius + 0.1F, 1e-6);   // 2 a second
  EXPECT_NEAR(fovea.at(0.10, 0.0, true), kFoveaRadius + 0.15F, 1e-6);  // all that it asks for
  EXPECT_NEAR(fovea.at(0.20, 0.0, false), kFoveaRadius + 0.1F, 1e-6);  // 0.5 a second
  EXPECT_NEAR(fovea.at(0.20, 0.0, false), kFoveaRadius + 0.1F, 1e-6);  // asked twice
}

TEST(GazeDelay, GivesWhatWasKnownThen) {
  GazeDelay delay;
  PointOfInterest point;
  PointOfInterest got;
  for (int i = 0; i <= 60; ++i) {
    point = exactPoint({i / 100.0, 0.5});
    got = delay.next(i * 0.01, point, 0.1);
  }
  EXPECT_FLOAT_EQ(got.position.x, 0.5F);
  EXPECT_NEAR(got.ageSeconds, 0.1F, 1e-6);
  EXPECT_EQ(delay.next(0.6, point, 0.0).position, point.position);
}

TEST(GazeDelay, BeginsWithTheOldestAndKeepsWithinItsCapacity) {
  GazeDelay delay;
  EXPECT_EQ(delay.next(0.0, exactPoint({0.25, 0.5}), 1.0).position.x, 0.25F);
  PointOfInterest got;
  const int frames = static_cast<int>(GazeDelay::kCapacity) * 2;
  for (int i = 1; i < frames; ++i) got = delay.next(i, exactPoint({0.5, 0.5}), 1e9);
  EXPECT_EQ(got.ageSeconds, static_cast<float>(GazeDelay::kCapacity - 1));
}

GazeSettings with(double latencyMs) {
  GazeSettings settings;
  settings.latencyMs = latencyMs;
  return settings;
}

/// Nine tenths of the frames are nearer to the eye than this, in degrees, at 60 frames a second.
double largeError(const GazeLog& log, const GazeSettings& settings) {
  ReplayGaze replay(log, settings);
  ReplayGaze truth(log, undelayed(settings));
  std::vector<double> errors;
  for (int frame = 0; frame < 1200; ++frame) {
    const PointOfInterest point = replay.at(frame * kFrame);
    if (const auto error = pointError(point, truth.at(frame * kFrame), settings.display)) {
      errors.push_back(*error);
    }
  }
  std::ranges::sort(errors);
  return errors.empty() ? -1.0 : errors[errors.size() * 9 / 10];
}

TEST(PointError, IsNothingWithoutLatencyAndGrowsWithIt) {
  const GazeLog log = synthesizeGaze({});
  EXPECT_EQ(largeError(log, with(0.0)), 0.0);
  const double at60 = largeError(log, with(60.0));
  const double at150 = largeError(log, with(150.0));
  EXPECT_GT(at60, 0.1);
  EXPECT_GT(at150, 1.5 * at60);
}

TEST(PointError, LandingsAreNearerThanTheSamplesOfASaccade) {
  const LandingErrors errors = landingErrors(synthesizeGaze({.rateHz = 250.0}), {});
  ASSERT_GT(errors.predicted.size(), 100U);
  ASSERT_EQ(errors.predicted.size(), errors.unpredicted.size());
  const auto mean = [](const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  };
  EXPECT_LT(mean(errors.predicted), 0.8 * mean(errors.unpredicted));
}

TEST(PointError, AGapOfCenturiesTakesNoTime) {
  GazeLog log = synthesizeGaze({.durationSeconds = 5.0});
  const std::vector<double> before = pointErrors(log, with(60.0), 60.0);
  GazeSample late = log.samples.front();
  late.timeSeconds = 1e9;
  log.samples.push_back(late);
  const std::vector<double> after = pointErrors(log, with(60.0), 60.0);
  EXPECT_GE(after.size(), before.size());
  EXPECT_LT(after.size(), before.size() + 120);
}

TEST(PointError, ByHand) {
  // The middle and 1/4 of 597 mm to its right, from 750 mm: atan(149.25 / 750) = 11.2550 degrees.
  EXPECT_NEAR(*pointError(exactPoint({0.5, 0.5}), exactPoint({0.75, 0.5}), {}), 11.2550, 1e-3);
  EXPECT_FALSE(pointError(exactPoint({0.5, 0.5}), PointOfInterest{}, {}));
}

/// What must hold of every frame of every recording.
void expectCalm(const GazeLog& log, const GazeSettings& settings, double interval) {
  ReplayGaze replay(log, settings);
  PointOfInterest before;
  int compared = 0;
  const double end = std::min(log.samples.back().timeSeconds + 2.0, 60.0);
  for (int frame = 0; frame * kFrame < end; ++frame) {
    const PointOfInterest point = replay.at(frame * kFrame);
    const glm::dvec2 moved = glm::dvec2(point.position) - glm::dvec2(before.position);
    const bool sighted = before.state != GazeState::None && frame > 0;
    if (sighted && point.state == GazeState::Ok && before.state == GazeState::Ok &&
        !point.saccade) {
      // Samples up to an interval older than the frame before may lie between the two points.
      const double degrees =
          angleBetween(point.position, before.position, settings.display) / (kFrame + interval);
      EXPECT_LT(degrees, settings.pipeline.saccade.onsetSpeed) << log.name << " frame " << frame;
      ++compared;
    }
    if (sighted && point.state != GazeState::Ok && before.state != GazeState::Ok) {
      EXPECT_LE(glm::length(moved), kFastestEase * kFrame + 1e-6) << log.name << " frame " << frame;
    }
    if (sighted) {
      EXPECT_LE(point.radius - before.radius, FoveaRadius::kGrowth * kFrame + 1e-6);
      EXPECT_LE(before.radius - point.radius, FoveaRadius::kShrinkage * kFrame + 1e-6);
    }
    EXPECT_GE(point.radius, kFoveaRadius);
    before = point;
  }
  if (log.samples.size() > 100) {
    EXPECT_GT(compared, 5) << log.name;  // the shortest lasts 22 frames, most of them lost
  }
}

TEST(EveryRecording, MovesNoFasterThanASaccadeOutsideSaccades) {
  std::vector<std::filesystem::path> files{MACULA_SOURCE_DIR "/assets/gallery_gaze.csv"};
  const std::filesystem::path folder = MACULA_SOURCE_DIR "/../shared/data/gaze";
  if (std::filesystem::exists(folder)) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      // The vectors of a filter, no log.
      if (entry.path().filename() != "oneeuro_groundTruth.csv") files.push_back(entry.path());
    }
  } else {
    std::cout << "recordings are absent: " << folder << '\n';
  }
  for (const std::filesystem::path& file : files) {
    const GazeLog log = readGazeLog(file);
    const double interval = medianInterval(log);
    for (const FilterChoice filter : {FilterChoice::None, FilterChoice::OneEuro}) {
      for (const double latency : {0.0, 60.0}) {
        GazeSettings settings = with(latency);
        settings.pipeline.filter = filter;
        expectCalm(log, settings, interval);
      }
    }
  }
}

}  // namespace
}  // namespace macula::gaze
