// A HID report descriptor as a list of fields (HID 1.11, 6.2.2). Pure: bytes in, plain data out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "engine/gaze/hid/usages.h"

namespace macula::gaze::hid {

/// Limits, so that no descriptor costs much memory or time. The first two are the Linux kernel's
/// own (HID_MAX_DESCRIPTOR_SIZE, HID_MAX_BUFFER_SIZE): nothing beyond them can arrive.
inline constexpr std::size_t kMaxDescriptorBytes = 4096;
inline constexpr std::size_t kMaxReportBytes = 16384;
inline constexpr std::size_t kMaxFields = 4096;
inline constexpr std::size_t kMaxCollectionDepth = 64;
inline constexpr std::size_t kMaxPushDepth = 16;

enum class ReportKind : std::uint8_t { Input, Output, Feature };

/// Bits of a main item's data (HID 1.11, 6.2.2.5).
namespace flag {
inline constexpr std::uint32_t kConstant = 1U << 0;
inline constexpr std::uint32_t kVariable = 1U << 1;
inline constexpr std::uint32_t kRelative = 1U << 2;
inline constexpr std::uint32_t kNullState = 1U << 6;
}  // namespace flag

/// A bound pair; empty where min >= max, as where a descriptor states none.
struct Bounds {
  std::int64_t min = 0;
  std::int64_t max = 0;

  [[nodiscard]] bool stated() const { return min < max; }
  bool operator==(const Bounds&) const = default;
};

/// One element of a report that some usage names. Padding has no usage and is no field; it shows
/// in the offsets alone. A Constant flag does not make a field padding: shipped trackers flag
/// their positions so.
struct Field {
  ReportKind kind = ReportKind::Input;
  std::uint8_t reportId = 0;     ///< 0 where the device does not number its reports
  std::uint32_t bitOffset = 0;   ///< behind the report id byte, where there is one
  std::uint32_t bitSize = 0;     ///< > 0
  std::uint32_t flags = 0;       ///< of namespace flag
  Usage usage = kNoUsage;        ///< of a Variable; an Array's element: its list's i-th usage
  std::int32_t collection = -1;  ///< innermost one, an index; -1 outside of all
  Bounds logical;
  Bounds physical;         ///< as stated; equal to logical where both bounds are 0 (6.2.2.7)
  std::uint32_t unit = 0;  ///< nibbles of 6.2.2.7; 0: none
  int unitExponent = 0;    ///< power of ten

  /// Two's complement: decided by the logical minimum (5.8).
  [[nodiscard]] bool isSigned() const { return logical.min < 0; }
};

/// A node of the tree of collections.
struct Collection {
  Usage usage = kNoUsage;
  std::uint8_t type = 0;  ///< 0 physical, 1 application, 2 logical, ... (6.2.2.6)
  std::int32_t parent = -1;
};

/// Length of one report.
struct ReportSize {
  ReportKind kind = ReportKind::Input;
  std::uint8_t reportId = 0;
  std::uint32_t bits = 0;  ///< without the id byte
};

struct Descriptor {
  std::vector<Collection> collections;  ///< parents before children
  std::vector<Field> fields;            ///< in the order of the descriptor
  std::vector<ReportSize> reports;
  bool numbered = false;  ///< every report begins with its id

  /// True where the field lies in a collection of that usage, at any depth.
  [[nodiscard]] bool isWithin(const Field& field, Usage collectionUsage) const;
  /// Bytes of a report as it travels, with its id where reports are numbered; 0: there is none.
  [[nodiscard]] std::size_t reportBytes(ReportKind kind, std::uint8_t reportId) const;
};

/// Parses a report descriptor.
/// @param name what to call the device in messages
/// @throws InputError naming the byte and what is wrong: a cut item, unbalanced collections, push
///   and pop or delimiters, report id 0, numbered and unnumbered reports mixed, limits exceeded
[[nodiscard]] Descriptor parseDescriptor(std::span<const std::uint8_t> bytes,
                                         std::string_view name);

}  // namespace macula::gaze::hid
