// Sources: the fixed point, the mouse, and the replay of whole logs.
#include "engine/gaze/source.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>

#include "engine/core/error.h"

namespace macula::gaze {
namespace {

std::string errorOf(const std::string& spec) {
  try {
    (void)parseGazeSpec(spec);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// Samples every 10 ms for 1 s; x grows by 0.005 a sample from 0.1, so that each differs.
GazeLog ramp() {
  GazeLog log;
  log.name = "ramp";
  for (int i = 0; i <= 100; ++i) {
    log.samples.push_back({.timeSeconds = i / 100.0,
                           .position = {0.1 + 0.005 * i, 0.25},
                           .valid = true,
                           .confidence = std::nullopt,
                           .pupilMillimetres = std::nullopt});
  }
  return log;
}

TEST(GazeSpec, CenterAndPointsAreExactForAsLongAsTheyLast) {
  for (const auto& [spec, x, y] :
       {std::tuple{"center", 0.5F, 0.5F}, std::tuple{"0,1", 0.0F, 1.0F},
        std::tuple{"0,0", 0.0F, 0.0F}, std::tuple{"0.3, 0.7", 0.3F, 0.7F}}) {
    const std::unique_ptr<GazeSource> source = parseGazeSpec(spec);
    EXPECT_EQ(source->name(), spec);
    for (const double time : {0.0, 1.0, 1e6}) {
      const PointOfInterest point = source->at(time);
      EXPECT_EQ(point.position, glm::vec2(x, y)) << spec;
      EXPECT_EQ(point.raw, glm::vec2(x, y));
      EXPECT_EQ(point.state, GazeState::Ok);
      EXPECT_EQ(point.ageSeconds, 0.0F);
    }
  }
}

TEST(GazeSpec, MistakesAreNamedWithWhatIsAccepted) {
  const std::string accepted = "give center, x,y (each 0..1 of the window) or a gaze log";
  EXPECT_EQ(errorOf("1.5,0.5"), "--gaze 1.5,0.5: outside the window; " + accepted);
  EXPECT_EQ(errorOf("0.5,-0.1"), "--gaze 0.5,-0.1: outside the window; " + accepted);
  EXPECT_EQ(errorOf("0.5"), "--gaze 0.5: no such file and no point; " + accepted);
  EXPECT_EQ(errorOf("nan,0.5"), "--gaze nan,0.5: no such file and no point; " + accepted);
  EXPECT_EQ(errorOf(""), "--gaze : no such file and no point; " + accepted);
  EXPECT_EQ(errorOf("/tmp"), "/tmp: is a folder; name a gaze log in it");
}

TEST(MouseGaze, IsNeverLostAndClampsToTheWindow) {
  MouseGaze mouse;
  EXPECT_EQ(mouse.at(0.0).state, GazeState::None);
  EXPECT_EQ(mouse.at(0.0).position, glm::vec2(0.5F));
  mouse.move({0.0, 0.0});
  EXPECT_EQ(mouse.at(0.1).position, glm::vec2(0.0F));
  EXPECT_EQ(mouse.at(3600.0).state, GazeState::Ok);
  mouse.move({1e300, -0.25});
  EXPECT_EQ(mouse.at(3601.0).position, glm::vec2(1.0F, 0.0F));
  mouse.move({std::nan(""), 0.5});
  EXPECT_EQ(mouse.at(3602.0).position, glm::vec2(1.0F, 0.0F));
}

TEST(ReplayGaze, TakesTheNewestSampleAtOrBeforeTheFrame) {
  ReplayGaze replay(ramp());
  EXPECT_FLOAT_EQ(replay.at(0.0).position.x, 0.1F);
  EXPECT_FLOAT_EQ(replay.at(0.0).position.x, 0.1F);  // warm-up frames repeat a time
  EXPECT_FLOAT_EQ(replay.at(0.019).position.x, 0.105F);
  EXPECT_FLOAT_EQ(replay.at(0.02).position.x, 0.11F);
  const PointOfInterest point = replay.at(0.505);
  EXPECT_FLOAT_EQ(point.position.x, 0.35F);
  EXPECT_NEAR(point.ageSeconds, 0.005, 1e-6);
}

TEST(ReplayGaze, LatencyDelaysTheSamplesAndAges) {
  GazeSettings settings;
  settings.latencyMs = 60.0;
  ReplayGaze replay(ramp(), settings);
  EXPECT_EQ(replay.at(0.05).state, GazeState::None);
  const PointOfInterest point = replay.at(0.565);
  EXPECT_FLOAT_EQ(point.position.x, 0.35F);
  EXPECT_NEAR(point.ageSeconds, 0.065, 1e-6);
}

TEST(ReplayGaze, HoldsAfterTheEndThenEasesToTheCentre) {
  ReplayGaze replay(ramp());  // ends at 1 s at (0.6, 0.25)
  EXPECT_EQ(replay.at(1.0).state, GazeState::Ok);
  EXPECT_EQ(replay.at(1.02).state, GazeState::Held);
  const PointOfInterest held = replay.at(1.2);
  EXPECT_EQ(held.state, GazeState::Held);
  EXPECT_FLOAT_EQ(held.position.x, 0.6F);
  const PointOfInterest easing = replay.at(1.21);
  EXPECT_EQ(easing.state, GazeState::Easing);
  EXPECT_NEAR(glm::distance(easing.position, held.position), 0.02, 1e-5);
  const PointOfInterest ended = replay.at(3.0);
  EXPECT_EQ(ended.state, GazeState::Ended);
  EXPECT_EQ(stateName(ended.state), "ended");
  EXPECT_EQ(ended.position, glm::vec2(0.5F));
  EXPECT_FLOAT_EQ(ended.raw.x, 0.6F);
  EXPECT_EQ(replay.endSeconds(), 1.0);
}

TEST(ReplayGaze, ALossBeforeTheEndIsLostAndAfterItEnded) {
  GazeLog log = ramp();
  for (std::size_t i = 1; i < 100; ++i) log.samples[i].timeSeconds += 100.0;
  log.samples.resize(100);  // silence for 100 s, then the rest until 100.99 s
  ReplayGaze replay(std::move(log));
  EXPECT_EQ(replay.at(50.0).state, GazeState::Lost);
  EXPECT_EQ(replay.at(110.0).state, GazeState::Ended);
}

TEST(ReplayGaze, SeesABlinkBetweenTwoFrames) {
  GazeLog log = ramp();
  log.samples[52].valid = false;
  ReplayGaze replay(std::move(log));
  EXPECT_EQ(replay.at(0.5).state, GazeState::Ok);
  const PointOfInterest point = replay.at(0.6);
  EXPECT_EQ(point.state, GazeState::Held);
  EXPECT_FLOAT_EQ(point.position.x, 0.1F + 0.005F * 51.0F);
}

TEST(ReplayGaze, EmptyLogHasNoGaze) {
  ReplayGaze replay(GazeLog{});
  EXPECT_EQ(replay.at(0.0).state, GazeState::None);
  EXPECT_EQ(replay.at(9.0).position, glm::vec2(0.5F));
}

/// What must hold for any log at 60 frames a second: on the window, finite, without jumps while the
/// eye is not trusted, and equal in a second run.
void expectSound(const GazeLog& log, double seconds) {
  const double fps = 60.0;
  ReplayGaze replay(log);
  ReplayGaze again(log);
  PointOfInterest previous;
  int notOk = 0;
  for (int frame = 0; frame < static_cast<int>(seconds * fps); ++frame) {
    const PointOfInterest point = replay.at(frame / fps);
    const PointOfInterest same = again.at(frame / fps);
    ASSERT_EQ(std::bit_cast<std::uint32_t>(point.position.x),
              std::bit_cast<std::uint32_t>(same.position.x));
    ASSERT_EQ(point.state, same.state);
    ASSERT_TRUE(point.position.x >= 0.0F && point.position.x <= 1.0F) << frame;
    ASSERT_TRUE(point.position.y >= 0.0F && point.position.y <= 1.0F) << frame;
    if (point.state != GazeState::Ok) {
      ++notOk;
      if (previous.state != GazeState::Ok && frame > 0) {
        EXPECT_LE(glm::distance(point.position, previous.position), kFastestEase / fps + 1e-6)
            << frame;
      }
    }
    if (point.state == GazeState::Held && previous.state == GazeState::Held) {
      EXPECT_EQ(point.position, previous.position) << frame;
    }
    previous = point;
  }
  EXPECT_GT(notOk, 0);
  EXPECT_EQ(previous.state, GazeState::Ended);
}

TEST(ReplayGaze, RealRecordingStaysOnTheWindowWithoutJumps) {
  const std::filesystem::path path =
      MACULA_SOURCE_DIR "/../shared/data/gaze/tobii_studio_50hz_decimal_comma.tsv";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
  const GazeLog log = readGazeLog(path);
  expectSound(log, 26.0);

  // Frame 30, at 0.5 s: the newest sample is the one 497,... ms after the first.
  const GazeSample* newest = &log.samples.front();
  for (const GazeSample& sample : log.samples) {
    if (sample.timeSeconds <= 0.5) newest = &sample;
  }
  ReplayGaze replay(log);
  PointOfInterest point;
  for (int frame = 0; frame <= 30; ++frame) point = replay.at(frame / 60.0);
  EXPECT_EQ(point.state, GazeState::Ok);
  EXPECT_EQ(point.position, glm::vec2(newest->position));
}

TEST(ReplayGaze, DemoLogStaysOnTheWindowWithoutJumps) {
  expectSound(readGazeLog(MACULA_SOURCE_DIR "/assets/gallery_gaze.csv"), 22.0);
}

}  // namespace
}  // namespace macula::gaze
