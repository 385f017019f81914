#include "engine/gaze/hid/item.h"

#include <array>

#include "engine/core/error.h"

namespace macula::gaze::hid {
namespace {

/// Prefix of a long item: its size and tag stand in the two bytes behind it.
constexpr std::uint8_t kLongItem = 0xFE;
constexpr std::size_t kLongHeaderBytes = 3;

constexpr std::array<std::uint8_t, 4> kDataBytes{0, 1, 2, 4};

}  // namespace

std::int32_t Item::signedData() const {
  switch (bytes) {
    case 1:
      return static_cast<std::int8_t>(data);
    case 2:
      return static_cast<std::int16_t>(data);
    default:
      return static_cast<std::int32_t>(data);
  }
}

std::optional<Item> ItemReader::next() {
  if (at_ >= bytes_.size()) return std::nullopt;
  const std::size_t left = bytes_.size() - at_;
  const std::uint8_t prefix = bytes_[at_];
  Item item{.offset = at_};
  std::size_t length = 0;
  if (prefix == kLongItem) {
    length = left < kLongHeaderBytes ? kLongHeaderBytes : kLongHeaderBytes + bytes_[at_ + 1];
  } else {
    item.type = static_cast<ItemType>((prefix >> 2) & 3);
    item.tag = static_cast<std::uint8_t>(prefix >> 4);
    item.bytes = kDataBytes[prefix & 3];
    length = 1U + item.bytes;
  }
  if (length > left) {
    failInput("{}: report descriptor ends within the item at byte {}", name_, at_);
  }
  for (std::size_t i = 0; i < item.bytes; ++i) {
    item.data |= std::uint32_t{bytes_[at_ + 1 + i]} << (8 * i);
  }
  at_ += length;
  return item;
}

}  // namespace macula::gaze::hid
