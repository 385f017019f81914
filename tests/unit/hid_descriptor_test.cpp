// The report-descriptor parser, on descriptors made by hand (HID 1.11, 6.2.2).
#include "engine/gaze/hid/descriptor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/core/error.h"
#include "tests/hid/tracker_descriptor.h"

namespace macula::gaze::hid {
namespace {

using testing::DescriptorBuilder;
using testing::kConstant;
using testing::kConstantVariable;
using testing::kDataVariable;

Descriptor parse(const DescriptorBuilder& builder) {
  return parseDescriptor(builder.bytes(), "test");
}

/// The message of the refusal.
std::string refusal(const std::vector<std::uint8_t>& bytes) {
  try {
    static_cast<void>(parseDescriptor(bytes, "test"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "taken";
}

// The mouse of HID 1.11, appendix E.10, byte for byte: three buttons, five bits of padding, X, Y.
TEST(HidDescriptor, ReadsTheMouseOfTheSpecification) {
  const std::vector<std::uint8_t> mouse{0x05, 0x01, 0x09, 0x02, 0xA1, 0x01, 0x09, 0x01, 0xA1, 0x00,
                                        0x05, 0x09, 0x19, 0x01, 0x29, 0x03, 0x15, 0x00, 0x25, 0x01,
                                        0x95, 0x03, 0x75, 0x01, 0x81, 0x02, 0x95, 0x01, 0x75, 0x05,
                                        0x81, 0x01, 0x05, 0x01, 0x09, 0x30, 0x09, 0x31, 0x15, 0x81,
                                        0x25, 0x7F, 0x75, 0x08, 0x95, 0x02, 0x81, 0x06, 0xC0, 0xC0};
  const Descriptor d = parseDescriptor(mouse, "mouse");
  ASSERT_EQ(d.fields.size(), 5U);
  EXPECT_FALSE(d.numbered);
  EXPECT_EQ(d.reportBytes(ReportKind::Input, 0), 3U);
  for (std::uint32_t i = 0; i < 3; ++i) {
    EXPECT_EQ(d.fields[i].usage, 0x00090001U + i);
    EXPECT_EQ(d.fields[i].bitOffset, i);
    EXPECT_FALSE(d.fields[i].isSigned());
  }
  EXPECT_EQ(d.fields[3].usage, 0x00010030U);
  EXPECT_EQ(d.fields[3].bitOffset, 8U);
  EXPECT_EQ(d.fields[4].bitOffset, 16U);
  EXPECT_EQ(d.fields[4].logical, (Bounds{-127, 127}));
  EXPECT_TRUE(d.fields[4].isSigned());
  EXPECT_EQ(d.fields[4].flags, flag::kVariable | flag::kRelative);
  ASSERT_EQ(d.collections.size(), 2U);
  EXPECT_EQ(d.collections[1].parent, 0);
  EXPECT_EQ(d.fields[4].collection, 1);
  EXPECT_TRUE(d.isWithin(d.fields[4], 0x00010002U));
  EXPECT_FALSE(d.isWithin(d.fields[4], 0x00010003U));
}

TEST(HidDescriptor, AConstantWithAUsageIsAFieldAndPaddingIsNot) {
  DescriptorBuilder b;
  b.usagePage(0x12).array(8, 3).input(kConstant);
  b.usage(0x21).array(16, 1).input(kConstantVariable);
  const Descriptor d = parse(b);
  ASSERT_EQ(d.fields.size(), 1U);
  EXPECT_EQ(d.fields[0].usage, trackerUsage(0x21));
  EXPECT_EQ(d.fields[0].bitOffset, 24U);
  EXPECT_EQ(d.reportBytes(ReportKind::Input, 0), 5U);
}

TEST(HidDescriptor, PushAndPopKeepGlobalsAndLocalsEndWithTheMainItem) {
  DescriptorBuilder b;
  b.usagePage(0x12).logical(0, 100).unit(0x11, -4).array(8, 1);
  b.push().usagePage(0x01).logical(-5, 5).unit(0x1001, -6).array(32, 2);
  b.usage(0x30).input(kDataVariable);
  b.pop().usage(0x21).input(kDataVariable);
  b.input(kConstant);  // no usage any more: padding
  const Descriptor d = parse(b);
  ASSERT_EQ(d.fields.size(), 3U);
  EXPECT_EQ(d.fields[0].usage, 0x00010030U);
  EXPECT_EQ(d.fields[1].usage, 0x00010030U);  // the last usage serves the rest
  EXPECT_EQ(d.fields[1].unit, 0x1001U);
  EXPECT_EQ(d.fields[1].unitExponent, -6);
  EXPECT_EQ(d.fields[2].usage, trackerUsage(0x21));
  EXPECT_EQ(d.fields[2].bitSize, 8U);
  EXPECT_EQ(d.fields[2].logical, (Bounds{0, 100}));
  EXPECT_EQ(d.fields[2].unitExponent, -4);
  EXPECT_EQ(d.fields[2].bitOffset, 64U);
  EXPECT_EQ(d.reportBytes(ReportKind::Input, 0), 10U);
}

TEST(HidDescriptor, ReportsAreCountedApartByKindAndId) {
  DescriptorBuilder b;
  b.usagePage(0x12).array(8, 2);
  b.reportId(1).usage(0x21).input(kDataVariable);
  b.reportId(2).usage(0x22).input(kDataVariable).usage(0x23).feature(kDataVariable);
  b.reportId(1).usage(0x23).input(kDataVariable);
  b.usage(0x21).output(kDataVariable);
  const Descriptor d = parse(b);
  ASSERT_EQ(d.fields.size(), 10U);
  EXPECT_TRUE(d.numbered);
  EXPECT_EQ(d.fields[6].bitOffset, 16U);  // behind what report 1 had before
  EXPECT_EQ(d.reportBytes(ReportKind::Input, 1), 5U);
  EXPECT_EQ(d.reportBytes(ReportKind::Input, 2), 3U);
  EXPECT_EQ(d.reportBytes(ReportKind::Feature, 2), 3U);
  EXPECT_EQ(d.reportBytes(ReportKind::Output, 1), 3U);
  EXPECT_EQ(d.reportBytes(ReportKind::Feature, 1), 0U);
}

TEST(HidDescriptor, AUsageOfFourBytesBringsItsPage) {
  DescriptorBuilder b;
  b.usagePage(0x01).array(8, 4);
  b.sized(0x08, 0x00120021, 4).sized(0x18, 0x00120300, 4).sized(0x28, 0x00120301, 4).usage(0x30);
  const Descriptor d = parse(b.input(kDataVariable));
  ASSERT_EQ(d.fields.size(), 4U);
  EXPECT_EQ(d.fields[0].usage, trackerUsage(0x21));
  EXPECT_EQ(d.fields[1].usage, trackerUsage(0x300));
  EXPECT_EQ(d.fields[2].usage, trackerUsage(0x301));
  EXPECT_EQ(d.fields[3].usage, 0x00010030U);
}

TEST(HidDescriptor, TheUsagePageIsTheOneAtTheMainItem) {
  DescriptorBuilder b;
  b.usagePage(0x01).usage(0x21).usagePage(0x12).array(8, 1).input(kDataVariable);
  EXPECT_EQ(parse(b).fields.at(0).usage, trackerUsage(0x21));
}

TEST(HidDescriptor, BoundsAreSignedWhereTheMinimumIsNegative) {
  DescriptorBuilder b;
  b.usagePage(0x12).array(8, 1);
  b.sized(0x14, 0, 1).sized(0x24, 0xFF, 1).usage(0x21).input(kDataVariable);
  b.sized(0x24, 0xFFFF, 2).sized(0x14, 0x80, 1).usage(0x21).input(kDataVariable);
  b.sized(0x14, 0, 0).sized(0x24, 0xFFFFFFFF, 4).usage(0x21).input(kDataVariable);
  const Descriptor d = parse(b);
  EXPECT_EQ(d.fields[0].logical, (Bounds{0, 255}));
  EXPECT_EQ(d.fields[1].logical, (Bounds{-128, -1}));
  EXPECT_EQ(d.fields[2].logical, (Bounds{0, 0xFFFFFFFFLL}));
  EXPECT_EQ(d.fields[2].physical, d.fields[2].logical);
}

TEST(HidDescriptor, UnitExponentsAreNibblesOrWholeNumbers) {
  DescriptorBuilder b;
  b.usagePage(0x12).array(8, 1);
  b.sized(0x54, 0x0C, 1).usage(0x21).input(kDataVariable);
  b.sized(0x54, 0xFA, 1).usage(0x21).input(kDataVariable);
  b.sized(0x54, 0x7FFFFFFF, 4).usage(0x21).input(kDataVariable);
  const Descriptor d = parse(b);
  EXPECT_EQ(d.fields[0].unitExponent, -4);
  EXPECT_EQ(d.fields[1].unitExponent, -6);
  EXPECT_EQ(d.fields[2].unitExponent, 127);
}

TEST(HidDescriptor, OfDelimitedUsagesTheFirstCounts) {
  DescriptorBuilder b;
  b.usagePage(0x12).array(8, 2);
  b.delimiter(true).usage(0x21).usage(0x22).delimiter(false).usage(0x23).input(kDataVariable);
  const Descriptor d = parse(b);
  EXPECT_EQ(d.fields.at(0).usage, trackerUsage(0x21));
  EXPECT_EQ(d.fields.at(1).usage, trackerUsage(0x23));
}

TEST(HidDescriptor, LongAndReservedItemsArePassedOver) {
  std::vector<std::uint8_t> bytes{0xFE, 0x02, 0x10, 0xAA, 0xBB, 0x0D, 0x00};
  DescriptorBuilder b;
  const auto rest = b.usagePage(0x12).usage(0x21).array(8, 1).input(kDataVariable).bytes();
  bytes.insert(bytes.end(), rest.begin(), rest.end());
  EXPECT_EQ(parseDescriptor(bytes, "test").fields.size(), 1U);
}

TEST(HidDescriptor, AnEmptyDescriptorHasNoFields) {
  EXPECT_TRUE(parseDescriptor({}, "test").fields.empty());
}

TEST(HidDescriptor, RefusesWhatIsMalformedAndNamesTheByte) {
  using ::testing::HasSubstr;
  EXPECT_THAT(refusal({0x05}), HasSubstr("ends within the item at byte 0"));
  EXPECT_THAT(refusal({0x05, 0x12, 0x27, 1, 2, 3}), HasSubstr("ends within the item at byte 2"));
  EXPECT_THAT(refusal({0xFE}), HasSubstr("ends within"));
  EXPECT_THAT(refusal({0xFE, 9, 0}), HasSubstr("ends within"));
  EXPECT_THAT(refusal({0xC0}), HasSubstr("byte 0: a collection ends that never began"));
  EXPECT_THAT(refusal({0xA1, 0x01}), HasSubstr("never closed"));
  EXPECT_THAT(refusal({0x05, 0x12, 0xB4}), HasSubstr("byte 2: pop without a push"));
  EXPECT_THAT(refusal({0x85, 0x00}), HasSubstr("report id"));
  EXPECT_THAT(refusal({0x29, 0x05}), HasSubstr("maximum without its minimum"));
  EXPECT_THAT(refusal({0x19, 0x05, 0x29, 0x04}), HasSubstr("below its minimum"));
  EXPECT_THAT(refusal({0xA9, 0x00}), HasSubstr("delimiters"));
  EXPECT_THAT(refusal({0xA9, 0x01, 0x81, 0x02}), HasSubstr("delimiter is never closed"));
  DescriptorBuilder mixed;
  mixed.array(8, 1).input(kConstant).reportId(1).input(kConstant);
  EXPECT_THAT(refusal(mixed.bytes()), HasSubstr("some reports have an id"));
}

TEST(HidDescriptor, MemoryIsBoundedWhateverTheDescriptorSays) {
  using ::testing::HasSubstr;
  EXPECT_THAT(refusal(std::vector<std::uint8_t>(kMaxDescriptorBytes + 1)), HasSubstr("4097 bytes"));
  DescriptorBuilder huge;
  huge.usagePage(0x12).usage(0x21).sized(0x74, 0xFFFFFFFF, 4).sized(0x94, 0xFFFFFFFF, 4);
  EXPECT_THAT(refusal(huge.input(kDataVariable).bytes()), HasSubstr("longer than any device"));
  DescriptorBuilder many;
  many.usagePage(0x12);
  for (int id = 1; id < 4; ++id) {
    many.reportId(id).usage(0x21).array(1, 2000).input(kDataVariable);
  }
  EXPECT_THAT(refusal(many.bytes()), HasSubstr("too many fields"));
  DescriptorBuilder deep;
  for (std::size_t i = 0; i <= kMaxCollectionDepth; ++i) deep.collection(0);
  EXPECT_THAT(refusal(deep.bytes()), HasSubstr("nested too deeply"));
  DescriptorBuilder pushes;
  for (std::size_t i = 0; i <= kMaxPushDepth; ++i) pushes.push();
  EXPECT_THAT(refusal(pushes.bytes()), HasSubstr("push is nested"));
}

}  // namespace
}  // namespace macula::gaze::hid
