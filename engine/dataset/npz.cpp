#include "engine/dataset/npz.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <type_traits>

#include "engine/core/file.h"

namespace macula::dataset {
namespace {

/// Sides of an array at most: NumPy 1's NPY_MAXDIMS. It also keeps the header far below the 65,535
/// bytes of version 1.0.
constexpr std::size_t kMaxSides = 32;
/// The values begin at a multiple of this many bytes, as NumPy writes them.
constexpr std::size_t kAlignment = 64;
/// Magic, version and the header's length.
constexpr std::size_t kPreambleBytes = 10;

/// NumPy's name of a type: < is little endian, | has no order; f is a float, u a whole number; then
/// the bytes.
template <typename T>
constexpr std::string_view typeName() {
  if constexpr (std::is_same_v<T, float>) return "<f4";
  if constexpr (std::is_same_v<T, std::uint8_t>) return "|u1";
  if constexpr (std::is_same_v<T, std::uint16_t>) return "<u2";
  if constexpr (std::is_same_v<T, std::uint32_t>) return "<u4";
  if constexpr (std::is_same_v<T, std::uint64_t>) return "<u8";
}

/// A Python tuple; one of a single side keeps its comma.
std::string tupleOf(const std::vector<std::size_t>& shape) {
  std::string text = "(";
  for (const std::size_t side : shape) text += fmt::format("{}, ", side);
  if (!shape.empty()) text.pop_back();
  if (shape.size() > 1) text.pop_back();
  return text + ")";
}

/// The part of a .npy before the values.
std::string headerOf(std::string_view type, const std::vector<std::size_t>& shape) {
  std::string dictionary =
      fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': {}, }}", type, tupleOf(shape));
  const std::size_t used = kPreambleBytes + dictionary.size() + 1;  // with the line's end
  dictionary.append((kAlignment - used % kAlignment) % kAlignment, ' ');
  dictionary += '\n';
  const std::size_t length = dictionary.size();
  std::string header = "\x93NUMPY\x01";
  header += '\0';  // version 1.0
  header += static_cast<char>(length & 0xFFU);
  header += static_cast<char>(length >> 8U);
  return header + dictionary;
}

/// Whether the sides' product is `count`; one that overflows is not.
bool holds(const std::vector<std::size_t>& shape, std::size_t count) {
  if (std::find(shape.begin(), shape.end(), 0U) != shape.end()) return count == 0;
  std::size_t product = 1;
  for (const std::size_t side : shape) {
    if (product > count / side) return false;
    product *= side;
  }
  return product == count;
}

void appendLittleEndian(std::uint64_t bits, std::size_t bytes, std::string& out) {
  for (std::size_t i = 0; i < bytes; ++i) out += static_cast<char>((bits >> (8U * i)) & 0xFFU);
}

bool isName(std::string_view name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
}

}  // namespace

template <typename T>
void NpzWriter::addArray(std::string name, const std::vector<std::size_t>& shape,
                         std::span<const T> values) {
  if (!isName(name)) {
    throw std::invalid_argument("NpzWriter: '" + name +
                                "' is no name of letters, digits and underscores");
  }
  name += ".npy";
  if (std::any_of(entries_.begin(), entries_.end(),
                  [&](const ZipEntry& entry) { return entry.name == name; })) {
    throw std::invalid_argument("NpzWriter: '" + name + "' was added before");
  }
  if (shape.size() > kMaxSides || !holds(shape, values.size())) {
    throw std::invalid_argument(fmt::format("NpzWriter: '{}' of shape {} is given {} values", name,
                                            tupleOf(shape), values.size()));
  }
  std::string bytes = headerOf(typeName<T>(), shape);
  bytes.reserve(bytes.size() + values.size_bytes());
  for (const T value : values) {
    if constexpr (std::is_same_v<T, float>) {
      appendLittleEndian(std::bit_cast<std::uint32_t>(value), sizeof(T), bytes);
    } else {
      appendLittleEndian(value, sizeof(T), bytes);
    }
  }
  entries_.push_back({.name = std::move(name), .bytes = std::move(bytes)});
}

void NpzWriter::add(std::string name, const std::vector<std::size_t>& shape,
                    std::span<const float> values) {
  addArray(std::move(name), shape, values);
}

void NpzWriter::add(std::string name, const std::vector<std::size_t>& shape,
                    std::span<const std::uint8_t> values) {
  addArray(std::move(name), shape, values);
}

void NpzWriter::add(std::string name, const std::vector<std::size_t>& shape,
                    std::span<const std::uint16_t> values) {
  addArray(std::move(name), shape, values);
}

void NpzWriter::add(std::string name, const std::vector<std::size_t>& shape,
                    std::span<const std::uint32_t> values) {
  addArray(std::move(name), shape, values);
}

void NpzWriter::add(std::string name, const std::vector<std::size_t>& shape,
                    std::span<const std::uint64_t> values) {
  addArray(std::move(name), shape, values);
}

void NpzWriter::addText(std::string name, std::string_view text) {
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  addArray<std::uint8_t>(std::move(name), {bytes.size()}, bytes);
}

void NpzWriter::write(const std::filesystem::path& path) const {
  if (entries_.empty()) throw std::logic_error("NpzWriter: no array was added");
  writeFileAtomically(
      path, [&](const std::filesystem::path& temporary) { writeZip(temporary, path, entries_); });
}

}  // namespace macula::dataset
