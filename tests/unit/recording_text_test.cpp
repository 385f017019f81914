// Recordings as text: every number comes back with the same bits.
#include "engine/recording/text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <sstream>
#include <string>

#include "engine/gaze/log.h"
#include "engine/recording/number_text.h"
#include "engine/recording/parse.h"
#include "tests/unit/recording_builder.h"

namespace macula::recording {
namespace {

template <typename Number>
std::string textOf(Number number) {
  std::string text;
  appendNumber(number, text);
  return text;
}

TEST(RecordingNumbers, AreTheShortestTextsAndNamesWhereThereAreNoDigits) {
  EXPECT_EQ(textOf(0.35F), "0.35");
  EXPECT_EQ(textOf(1.0F), "1");
  EXPECT_EQ(textOf(0.1), "0.1");
  EXPECT_EQ(textOf(-0.0F), "-0.0");
  EXPECT_EQ(textOf(1e20F), "1e+20");
  EXPECT_EQ(textOf(std::numeric_limits<float>::denorm_min()), "1e-45");
  EXPECT_EQ(textOf(std::numeric_limits<double>::quiet_NaN()), "\"nan\"");
  EXPECT_EQ(textOf(std::numeric_limits<float>::infinity()), "\"inf\"");
  EXPECT_EQ(textOf(-std::numeric_limits<float>::infinity()), "\"-inf\"");
}

TEST(RecordingNumbers, AreLongerWhereTheShortestWouldBeRoundedTwice) {
  // Of all floats only this one and its negative: read as a double, 7.038531e-26 lies in the middle
  // between two floats, and the even one is the wrong one.
  const auto number = std::bit_cast<float>(0x15ae43fdU);
  ASSERT_NE(static_cast<float>(7.038531e-26), number);
  EXPECT_EQ(textOf(number), "7.038530691851209e-26");
  EXPECT_EQ(static_cast<float>(std::strtod(textOf(number).c_str(), nullptr)), number);
}

TEST(RecordingNumbers, ComeBackBitForBitThroughDoubles) {
  std::mt19937 random(1);
  for (int i = 0; i < 300000; ++i) {
    // Any bits: denormals, huge and tiny ones alike.
    const auto number = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (!std::isfinite(number)) continue;
    const auto read = static_cast<float>(std::strtod(textOf(number).c_str(), nullptr));
    ASSERT_EQ(std::bit_cast<std::uint32_t>(read), std::bit_cast<std::uint32_t>(number))
        << textOf(number);
  }
}

TEST(RecordingFrame, ComesBackBitForBit) {
  std::mt19937 random(2);
  for (int i = 0; i < 2000; ++i) {
    Frame frame = someFrame(static_cast<std::uint64_t>(i));
    const auto anyFloat = [&random] {
      const auto number = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
      return std::isfinite(number) ? number : std::numeric_limits<float>::denorm_min();
    };
    for (glm::vec3* v : {&frame.camera.position, &frame.camera.target, &frame.camera.up}) {
      *v = {anyFloat(), anyFloat(), anyFloat()};
    }
    frame.camera.nearPlane = std::numeric_limits<float>::denorm_min() + std::abs(anyFloat()) / 4;
    frame.camera.farPlane = 2.0F * frame.camera.nearPlane;
    frame.timeSeconds =
        std::bit_cast<double>(0x3f00000000000000U + (std::uint64_t{random()} << 20U));
    frame.gaze.raw = {anyFloat(), anyFloat()};
    frame.gaze.radius = std::abs(anyFloat());
    frame.gaze.saccade = (random() & 1U) != 0;
    std::string line;
    appendFrameLine(frame, line);
    ASSERT_EQ(line.back(), '\n');
    line.pop_back();
    ASSERT_EQ(line.find('\n'), std::string::npos);
    expectSame(parseFrame(line, "frames.jsonl", 1), frame);
  }
}

TEST(RecordingFrame, KeepsWhatHasNoDigits) {
  Frame frame = someFrame(0);
  frame.gaze = {};  // no gaze has come: NaN and an infinite age
  frame.camera.position = {-0.0F, std::numeric_limits<float>::denorm_min(), 0.0F};
  std::string line;
  appendFrameLine(frame, line);
  const Frame read = parseFrame(line, "frames.jsonl", 1);
  EXPECT_TRUE(std::isnan(read.gaze.raw.x) && std::isnan(read.gaze.raw.y));
  EXPECT_EQ(read.gaze.ageSeconds, std::numeric_limits<float>::infinity());
  EXPECT_EQ(read.gaze.state, gaze::GazeState::None);
  EXPECT_TRUE(std::signbit(read.camera.position.x));
  expectSame(read, frame);
}

TEST(RecordingFrame, KeepsEverySettingAndEveryEvent) {
  Frame frame = someFrame(7);
  // In the order in which JSON objects are read back.
  frame.settings = {{"oit.fill", true},
                    {"oit.kAve", 0.1},
                    {"oit.layers", std::int64_t{-3}},
                    {"oit.method", std::string("kb-\"plus\"\n\xC3\xA9")},
                    {"scene.background", glm::vec3(0.1F, -0.0F, 1e-40F)}};
  frame.scene.name = "layers-4";
  frame.cut = true;
  frame.r = 1.25;
  frame.controls = {{"fovea", std::numeric_limits<double>::infinity()}, {"kAve", 3.3}};
  frame.unrecorded = 3;
  frame.imageSha256 = std::string(64, 'a');
  for (const Reset reset : {Reset::None, Reset::History, Reset::Scene, Reset::Restart}) {
    frame.reset = reset;
    std::string line;
    appendFrameLine(frame, line);
    Frame read = parseFrame(line, "frames.jsonl", 1);
    expectSame(read, frame);
  }
}

TEST(RecordingSession, ComesBack) {
  Session session = someSession();
  const Session read = parseSession(sessionText(session), "session.json");
  EXPECT_EQ(read.commit, session.commit);
  EXPECT_EQ(read.started, session.started);
  EXPECT_EQ(read.scene, session.scene);
  EXPECT_EQ(read.environmentSha256, session.environmentSha256);
  EXPECT_EQ(read.renderer, session.renderer);
  EXPECT_EQ(read.version, session.version);
  EXPECT_EQ(read.contentScale, session.contentScale);
  EXPECT_EQ(read.settings, session.settings);
  EXPECT_EQ(read.options, session.options);
}

TEST(RecordingGaze, IsACanonicalLog) {
  std::string text(kGazeHeader);
  gaze::GazeSample sample;
  sample.timeSeconds = 0.25;
  sample.position = {0.1, -3.0};
  sample.valid = true;
  appendGazeRow(sample, text);
  sample.timeSeconds = 0.5;
  sample.position = gaze::kNoPosition;
  sample.confidence = 0.75F;
  sample.pupilMillimetres = 3.5F;
  appendGazeRow(sample, text);
  EXPECT_EQ(text, "time_s,x,y,valid,confidence,pupil_mm\n0.25,0.1,-3,1,,\n0.5,,,0,0.75,3.5\n");
  std::istringstream in(text);
  const gaze::GazeLog log = gaze::readGazeLog(in, "gaze_raw.csv");
  EXPECT_EQ(log.format, "macula-csv");
  ASSERT_EQ(log.samples.size(), 2U);
  EXPECT_EQ(log.samples[0].position, glm::dvec2(0.1, -3.0));
  EXPECT_FALSE(log.samples[1].valid);
  EXPECT_EQ(log.startSeconds, 0.25);
}

}  // namespace
}  // namespace macula::recording
