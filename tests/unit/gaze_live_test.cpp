// A device that is read now, simulated by a reader.
#include "engine/gaze/live_gaze.h"

#include <gtest/gtest.h>

#include <cmath>

namespace macula::gaze {
namespace {

constexpr double kStart = 5000.0;  ///< host seconds at time 0

class FakeReader final : public DeviceReader {
 public:
  void drain(std::vector<DeviceSample>& samples) override {
    samples.insert(samples.end(), pending.begin(), pending.end());
    pending.clear();
  }
  [[nodiscard]] bool connected() const override { return plugged; }
  [[nodiscard]] std::string name() const override { return "fake"; }
  [[nodiscard]] std::string message() const override { return plugged ? "" : "unplugged"; }

  /// A sample at `time` with a little noise in its last digits, as eyes have.
  void see(double time, double x, double y, bool valid = true) {
    ++count;
    pending.push_back({kStart + time + 0.002, time + 70.0, {x + 1e-7 * (count % 5), y}, valid});
  }

  std::vector<DeviceSample> pending;
  bool plugged = true;
  int count = 0;
};

TEST(LiveGaze, PlacesSamplesInTheWindow) {
  FakeReader reader;
  LiveGaze gaze(reader, {}, kStart);
  gaze.place({.monitorOrigin = {-1000.0, 0.0},
              .monitorSize = {1000.0, 1000.0},
              .clientOrigin = {-750.0, 500.0},
              .clientSize = {500.0, 250.0},
              .pixelsPerUnit = 1.0});
  EXPECT_EQ(gaze.at(0.0).state, GazeState::None);
  reader.see(0.010, 0.5, 0.625);
  std::vector<GazeSample> heard;
  gaze.onSample([&](const GazeSample& sample) { heard.push_back(sample); });
  const PointOfInterest point = gaze.at(0.016);
  EXPECT_EQ(point.state, GazeState::Ok);
  EXPECT_NEAR(point.position.x, 0.5F, 1e-5);
  EXPECT_NEAR(point.position.y, 0.5F, 1e-5);
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_NEAR(heard[0].timeSeconds, 0.012, 1e-9);  // its arrival: the clock is not known yet
}

TEST(LiveGaze, AgeIsByTheDevicesClock) {
  FakeReader reader;
  LiveGaze gaze(reader, {}, kStart);
  for (int i = 0; i < 150; ++i) reader.see(0.004 * i, 0.5, 0.5);
  // The last one was read 30 ms late, in a stalled thread; it is as old as it is.
  reader.see(0.600, 0.5, 0.5);
  reader.pending.back().hostSeconds += 0.030;
  EXPECT_NEAR(gaze.at(0.640).ageSeconds, 0.640 - 0.602, 1e-6);
}

TEST(LiveGaze, AClockTooCoarseForItsSamplesIsNotUsed) {
  FakeReader reader;
  LiveGaze gaze(reader, {}, kStart);
  for (int i = 0; i < 200; ++i) {  // counts whole seconds
    reader.pending.push_back(
        {kStart + 0.01 * i, std::floor(0.01 * i), {0.5 + 1e-7 * i, 0.5}, true});
  }
  const PointOfInterest point = gaze.at(2.0);
  EXPECT_EQ(point.state, GazeState::Ok);
  EXPECT_NEAR(point.ageSeconds, 0.01, 1e-6);
  EXPECT_FALSE(gaze.status().clock);
  EXPECT_NE(gaze.status().message.find("timestamps"), std::string::npos);
}

TEST(LiveGaze, ABlinkIsSilenceAndUnplugIsNoticedAtOnce) {
  FakeReader reader;
  LiveGaze gaze(reader, {}, kStart);
  double time = 0.0;
  for (int i = 0; i < 100; ++i) reader.see(time += 0.004, 0.2, 0.3);
  PointOfInterest point = gaze.at(time);
  EXPECT_EQ(point.state, GazeState::Ok);
  point = gaze.at(time + 0.1);  // 60 ms of silence are a loss
  EXPECT_EQ(point.state, GazeState::Held);
  EXPECT_NEAR(point.position.x, 0.2F, 1e-3);
  time += 0.15;
  for (int i = 0; i < 50; ++i) reader.see(time += 0.004, 0.2, 0.3);  // back, past the distrust
  point = gaze.at(time);
  EXPECT_EQ(point.state, GazeState::Ok);
  reader.plugged = false;
  point = gaze.at(time + 0.004);
  EXPECT_EQ(point.state, GazeState::Held);
  EXPECT_FALSE(gaze.status().connected);
  EXPECT_EQ(gaze.status().message, "unplugged");
  for (int i = 0; i < 120; ++i) point = gaze.at(time + 0.004 + i / 60.0);
  EXPECT_EQ(point.state, GazeState::Lost);
  EXPECT_EQ(point.position, glm::vec2(0.5F));
  reader.plugged = true;
  time += 3.0;
  for (int i = 0; i < 35; ++i) reader.see(time += 0.004, 0.8, 0.3);
  EXPECT_EQ(gaze.at(time).state, GazeState::Easing);  // on the way back to the eye
  for (int i = 0; i < 250; ++i) reader.see(time += 0.004, 0.8, 0.3);
  EXPECT_EQ(gaze.at(time).state, GazeState::Ok);
}

TEST(LiveGaze, PresentButUntrackedFallsBackToTheCentre) {
  FakeReader reader;
  LiveGaze gaze(reader, {}, kStart);
  for (int i = 0; i < 600; ++i) {  // plugged in, and says nothing from the start
    const PointOfInterest point = gaze.at(i / 60.0);
    EXPECT_EQ(point.state, GazeState::None);
    EXPECT_EQ(point.position, glm::vec2(0.5F));
  }
  double time = 10.0;
  for (int i = 0; i < 100; ++i) reader.see(time += 0.004, 0.1, 0.9);
  EXPECT_EQ(gaze.at(time).state, GazeState::Ok);
  PointOfInterest point;
  for (int i = 0; i < 180; ++i) {  // then all samples are flagged, at (0, 0)
    reader.see(time += 1.0 / 60.0, 0.0, 0.0, false);
    point = gaze.at(time);
  }
  EXPECT_EQ(point.state, GazeState::Lost);
  EXPECT_EQ(point.position, glm::vec2(0.5F));
  EXPECT_FLOAT_EQ(point.radius, kFoveaRadius + static_cast<float>(FoveaRadius::kWidest));
}

TEST(LiveGaze, AnOffsetTakesOutACalibrationThatHasDrifted) {
  FakeReader reader;
  GazeSettings settings;
  settings.pipeline.filter = FilterChoice::None;
  settings.pipeline.offsetX = -0.05;
  settings.pipeline.offsetY = 0.1;
  LiveGaze gaze(reader, settings, kStart);
  gaze.place({.monitorSize = {100.0, 100.0}, .clientSize = {100.0, 100.0}});
  reader.see(0.01, 0.45, 0.4);
  const PointOfInterest point = gaze.at(0.02);
  EXPECT_NEAR(point.position.x, 0.4F, 1e-5);
  EXPECT_NEAR(point.position.y, 0.5F, 1e-5);
  EXPECT_NEAR(point.raw.x, 0.45F, 1e-5) << "what was recorded stays";
}

TEST(LiveGaze, SlowTrackersAreNotSilent) {
  for (const double rate : {15.0, 30.0}) {
    FakeReader reader;
    LiveGaze gaze(reader, {}, kStart);
    int ok = 0;
    for (int i = 0; i < 100; ++i) {
      const bool missing = i > 20 && i % 10 == 0;  // one sample alone is jitter
      if (!missing) reader.see(i / rate, 0.3, 0.4);
      ok += gaze.at((i + 0.5) / rate).state == GazeState::Ok ? 1 : 0;
    }
    EXPECT_GT(ok, 90) << rate;
  }
}

TEST(LiveGaze, SpeedsAreThoseOfTheWindowsPart) {
  // Half a window in 20 ms: over 1,000 degrees a second across the display, 60 in a small window.
  for (const double share : {1.0, 0.05}) {
    FakeReader reader;
    LiveGaze gaze(reader, {}, kStart);
    gaze.place({.monitorOrigin = {0.0, 0.0},
                .monitorSize = {1000.0, 1000.0},
                .clientOrigin = {0.0, 0.0},
                .clientSize = {1000.0 * share, 1000.0 * share},
                .pixelsPerUnit = 1.0});
    for (int i = 0; i < 30; ++i) reader.see(0.02 * i, 0.25 * share, 0.5 * share);
    reader.see(0.6, 0.75 * share, 0.5 * share);
    EXPECT_EQ(gaze.at(0.61).saccade, share == 1.0) << share;
  }
}

TEST(LiveGaze, ReportsItsClock) {
  FakeReader reader;
  LiveGaze gaze(reader, {}, kStart);
  EXPECT_FALSE(gaze.status().clock);
  for (int i = 0; i < 150; ++i) reader.see(0.004 * i, 0.5, 0.5);
  static_cast<void>(gaze.at(0.6));
  ASSERT_TRUE(gaze.status().clock);
  EXPECT_NEAR(gaze.status().clock->offsetSeconds, kStart + 0.002 - 70.0, 1e-6);
}

TEST(LiveGaze, CountsRateAndLosses) {
  FakeReader reader;
  LiveGaze gaze(reader, {}, kStart);
  for (int i = 0; i < 500; ++i) reader.see(0.004 * i, 0.5, 0.5, i % 4 != 0);
  static_cast<void>(gaze.at(2.0));
  EXPECT_NEAR(gaze.status().rateHz, 250.0, 2.0);
  EXPECT_NEAR(gaze.status().lostShare, 0.25, 0.01);
  static_cast<void>(gaze.at(9.0));
  EXPECT_EQ(gaze.status().rateHz, 0.0);
}

TEST(LiveGaze, ABurstBeyondItsMemoryIsCounted) {
  FakeReader reader;
  LiveGaze gaze(reader, {}, kStart);
  const int many = static_cast<int>(LiveGaze::kMostRecent) * 2;
  for (int i = 0; i < many; ++i) reader.see(0.0001 * i, 0.5, 0.5);
  static_cast<void>(gaze.at(0.0001 * many));
  EXPECT_EQ(gaze.status().rateHz, static_cast<double>(LiveGaze::kMostRecent));
}

}  // namespace
}  // namespace macula::gaze
