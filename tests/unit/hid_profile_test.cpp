// Tracker profiles: the shipped example through the decoder, and every kind of mistake.
#include "engine/gaze/hid/profile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/error.h"
#include "engine/gaze/hid/report.h"

namespace macula::gaze::hid {
namespace {

const std::string kMinimal = R"(name = "T"
vendor = 1
product = 2
report = { bytes = 9 }
x = { bit = 8, bits = 16 }
y = { bit = 24, bits = 16 }
)";

std::string refusal(const std::string& text) {
  try {
    static_cast<void>(parseProfile(text, "t.toml"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "taken";
}

TEST(HidProfile, TheExampleReadsByTheDecoder) {
  const TrackerProfile profile =
      readProfile(std::string(MACULA_SOURCE_DIR) + "/assets/trackers/example.toml");
  EXPECT_EQ(profile.name, "Example tracker");
  EXPECT_EQ(profile.vendorId, 0x1234);
  EXPECT_EQ(profile.productId, 0xABCD);
  EXPECT_EQ(profile.layout.startReport, (std::vector<std::uint8_t>{0x14, 0x03}));
  EXPECT_FALSE(profile.screenMm);  // pixels have no length
  ReportDecoder decoder(profile.layout);
  // id 5 · 2,000,000 us · x 1920 quarter pixels · y -432 · validity 1 · 6 bytes of no use here
  std::vector<std::uint8_t> report{5, 0x80, 0x84, 0x1E, 0, 0, 0, 0, 0, 0x80, 0x07, 0x50, 0xFE, 1};
  report.resize(20);
  HidGazeReport gaze;
  ASSERT_EQ(decoder.decode(report, gaze), ReportClass::Gaze);
  EXPECT_DOUBLE_EQ(gaze.deviceSeconds.value_or(0.0), 2.0);
  EXPECT_DOUBLE_EQ(gaze.position.x, 0.25);
  EXPECT_DOUBLE_EQ(gaze.position.y, -0.1);  // above the display
  EXPECT_TRUE(gaze.valid);
  report[13] = 0;
  ASSERT_EQ(decoder.decode(report, gaze), ReportClass::Gaze);
  EXPECT_TRUE(gaze.valid);
  report[13] = 4;
  ASSERT_EQ(decoder.decode(report, gaze), ReportClass::Gaze);
  EXPECT_FALSE(gaze.valid);
  report[0] = 6;
  EXPECT_EQ(decoder.decode(report, gaze), ReportClass::Garbage);
}

TEST(HidProfile, SharesAreTheDefaultAndNeedNoScreen) {
  const TrackerProfile profile = parseProfile(kMinimal + "valid = { bit = 64, bits = 1 }\n", "t");
  EXPECT_TRUE(profile.layout.gaze.shares);
  EXPECT_FALSE(profile.layout.numbered);
  ReportDecoder decoder(profile.layout);
  HidGazeReport gaze;
  const std::vector<std::uint8_t> report{0, 1, 0, 2, 0, 0, 0, 0, 1};
  ASSERT_EQ(decoder.decode(report, gaze), ReportClass::Gaze);
  EXPECT_EQ(gaze.position, (glm::dvec2{1.0, 2.0}));
  EXPECT_TRUE(gaze.valid);
}

TEST(HidProfile, BooleansAreThoseOfTheCommandLine) {
  const auto isSigned = [](const std::string& word) {
    std::string text = kMinimal;
    text.replace(text.find("bit = 8, "), 9, "bit = 8, signed = " + word + ", ");
    return parseProfile(text, "t").layout.gaze.x.isSigned;
  };
  for (const char* on : {"true", "\"on\"", "1"}) EXPECT_TRUE(isSigned(on)) << on;
  for (const char* off : {"false", "\"off\"", "0"}) EXPECT_FALSE(isSigned(off)) << off;
}

TEST(HidProfile, MillimetresNeedTheScreensSize) {
  const std::string text = "unit = \"um\"\n" + kMinimal;
  EXPECT_THAT(refusal(text), ::testing::HasSubstr("'screen.width' is missing"));
  const auto profile = parseProfile(text + "screen = { width = 500000, height = 300000 }\n", "t");
  ASSERT_TRUE(profile.screenMm);
  EXPECT_DOUBLE_EQ(profile.screenMm->x, 500.0);
  EXPECT_DOUBLE_EQ(profile.layout.gaze.x.scale, 1e-3);
}

TEST(HidProfile, MistakesAreToldWithFileAndLine) {
  using ::testing::HasSubstr;
  using ::testing::StartsWith;
  EXPECT_THAT(refusal("nam = \"T\"\n"), HasSubstr("name"));
  const std::string unknown = refusal(kMinimal + "tim = { bit = 1, bits = 2 }\n");
  EXPECT_THAT(unknown, StartsWith("t.toml:7"));
  EXPECT_THAT(unknown, HasSubstr("'tim' is not known; the nearest is 'time'"));
  EXPECT_THAT(refusal("name = \"T\"\nvendor = 70000\n"), StartsWith("t.toml:2"));
  EXPECT_THAT(refusal("name = \"T\"\nvendor = -2\n"), StartsWith("t.toml:2"));
  EXPECT_THAT(refusal("name = 5\n"), StartsWith("t.toml:1"));
  EXPECT_THAT(refusal("name = \"T\"\n"), HasSubstr("'vendor' is missing"));
  EXPECT_THAT(refusal("[x\n"), StartsWith("t.toml:"));
  const std::string beyond = refusal(kMinimal + "time = { bit = 60, bits = 64 }\n");
  EXPECT_THAT(beyond, StartsWith("t.toml:7"));
  EXPECT_THAT(beyond, HasSubstr("end at bit 124"));
  EXPECT_THAT(refusal(kMinimal + "time = { bits = 64 }\n"), HasSubstr("'time.bit' is missing"));
  EXPECT_THAT(refusal(kMinimal + "time = { bit = 4 }\n"), HasSubstr("'time.bits' is missing"));
  EXPECT_THAT(refusal(kMinimal + "valid = { bit = 64, bits = 1, min = 3, max = 2 }\n"),
              HasSubstr("valid.max"));
  EXPECT_THAT(refusal("start = \"1 4\"\n" + kMinimal), HasSubstr("t.toml:1: 'start'"));
  EXPECT_THAT(refusal("start = \"zz\"\n" + kMinimal), HasSubstr("list of bytes"));
}

}  // namespace
}  // namespace macula::gaze::hid
