// Coordinates with settings, the numbers of a report, and logs that are streamed.
#include <filesystem>

#include "engine/core/file.h"
#include "engine/gaze/canonical_csv.h"
#include "engine/gaze/coordinates.h"
#include "gaze_log_cases.h"
#include "temporary_path.h"

namespace macula::gaze {
namespace {

glm::dvec2 mapped(GazeUnit unit, GazeOrigin origin, const glm::dvec2& raw) {
  const CoordinateMapper mapper({.unit = unit, .origin = origin}, {.screen = "1000x500"}, "here");
  return mapper.place(raw).value_or(kNoPosition);
}

TEST(GazeLogCoordinates, EveryOriginAtTheSamePlace) {
  // A quarter from the left and a fifth from the top, said in four ways.
  const glm::dvec2 place{0.25, 0.2};
  const auto expectSame = [&](const glm::dvec2& p) {
    EXPECT_NEAR(p.x, place.x, 1e-12);
    EXPECT_NEAR(p.y, place.y, 1e-12);
  };
  expectSame(mapped(GazeUnit::Pixels, GazeOrigin::TopLeft, {250, 100}));
  expectSame(mapped(GazeUnit::Pixels, GazeOrigin::BottomLeft, {250, 400}));
  expectSame(mapped(GazeUnit::Pixels, GazeOrigin::Centre, {-250, -150}));
  expectSame(mapped(GazeUnit::Pixels, GazeOrigin::CentreUp, {-250, 150}));
  expectSame(mapped(GazeUnit::Normalised, GazeOrigin::TopLeft, {0.25, 0.2}));
  expectSame(mapped(GazeUnit::Normalised, GazeOrigin::BottomLeft, {0.25, 0.8}));
  expectSame(mapped(GazeUnit::Normalised, GazeOrigin::Centre, {-0.25, -0.3}));
  expectSame(mapped(GazeUnit::Normalised, GazeOrigin::CentreUp, {-0.25, 0.3}));
}

TEST(GazeLogCoordinates, CodesAreNoPlaces) {
  const auto lost = [](GazeOrigin origin, const glm::dvec2& raw) {
    return std::isnan(mapped(GazeUnit::Pixels, origin, raw).x);
  };
  EXPECT_TRUE(lost(GazeOrigin::TopLeft, {0, 0}));
  EXPECT_TRUE(lost(GazeOrigin::BottomLeft, {0, 0}));
  EXPECT_FALSE(lost(GazeOrigin::Centre, {0, 0}));
  EXPECT_FALSE(lost(GazeOrigin::TopLeft, {0, 1}));
  EXPECT_TRUE(lost(GazeOrigin::TopLeft, {-1280, 5}));
  EXPECT_TRUE(lost(GazeOrigin::TopLeft, {2147483647.0, 5}));
  EXPECT_TRUE(lost(GazeOrigin::TopLeft, {std::nan(""), 5}));
  EXPECT_FALSE(lost(GazeOrigin::TopLeft, {-3000, 5}));  // far off, but a place
}

TEST(GazeLogCoordinates, LastPixelIsOnTheScreenAndTheNextIsNot) {
  EXPECT_LT(mapped(GazeUnit::Pixels, GazeOrigin::TopLeft, {999.999, 1}).x, 1.0);
  EXPECT_EQ(mapped(GazeUnit::Pixels, GazeOrigin::TopLeft, {1000, 1}).x, 1.0);
}

TEST(GazeLogOptions, SettingsReachTheReader) {
  LogOptions options;
  settings::Registry registry;
  registerSettings(registry, options);
  registry.setText("gaze.format", "eyelink", "test");
  registry.setText("gaze.unit", "0..1", "test");
  registry.setText("gaze.origin", "bottom-left", "test");
  registry.setText("gaze.timeUnit", "us", "test");
  registry.setText("gaze.screen", "640x480", "test");
  EXPECT_EQ(options.format, "eyelink");
  EXPECT_EQ(options.unit, GazeUnit::Normalised);
  EXPECT_EQ(options.origin, GazeOrigin::BottomLeft);
  EXPECT_EQ(options.timeUnit, TimeUnit::Microseconds);
  EXPECT_EQ(screenOf(options)->size, glm::dvec2(640, 480));
  EXPECT_THROW(registry.setText("gaze.format", "eyelnk", "test"), InputError);
  EXPECT_THROW(registry.setText("gaze.minConfidence", "2", "test"), InputError);
}

TEST(GazeLogQuality, IntervalsInBinsGiveTheirMedianAndDeviation) {
  IntervalHistogram histogram;
  EXPECT_EQ(histogram.median(), 0.0);
  for (const double ms : {20.0, 20.0, 19.0, 21.0, 20.0, 500.0}) histogram.add(ms * 1e-3);
  EXPECT_NEAR(histogram.median(), 0.020, 1e-15);
  // Of 20, 20, 19, 21, 20 ms: squares 0, 0, 1, 1, 0 over 5.
  EXPECT_NEAR(histogram.deviation(0.040), std::sqrt(0.4) * 1e-3, 1e-12);
  IntervalHistogram slow;
  for (int i = 0; i < 3; ++i) slow.add(3600.0);
  EXPECT_NEAR(slow.median(), 3600.0, 1e-9);
  IntervalHistogram days;
  days.add(1e14);
  EXPECT_GT(days.median(), 0.0);
}

/// The rate of a steady tracker whose clock counts in ticks; where it loses samples, every 50th.
double rateOnACoarseClock(double hertz, double tick, bool loses) {
  QualityMeter meter;
  for (int i = 0; i < 3000; ++i) {
    if (loses && i % 50 == 49) continue;
    GazeSample sample;
    sample.timeSeconds = std::round(i / hertz / tick) * tick;
    meter.add(sample);
  }
  return meter.quality().rateHz;
}

TEST(GazeLogQuality, RatesOfClocksThatCountWholeMillisecondsOrTenths) {
  for (const double hertz : {30.0, 50.0, 60.0, 90.0, 120.0, 300.0, 600.0, 1000.0, 1200.0}) {
    for (const double tick : {1e-3, 1e-4, 1e-6}) {
      EXPECT_NEAR(rateOnACoarseClock(hertz, tick, false), hertz, 1e-3 * hertz) << tick;
      EXPECT_NEAR(rateOnACoarseClock(hertz, tick, true), hertz, 5e-3 * hertz) << tick;
    }
  }
  EXPECT_NEAR(rateOnACoarseClock(60.0, 1e-2, false), 60.0, 0.1);
}

TEST(GazeLogQuality, GapsOfDaysAreCountedAndNothingIsIntegratedOverThem) {
  const GazeLog log = parseLog(
      "time_s,x,y,valid\n0,0.1,0.5,1\n0.01,0.1001,0.5,1\n259200,0.9,0.5,1\n259200.01,0.9001,0.5,"
      "1\n");
  const GazeQuality quality = assess(log);
  EXPECT_EQ(log.counters.gaps, 1U);
  EXPECT_EQ(quality.movements.saccades, 0U);
  EXPECT_NEAR(quality.longestDropoutSeconds, 259199.98, 1e-3);
  EXPECT_NEAR(quality.rateHz, 100.0, 1e-3);
}

/// Holds a place for some samples at 100 Hz, with noise below any threshold.
void look(EyeMovementClassifier& eye, double& time, double x, int samples) {
  for (int i = 0; i < samples; ++i) {
    time += 0.01;
    eye.add(time, glm::dvec2(x + (i % 2) * 1e-5, 0.5));
  }
}

TEST(GazeLogQuality, FixationsAndSaccadesByHand) {
  // 1000 mm wide at 1000 mm: from 0.4 to 0.5 is atan(0.1) = 5.71 degrees.
  const Display display{.widthMm = 1000.0, .heightMm = 500.0, .distanceMm = 1000.0};
  EyeMovementClassifier eye(30.0, display);
  double time = 0.0;
  look(eye, time, 0.4, 11);  // 100 ms
  look(eye, time, 0.5, 13);
  const EyeMovements movements = eye.result();
  EXPECT_EQ(movements.fixations, 2U);
  EXPECT_EQ(movements.saccades, 1U);
  EXPECT_NEAR(movements.saccadeDegrees, 5.71, 0.01);
  // The window is two steps, so both steps after the jump count as saccade: 100 and 110 ms.
  EXPECT_NEAR(movements.fixationSeconds, 0.105, 1e-9);
}

TEST(GazeLogQuality, ShortLossesJoinFixationsAndLongOnesDoNot) {
  const auto fixationsAround = [](double loss, double place) {
    EyeMovementClassifier eye(30.0, {});
    double time = 0.0;
    look(eye, time, 0.4, 11);
    time += 0.01;
    eye.add(time, std::nullopt);
    time += loss - 0.02;
    look(eye, time, place, 11);
    EXPECT_EQ(eye.result().saccades, 0U);  // no speed is taken across the loss
    return eye.result().fixations;
  };
  EXPECT_EQ(fixationsAround(0.07, 0.4), 1U);
  EXPECT_EQ(fixationsAround(0.09, 0.4), 2U);
  EXPECT_EQ(fixationsAround(0.07, 0.5), 2U);
}

TEST(GazeLogQuality, DuplicateTimesMakeNoSpeed) {
  const GazeLog log = parseLog(
      "time_s,x,y,valid\n0,0.5,0.5,1\n0.1,0.5001,0.5,1\n0.1,0.9,0.5,1\n0.05,0.1,0.5,1\n"
      "0.15,0.5002,0.5,1\n");
  EXPECT_EQ(log.counters.duplicateTimes, 1U);
  EXPECT_EQ(log.counters.backwardTimes, 1U);
  EXPECT_EQ(assess(log).movements.saccades, 0U);
}

TEST(GazeLogQuality, FrozenRunsAreCountedOnce) {
  QualityMeter meter;
  const auto feed = [&](double time, double x) {
    GazeSample sample;
    sample.timeSeconds = time;
    sample.position = {x, 0.5};
    sample.valid = true;
    meter.add(sample);
  };
  for (int i = 0; i < 30; ++i) feed(0.01 * i, 0.5);       // one run
  for (int i = 0; i < 9; ++i) feed(1.0 + 0.01 * i, 0.6);  // 80 ms: too short
  for (int i = 0; i < 2; ++i) feed(2.0 + 0.2 * i, 0.7);   // two samples: too few
  for (int i = 0; i < 3; ++i) feed(3.0 + 0.05 * i, 0.8);  // one run
  EXPECT_EQ(meter.quality().frozenRuns, 2U);
}

TEST(GazeLogReader, GivesTheSamplesOfTheWholeLogOneByOne) {
  const std::filesystem::path path = MACULA_SOURCE_DIR "/assets/gallery_gaze.csv";
  const GazeLog whole = readGazeLog(path);
  GazeLogReader reader(path);
  EXPECT_EQ(reader.head().format, "macula-csv");
  GazeSample sample;
  std::size_t count = 0;
  while (reader.next(sample)) {
    ASSERT_LT(count, whole.samples.size());
    ASSERT_EQ(sample.timeSeconds, whole.samples[count].timeSeconds);
    ++count;
  }
  EXPECT_EQ(count, whole.samples.size());
  EXPECT_FALSE(reader.next(sample));
  EXPECT_EQ(reader.head().notes, whole.notes);
}

TEST(GazeLogReader, ConvertsAsAStreamToTheSameText) {
  const std::filesystem::path folder = macula::test::temporaryPath("quality");
  std::filesystem::create_directories(folder);
  const std::filesystem::path in = folder / "macula_convert_in.csv";
  const std::filesystem::path out = folder / "macula_convert_out.csv";
  const std::string text =
      "# by hand\ntime_s,x,y,valid,pupil_mm\n0,0.5,0.25,1,\n0.1,,,0,\n0.2,1,2,1,3.5\n";
  writeFileAtomically(in, text);
  const Conversion done = convertGazeLog(in, out);
  EXPECT_EQ(done.samples, 3U);
  EXPECT_EQ(readTextFile(out), text);
  writeFileAtomically(in, text + "x,0.5,0.5,1,\n0.4,0.5,0.5,1,\n");
  EXPECT_THROW((void)convertGazeLog(in, out), InputError);
  EXPECT_EQ(readTextFile(out), text);  // as it was
  std::filesystem::remove_all(folder);
}

TEST(GazeLogReader, ConversionSaysWhatTheCoordinatesWere) {
  const std::filesystem::path folder = macula::test::temporaryPath("quality");
  std::filesystem::create_directories(folder);
  const std::filesystem::path in = folder / "macula_convert_degrees.csv";
  const std::filesystem::path out = folder / "macula_convert_places.csv";
  writeFileAtomically(in, "n,x,y,val\n0,0,0,0\n");
  (void)convertGazeLog(in, out);
  EXPECT_EQ(
      readTextFile(out),
      "# converted from gazebase; coordinates were deg (format), origin centre, y up "
      "(format), of the screen; degrees mapped by a display of 597x336 mm (assumed) at 750 mm "
      "(assumed)\n"
      "time_s,x,y,valid\n0,0.5,0.5,1\n");
  std::filesystem::remove_all(folder);
}

TEST(GazeLogReader, WhatIsNoGazeLogNamesTheLine) {
  MACULA_RECORDING(path, "oneeuro_groundTruth.csv");
  try {
    (void)readGazeLog(path);
    FAIL() << "read as a gaze log";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("oneeuro_groundTruth.csv: line 1: not the first line"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace macula::gaze
