// Report descriptors of eye trackers, made by hand for tests: the unit tests, the fuzz targets and
// the device in the guest. Written item by item, apart from the parser that they test.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace macula::gaze::hid::testing {

/// Appends items of HID 1.11, 6.2.2. The prefixes are those of the specification's tables.
class DescriptorBuilder {
 public:
  DescriptorBuilder& item(std::uint8_t prefix, std::int64_t value) {
    const std::uint32_t data = static_cast<std::uint32_t>(value);
    const int bytes = value >= -128 && value <= 127 ? 1 : value >= -32768 && value <= 32767 ? 2 : 4;
    return sized(prefix, data, bytes);
  }
  /// The same with data of 0, 1, 2 or 4 bytes.
  DescriptorBuilder& sized(std::uint8_t prefix, std::uint32_t data, int bytes) {
    bytes_.push_back(static_cast<std::uint8_t>(prefix | (bytes == 4 ? 3 : bytes)));
    for (int i = 0; i < bytes; ++i) bytes_.push_back(static_cast<std::uint8_t>(data >> (8 * i)));
    return *this;
  }
  DescriptorBuilder& usagePage(std::int64_t page) { return item(0x04, page); }
  DescriptorBuilder& usage(std::int64_t id) { return item(0x08, id); }
  DescriptorBuilder& usageMin(std::int64_t id) { return item(0x18, id); }
  DescriptorBuilder& usageMax(std::int64_t id) { return item(0x28, id); }
  DescriptorBuilder& collection(int type) { return item(0xA0, type); }
  DescriptorBuilder& end() { return sized(0xC0, 0, 0); }
  DescriptorBuilder& reportId(std::int64_t id) { return item(0x84, id); }
  DescriptorBuilder& logical(std::int64_t min, std::int64_t max) {
    return item(0x14, min).item(0x24, max);
  }
  DescriptorBuilder& physical(std::int64_t min, std::int64_t max) {
    return item(0x34, min).item(0x44, max);
  }
  DescriptorBuilder& unit(std::int64_t unit, int exponent) {
    return item(0x64, unit).item(0x54, exponent & 0xF);
  }
  DescriptorBuilder& array(int bits, int count) { return item(0x74, bits).item(0x94, count); }
  DescriptorBuilder& input(int flags) { return item(0x80, flags); }
  DescriptorBuilder& output(int flags) { return item(0x90, flags); }
  DescriptorBuilder& feature(int flags) { return item(0xB0, flags); }
  DescriptorBuilder& push() { return sized(0xA4, 0, 0); }
  DescriptorBuilder& pop() { return sized(0xB4, 0, 0); }
  DescriptorBuilder& delimiter(bool opens) { return item(0xA8, opens ? 1 : 0); }

