// Arrays for training programs, in NumPy's .npz: a zip of .npy files (NumPy's NEP 1, version 1.0),
// little endian, in C order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/dataset/zip.h"

namespace macula::dataset {

/// Collects arrays and writes them as one file. The same arrays in the same order give the same
/// bytes, at any date and in any time zone, as long as zlib is the same.
class NpzWriter {
 public:
  /// Keeps a copy of an array.
  /// @param name letters, digits and underscores; the key of numpy.load()
  /// @param shape outermost side first; empty for a scalar; a side may be 0
  /// @param values as many as the product of the sides, the last index running fastest
  /// @throws std::invalid_argument where shape and values disagree, or the name is no such one or
  ///         was added before
  void add(std::string name, const std::vector<std::size_t>& shape, std::span<const float> values);
  void add(std::string name, const std::vector<std::size_t>& shape,
           std::span<const std::uint8_t> values);
  void add(std::string name, const std::vector<std::size_t>& shape,
           std::span<const std::uint16_t> values);
  void add(std::string name, const std::vector<std::size_t>& shape,
           std::span<const std::uint32_t> values);
  void add(std::string name, const std::vector<std::size_t>& shape,
           std::span<const std::uint64_t> values);

  /// A text, for example JSON, as a list of its UTF-8 bytes (uint8): NumPy's own texts are of fixed
  /// width and four bytes a character.
  void addText(std::string name, std::string_view text);

  /// Writes the file whole or not at all.
  /// @throws InputError naming the path where it cannot be written, or where this program was built
  ///         without MACULA_DATASET
  /// @throws std::logic_error where no array was added: a zip without files is none to libzip
  void write(const std::filesystem::path& path) const;

 private:
  template <typename T>
  void addArray(std::string name, const std::vector<std::size_t>& shape, std::span<const T> values);

  std::vector<ZipEntry> entries_;
};

}  // namespace macula::dataset
