// The items that a HID report descriptor is made of (HID 1.11, 6.2.2.1 to 6.2.2.3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace macula::gaze::hid {

enum class ItemType : std::uint8_t { Main = 0, Global = 1, Local = 2, Reserved = 3 };

/// Tags of the items that matter here; others are passed over.
namespace tag {
// Main
inline constexpr std::uint8_t kInput = 8;
inline constexpr std::uint8_t kOutput = 9;
inline constexpr std::uint8_t kCollection = 10;
inline constexpr std::uint8_t kFeature = 11;
inline constexpr std::uint8_t kEndCollection = 12;
// Global
inline constexpr std::uint8_t kUsagePage = 0;
inline constexpr std::uint8_t kLogicalMinimum = 1;
inline constexpr std::uint8_t kLogicalMaximum = 2;
inline constexpr std::uint8_t kPhysicalMinimum = 3;
inline constexpr std::uint8_t kPhysicalMaximum = 4;
inline constexpr std::uint8_t kUnitExponent = 5;
inline constexpr std::uint8_t kUnit = 6;
inline constexpr std::uint8_t kReportSize = 7;
inline constexpr std::uint8_t kReportId = 8;
inline constexpr std::uint8_t kReportCount = 9;
inline constexpr std::uint8_t kPush = 10;
inline constexpr std::uint8_t kPop = 11;
// Local
inline constexpr std::uint8_t kUsage = 0;
inline constexpr std::uint8_t kUsageMinimum = 1;
inline constexpr std::uint8_t kUsageMaximum = 2;
inline constexpr std::uint8_t kDelimiter = 10;
}  // namespace tag

/// One item. Its data are little-endian and 0, 1, 2 or 4 bytes long.
struct Item {
  ItemType type = ItemType::Reserved;
  std::uint8_t tag = 0;
  std::uint8_t bytes = 0;  ///< of data
  std::uint32_t data = 0;  ///< without sign
  std::size_t offset = 0;  ///< of the item in the descriptor

  /// The data with the sign that their size gives them.
  [[nodiscard]] std::int32_t signedData() const;
};

/// Reads a descriptor item by item. Long items (HID 1.11, 6.2.2.3) come out as Reserved.
class ItemReader {
 public:
  /// @param bytes must outlive the reader · @param name stands in messages
  ItemReader(std::span<const std::uint8_t> bytes, std::string_view name)
      : bytes_(bytes), name_(name) {}

  /// The next item, or nothing at the end.
  /// @throws InputError naming the byte where the descriptor ends within an item
  [[nodiscard]] std::optional<Item> next();

 private:
  std::span<const std::uint8_t> bytes_;
  std::string_view name_;
  std::size_t at_ = 0;
};

}  // namespace macula::gaze::hid