  [[nodiscard]] std::vector<std::uint8_t> bytes() const { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
};

inline constexpr int kDataVariable = 0x02;
inline constexpr int kConstantVariable = 0x03;
inline constexpr int kConstant = 0x01;
inline constexpr std::int64_t kInt32Max = 0x7FFFFFFF;

/// How shipped trackers differ.
struct TrackerVariant {
  bool wideTimestamp = false;        ///< one field of 64 bits instead of eight of 8
  int padBytes = 0;                  ///< in front of the timestamp
  int flags = kConstantVariable;     ///< of the gaze and eye fields
  std::int64_t gazeMax = kInt32Max;  ///< logical maximum of the gaze point
  bool configuration = true;         ///< has the calibrated display's size
};

/// A whole tracker: tracking data 0x10, capabilities 0x11, configuration 0x12, status 0x13 and
/// control 0x14, in micrometres and microseconds.
inline std::vector<std::uint8_t> trackerDescriptor(const TrackerVariant& variant = {}) {
  DescriptorBuilder d;
  const auto axes = [&](int parent, int first, int count, int flags) {
    d.usage(parent).collection(0);
    for (int i = 0; i < count; ++i) d.usage(first + i);
    d.array(32, count).input(flags).end();
  };
  d.usagePage(0x12).usage(0x01).collection(1);

  d.usage(0x10).collection(0).reportId(0x10);
  if (variant.padBytes > 0) d.array(8, variant.padBytes).input(kConstant);
  d.usage(0x20).unit(0x1001, -6);
  if (variant.wideTimestamp) {
    d.logical(0, kInt32Max).array(64, 1).input(kDataVariable);
  } else {
    d.logical(0, 255).array(8, 8).input(kDataVariable);
  }
  d.unit(0x11, -4).logical(0, variant.gazeMax);
  axes(0x24, 0x21, 2, variant.flags);
  d.logical(-kInt32Max - 1, kInt32Max);
  axes(0x25, 0x21, 3, variant.flags);
  axes(0x26, 0x21, 3, variant.flags);
  axes(0x27, 0x21, 3, variant.flags);
  d.unit(0, 0);
  axes(0x28, 0x29, 3, variant.flags);
  d.end();

  d.usage(0x11).collection(2).reportId(0x11);
  d.logical(0, 1).usage(0x100).array(8, 1).feature(kDataVariable);
  d.logical(0, kInt32Max).unit(0x11, -4);
  for (int id = 0x101; id <= 0x105; ++id) d.usage(id);
  d.array(32, 5).feature(kDataVariable).end();

  if (variant.configuration) {
    d.usage(0x12).collection(2).reportId(0x12).unit(0, 0).logical(0, 0xFFFF);
    d.usage(0x200).usage(0x201).array(16, 2).feature(kDataVariable);
    d.logical(0, kInt32Max).usage(0x202).array(32, 1).feature(kDataVariable);
    d.logical(0, 0xFFFF).usage(0x203).array(16, 1).feature(kDataVariable);
    d.unit(0x11, -4).logical(0, kInt32Max);
    d.usage(0x204).usage(0x205).array(32, 2).feature(kDataVariable).end();
  }

  d.usage(0x13).collection(2).reportId(0x13).unit(0, 0).logical(0, 4);
  d.usage(0x301).array(8, 1).input(kDataVariable);
  d.unit(0xF001, 0).logical(0, 0xFFFF).usage(0x300).array(16, 1).input(kDataVariable).end();

  d.usage(0x14).collection(2).reportId(0x14).unit(0, 0).logical(0, 7);
  d.usage(0x400).array(8, 1).feature(kDataVariable).end();
  return d.end().bytes();
}

inline void append(std::vector<std::uint8_t>& bytes, std::uint64_t number, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    bytes.push_back(i < 8 ? static_cast<std::uint8_t>(number >> (8 * i)) : std::uint8_t{0});
  }
}

/// A gaze report of trackerDescriptor(variant), in the units of the device.
inline std::vector<std::uint8_t> gazeReport(const TrackerVariant& variant, std::uint64_t time,
                                            std::int64_t x, std::int64_t y,
                                            std::int64_t eye = 600'000) {
  std::vector<std::uint8_t> bytes{0x10};
  append(bytes, 0, static_cast<std::size_t>(variant.padBytes));
  append(bytes, time, 8);
  append(bytes, static_cast<std::uint64_t>(x), 4);
  append(bytes, static_cast<std::uint64_t>(y), 4);
  for (int i = 0; i < 6; ++i) append(bytes, static_cast<std::uint64_t>(eye + i), 4);
  for (int i = 0; i < 6; ++i) append(bytes, static_cast<std::uint64_t>(kInt32Max), 4);
  return bytes;
}

/// Its configuration report: a display of that size in micrometres.
inline std::vector<std::uint8_t> configurationReport(std::uint64_t width, std::uint64_t height) {
  std::vector<std::uint8_t> bytes{0x12};
  append(bytes, 0, 10);
  append(bytes, width, 4);
  append(bytes, height, 4);
  return bytes;
}

/// Its status report.
inline std::vector<std::uint8_t> statusReport(std::uint8_t status, std::uint16_t hertz) {
  std::vector<std::uint8_t> bytes{0x13, status};
  append(bytes, hertz, 2);
  return bytes;
}

}  // namespace macula::gaze::hid::testing
