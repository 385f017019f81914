// Where a tracker's values are found, one trap of shipped descriptors after the other.
#include "engine/gaze/hid/layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/core/error.h"
#include "tests/hid/tracker_descriptor.h"

namespace macula::gaze::hid {
namespace {

using testing::DescriptorBuilder;
using testing::kConstant;
using testing::kDataVariable;
using testing::kInt32Max;
using testing::trackerDescriptor;
using testing::TrackerVariant;

TrackerLayout layoutOf(const std::vector<std::uint8_t>& bytes) {
  return hid::layoutOf(parseDescriptor(bytes, "test"), "test");
}

std::string refusal(const std::vector<std::uint8_t>& bytes) {
  try {
    static_cast<void>(layoutOf(bytes));
  } catch (const InputError& error) {
    return error.what();
  }
  return "taken";
}

// Report 0x10: id, 8 bytes of time, gaze 2 x 32, left eye 3 x 32, ...: 65 bytes.
TEST(HidLayout, FindsConstantPositionsAndATimestampOfEightBytes) {
  const TrackerLayout layout = layoutOf(trackerDescriptor());
  EXPECT_TRUE(layout.numbered);
  EXPECT_EQ(layout.gaze.reportId, 0x10);
  EXPECT_EQ(layout.gaze.bytes, 65U);
  ASSERT_TRUE(layout.gaze.timestamp);
  EXPECT_EQ(layout.gaze.timestamp->bit, 8U);
  EXPECT_EQ(layout.gaze.timestamp->bits, 64U);
  EXPECT_DOUBLE_EQ(layout.gaze.timestamp->scale, 1e-6);
  EXPECT_EQ(layout.gaze.x.bit, 72U);
  EXPECT_EQ(layout.gaze.y.bit, 104U);
  EXPECT_DOUBLE_EQ(layout.gaze.x.scale, 1e-3);  // micrometres to millimetres
}

TEST(HidLayout, FindsATimestampOf64BitsBehindPadding) {
  const TrackerLayout layout =
      layoutOf(trackerDescriptor({.wideTimestamp = true, .padBytes = 7, .flags = kDataVariable}));
  EXPECT_EQ(layout.gaze.bytes, 72U);
  ASSERT_TRUE(layout.gaze.timestamp);
  EXPECT_EQ(layout.gaze.timestamp->bit, 64U);
  EXPECT_EQ(layout.gaze.timestamp->bits, 64U);
  EXPECT_EQ(layout.gaze.x.bit, 128U);
}

TEST(HidLayout, TellsTheRepeatedAxesApartByTheirParents) {
  const TrackerLayout layout = layoutOf(trackerDescriptor());
  ASSERT_TRUE(layout.gaze.leftEye);
  ASSERT_TRUE(layout.gaze.rightEye);
  EXPECT_EQ((*layout.gaze.leftEye)[0].bit, 136U);
  EXPECT_EQ((*layout.gaze.rightEye)[0].bit, 232U);
  EXPECT_EQ((*layout.gaze.rightEye)[2].bit, 296U);
  EXPECT_TRUE((*layout.gaze.leftEye)[0].isSigned);
}

TEST(HidLayout, EyesInFrontOfTheGazeAreNotTakenForIt) {
  DescriptorBuilder b;
  b.usagePage(0x12).usage(1).collection(1).usage(0x10).collection(0).array(32, 2);
  b.usage(0x25).collection(0).usage(0x21).usage(0x22).input(kDataVariable).end();
  b.usage(0x24).collection(0).usage(0x22).usage(0x21).input(kDataVariable).end().end().end();
  const TrackerLayout layout = layoutOf(b.bytes());
  EXPECT_EQ(layout.gaze.y.bit, 64U);  // Y comes first here
  EXPECT_EQ(layout.gaze.x.bit, 96U);
  EXPECT_FALSE(layout.gaze.leftEye);  // without a Z it is no place
  EXPECT_FALSE(layout.numbered);
  EXPECT_FALSE(layout.gaze.timestamp);
}

TEST(HidLayout, FindsFeaturesAndStatus) {
  const TrackerLayout layout = layoutOf(trackerDescriptor());
  ASSERT_TRUE(layout.screenWidth);
  ASSERT_TRUE(layout.screenHeight);
  EXPECT_EQ(layout.screenWidth->kind, ReportKind::Feature);
  EXPECT_EQ(layout.screenWidth->reportId, 0x12);
  EXPECT_EQ(layout.screenWidth->bytes, 19U);
  EXPECT_EQ(layout.screenWidth->value.bit, 88U);
  EXPECT_EQ(layout.screenHeight->value.bit, 120U);
  ASSERT_TRUE(layout.status);
  EXPECT_EQ(layout.status->kind, ReportKind::Input);
  EXPECT_EQ(layout.status->bytes, 4U);
  ASSERT_TRUE(layout.samplingHz);
  EXPECT_EQ(layout.samplingHz->value.bit, 16U);
  EXPECT_DOUBLE_EQ(layout.samplingHz->value.scale, 1.0);
  ASSERT_TRUE(layout.modeRequest);
  EXPECT_EQ(layout.modeRequest->reportId, 0x14);
  EXPECT_EQ(layout.mode, kModeGaze | kModeEyes);
  ASSERT_TRUE(layout.quality);
  EXPECT_EQ(layout.quality->reportId, 0x11);
  EXPECT_EQ(layout.inputs.size(), 2U);
}

TEST(HidLayout, AModeOfOneBitAsksForGazeAlone) {
  DescriptorBuilder b;
  b.usagePage(0x12).usage(1).collection(1).array(32, 2).usage(0x24).collection(0);
  b.usage(0x21).usage(0x22).input(kDataVariable).end();
  b.usage(0x400).logical(0, 1).array(8, 1).feature(kDataVariable).end();
  EXPECT_EQ(layoutOf(b.bytes()).mode, kModeGaze);
}

TEST(HidLayout, UnitsAndRangesAreApplied) {
  DescriptorBuilder b;
  b.usagePage(0x12).usage(0x24).collection(0);
  // Half-tenths of a millimetre: 0..4000 stand for 0..2000 in units of 10^-2 cm.
  b.unit(0x11, -2).logical(0, 4000).physical(0, 2000).usage(0x21).array(16, 1).input(kDataVariable);
  // Thousandths of an inch, shifted: 0..1000 stand for 1000..2000.
  b.unit(0x13, -3).logical(0, 1000).physical(1000, 2000).usage(0x22).input(kDataVariable);
  b.end().physical(0, 0).unit(0x1001, -3).logical(0, 0).usage(0x20).array(32, 1);
  b.input(kDataVariable);
  const TrackerLayout layout = layoutOf(b.bytes());
  EXPECT_DOUBLE_EQ(layout.gaze.x.scale, 0.05);
  EXPECT_DOUBLE_EQ(layout.gaze.y.scale, 0.0254);
  EXPECT_DOUBLE_EQ(layout.gaze.y.offset, 25.4);
  ASSERT_TRUE(layout.gaze.timestamp);
  EXPECT_DOUBLE_EQ(layout.gaze.timestamp->scale, 1e-3);
  EXPECT_FALSE(layout.statedScreenMm);  // Y does not begin at the edge
}

TEST(HidLayout, TheRangeOfTheTypeIsNoDisplay) {
  EXPECT_FALSE(layoutOf(trackerDescriptor()).statedScreenMm);  // 0..INT32_MAX um: two kilometres
  const auto stated = layoutOf(trackerDescriptor({.gazeMax = 500'000})).statedScreenMm;
  ASSERT_TRUE(stated);
  EXPECT_DOUBLE_EQ(stated->x, 500.0);
}

TEST(HidLayout, ATimestampInPiecesThatDoNotFollowEachOtherIsNone) {
  DescriptorBuilder b;
  b.usagePage(0x12).usage(0x24).collection(0).array(32, 2);
  b.usage(0x21).usage(0x22).input(kDataVariable).end();
  b.array(8, 1).usage(0x20).input(kDataVariable).input(kConstant).usage(0x20).input(kDataVariable);
  EXPECT_FALSE(layoutOf(b.bytes()).gaze.timestamp);
}

TEST(HidLayout, RefusesWhatHasNoGaze) {
  using ::testing::HasSubstr;
  EXPECT_THAT(refusal({}), HasSubstr("no gaze point"));
  DescriptorBuilder loose;  // X and Y, but of an eye
  loose.usagePage(0x12).usage(0x25).collection(0).array(32, 2).usage(0x21).usage(0x22);
  EXPECT_THAT(refusal(loose.input(kDataVariable).end().bytes()), HasSubstr("no gaze point"));
  DescriptorBuilder half;
  half.usagePage(0x12).usage(0x24).collection(0).array(32, 1).usage(0x21).input(kDataVariable);
  EXPECT_THAT(refusal(half.end().bytes()), HasSubstr("no Y"));
  DescriptorBuilder degrees;
  degrees.usagePage(0x12).usage(0x24).collection(0).unit(0x14, 0).array(32, 2);
  degrees.usage(0x21).usage(0x22).input(kDataVariable).end();
  EXPECT_THAT(refusal(degrees.bytes()), HasSubstr("0x14, which is no length"));
  DescriptorBuilder apart;
  apart.usagePage(0x12).usage(0x24).collection(0).array(32, 1);
  apart.reportId(1).usage(0x21).input(kDataVariable).reportId(2).usage(0x22).input(kDataVariable);
  EXPECT_THAT(refusal(apart.end().bytes()), HasSubstr("same report"));
}

}  // namespace
}  // namespace macula::gaze::hid
