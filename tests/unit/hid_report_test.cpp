// From bytes to gaze: bits, nulls, garbage, the device's clock, and a session as a whole.
#include "engine/gaze/hid/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/gaze/hid/session.h"
#include "tests/hid/tracker_descriptor.h"

namespace macula::gaze::hid {
namespace {

using testing::gazeReport;
using testing::kInt32Max;
using testing::statusReport;
using testing::trackerDescriptor;
using testing::TrackerVariant;

TrackerLayout layoutFor(const TrackerVariant& variant) {
  return layoutOf(parseDescriptor(trackerDescriptor(variant), "test"), "test");
}

/// A decoder for a display of 500 x 300 mm.
ReportDecoder decoderFor(const TrackerVariant& variant) {
  ReportDecoder decoder(layoutFor(variant));
  decoder.setScreen({500.0, 300.0});
  return decoder;
}

TEST(HidScalar, ReadsBitsThatBeginAnywhere) {
  const std::vector<std::uint8_t> bytes{0xB5, 0x4E, 0xFF, 0, 0, 0, 0, 0, 0x80, 0x01};
  EXPECT_EQ(rawNumber({.bit = 0, .bits = 8}, bytes), 0xB5);
  EXPECT_EQ(rawNumber({.bit = 4, .bits = 8}, bytes), 0xEB);  // low nibble of 4E, high of B5
  EXPECT_EQ(rawNumber({.bit = 0, .bits = 1}, bytes), 1);
  EXPECT_EQ(rawNumber({.bit = 0, .bits = 1, .isSigned = true}, bytes), -1);
  EXPECT_EQ(rawNumber({.bit = 16, .bits = 8, .isSigned = true}, bytes), -1);
  // 64 bits over nine bytes: bit 67 of the report (bit 3 of 0x80: 0) ... up to bit 71 (1).
  EXPECT_EQ(rawNumber({.bit = 8, .bits = 64}, bytes),
            static_cast<std::int64_t>(0x800000000000FF4EULL));
  EXPECT_EQ(rawNumber({.bit = 12, .bits = 64}, bytes),
            static_cast<std::int64_t>(0x1800000000000FF4ULL));
  EXPECT_EQ(readScalar({.bit = 8, .bits = 64}, bytes), static_cast<double>(0x800000000000FF4EULL));
}

TEST(HidScalar, WhatLiesBeyondTheBytesIsNull) {
  const std::vector<std::uint8_t> bytes(4, 1);
  EXPECT_TRUE(readScalar({.bit = 24, .bits = 8}, bytes));
  EXPECT_FALSE(readScalar({.bit = 25, .bits = 8}, bytes));
  EXPECT_FALSE(readScalar({.bit = 4'000'000'000U, .bits = 64}, bytes));
  EXPECT_FALSE(readScalar({.bit = 0, .bits = 0}, bytes));
  EXPECT_FALSE(readScalar({.bit = 0, .bits = 65}, std::vector<std::uint8_t>(20)));
}

TEST(HidScalar, WritesWhatItReads) {
  std::vector<std::uint8_t> bytes(4, 0xFF);
  const Scalar scalar{.bit = 5, .bits = 11};
  writeRaw(scalar, 0x2A5, bytes);
  EXPECT_EQ(rawNumber(scalar, bytes), 0x2A5);
  EXPECT_EQ(bytes[0] & 0x1F, 0x1F);
  EXPECT_EQ(bytes[2], 0xFF);
  writeRaw({.bit = 30, .bits = 8}, 0, bytes);  // does not fit: nothing happens
  EXPECT_EQ(bytes[3], 0xFF);
}

class HidVariants : public ::testing::TestWithParam<TrackerVariant> {};

TEST_P(HidVariants, AreReadAlike) {
  ReportDecoder decoder = decoderFor(GetParam());
  HidGazeReport gaze;
  const auto report = gazeReport(GetParam(), 1'234'567'890'123, 125'000, 225'000);
  ASSERT_EQ(decoder.decode(report, gaze), ReportClass::Gaze);
  EXPECT_TRUE(gaze.valid);
  EXPECT_DOUBLE_EQ(gaze.position.x, 0.25);
  EXPECT_DOUBLE_EQ(gaze.position.y, 0.75);
  ASSERT_TRUE(gaze.deviceSeconds);
  EXPECT_DOUBLE_EQ(*gaze.deviceSeconds, 1'234'567.890123);
  ASSERT_TRUE(gaze.leftEyeMm && gaze.rightEyeMm);
  EXPECT_DOUBLE_EQ(gaze.leftEyeMm->x, 600.0);
  EXPECT_DOUBLE_EQ(gaze.rightEyeMm->z, 600.005);
}

INSTANTIATE_TEST_SUITE_P(Descriptors, HidVariants,
                         ::testing::Values(TrackerVariant{}, TrackerVariant{.padBytes = 7},
                                           TrackerVariant{.wideTimestamp = true},
                                           TrackerVariant{.wideTimestamp = true, .padBytes = 7},
                                           TrackerVariant{.flags = testing::kDataVariable}));

TEST(HidReport, NullIsNoPlace) {
  ReportDecoder decoder = decoderFor({.gazeMax = 500'000});
  HidGazeReport gaze;
  const auto valid = [&](std::int64_t x, std::int64_t y) {
    EXPECT_EQ(decoder.decode(gazeReport({}, 1, x, y), gaze), ReportClass::Gaze);
    EXPECT_EQ(gaze.valid, !std::isnan(gaze.position.x));
    return gaze.valid;
  };
  EXPECT_TRUE(valid(500'000, 0));
  EXPECT_FALSE(valid(500'001, 0));  // beyond the logical maximum
  EXPECT_FALSE(valid(-1, 0));       // below the minimum: a sign that this range has not
  EXPECT_FALSE(valid(0, kInt32Max));
  ReportDecoder whole = decoderFor({});  // here INT32_MAX lies within the range
  ASSERT_EQ(whole.decode(gazeReport({}, 1, kInt32Max, 5), gaze), ReportClass::Gaze);
  EXPECT_FALSE(gaze.valid);
  ASSERT_EQ(whole.decode(gazeReport({}, 1, 5, 5, kInt32Max), gaze), ReportClass::Gaze);
  EXPECT_TRUE(gaze.valid);
  EXPECT_FALSE(gaze.leftEyeMm);
}

TEST(HidReport, WithoutTheDisplaysSizeThereIsNoPlace) {
  ReportDecoder decoder(layoutFor({}));
  HidGazeReport gaze;
  ASSERT_EQ(decoder.decode(gazeReport({}, 1, 5, 5), gaze), ReportClass::Gaze);
  EXPECT_FALSE(gaze.valid);
  EXPECT_TRUE(std::isnan(gaze.position.x));
}

TEST(HidReport, GarbageIsToldFromReports) {
  ReportDecoder decoder = decoderFor({});
  HidGazeReport gaze;
  auto report = gazeReport({}, 1, 5, 5);
  EXPECT_EQ(decoder.decode({}, gaze), ReportClass::Garbage);
  EXPECT_EQ(decoder.decode(std::vector<std::uint8_t>{0x77, 1, 2}, gaze), ReportClass::Garbage);
  EXPECT_EQ(decoder.decode(std::vector<std::uint8_t>{0x10}, gaze), ReportClass::Garbage);
  EXPECT_EQ(decoder.decode(std::span(report).first(64), gaze), ReportClass::Garbage);
  report.resize(128);  // padded by the transport
  EXPECT_EQ(decoder.decode(report, gaze), ReportClass::Gaze);
  report.back() = 1;
  EXPECT_EQ(decoder.decode(report, gaze), ReportClass::Garbage);
}

TEST(HidReport, StatusIsKept) {
  ReportDecoder decoder = decoderFor({});
  HidGazeReport gaze;
  EXPECT_EQ(decoder.decode(statusReport(4, 133), gaze), ReportClass::Status);
  EXPECT_EQ(decoder.condition().status, ConfigurationStatus::CalibrationNeeded);
  EXPECT_DOUBLE_EQ(decoder.condition().samplingHz, 133.0);
  EXPECT_EQ(decoder.decode(statusReport(200, 133), gaze), ReportClass::Status);
  EXPECT_EQ(decoder.condition().status, ConfigurationStatus::Unknown);
}

TEST(HidReport, TheConfigurationTellsTheDisplay) {
  const TrackerLayout layout = layoutFor({});
  const auto size = screenSize(layout, testing::configurationReport(597'000, 336'000));
  ASSERT_TRUE(size);
  EXPECT_DOUBLE_EQ(size->x, 597.0);
  EXPECT_DOUBLE_EQ(size->y, 336.0);
  EXPECT_FALSE(screenSize(layout, testing::configurationReport(0, 336'000)));
  EXPECT_FALSE(screenSize(layout, std::vector<std::uint8_t>{0x12, 1, 2}));
  EXPECT_FALSE(screenSize(layoutFor({.configuration = false}), std::vector<std::uint8_t>(19)));
}

TEST(HidSession, AsksForWhatIsMissingAndTakesTheDevicesWordFirst) {
  using ::testing::HasSubstr;
  Session session(layoutFor({}), {});
  EXPECT_THAT(session.note(""), HasSubstr("size of its calibrated display is not known"));
  EXPECT_FALSE(session.take(gazeReport({}, 1, 5, 5), 0.0).sample.valid);
  session.learn(glm::dvec2{500.0, 300.0}, "");
  EXPECT_EQ(session.note(""), "");
  const auto taken = session.take(gazeReport({}, 1, 250'000, 30'000), 0.1);
  EXPECT_TRUE(taken.sample.valid);
  EXPECT_DOUBLE_EQ(taken.sample.position.x, 0.5);
  EXPECT_DOUBLE_EQ(taken.sample.position.y, 0.1);

  TrackerChoice choice;
  choice.screenMm = glm::dvec2{400.0, 200.0};
  Session chosen(layoutFor({.gazeMax = 600'000}), choice);
  EXPECT_EQ(chosen.screenMm(), choice.screenMm);
  chosen.learn(glm::dvec2{500.0, 300.0}, "it answers slowly");
  EXPECT_EQ(chosen.screenMm(), (glm::dvec2{500.0, 300.0}));
  EXPECT_EQ(chosen.note("first"), "first; it answers slowly");
  Session stated(layoutFor({.gazeMax = 600'000}), {});
  EXPECT_EQ(stated.screenMm(), (glm::dvec2{600.0, 600.0}));
  EXPECT_THAT(stated.note(""), HasSubstr("range of its reports"));
}

TEST(HidSession, ReadyAfterACalibrationAsksAgain) {
  Session session(layoutFor({}), {});
  const auto status = [&session](std::uint8_t value) {
    EXPECT_TRUE(session.take(statusReport(value, 60), 0.0).news);
    return session.takeCalibrated();
  };
  EXPECT_FALSE(status(1));  // the first word: nothing has changed
  EXPECT_FALSE(status(4));
  EXPECT_THAT(session.note(""), ::testing::HasSubstr("needs a calibration"));
  EXPECT_FALSE(status(2));
  EXPECT_TRUE(status(1));
  EXPECT_FALSE(session.takeCalibrated());
  EXPECT_FALSE(status(1));
}

}  // namespace
}  // namespace macula::gaze::hid
