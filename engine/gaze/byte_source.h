// Bytes of a log, in order and again from the start, whatever they are packed in.
#pragma once

#include <cstddef>
#include <istream>
#include <memory>
#include <string_view>

namespace macula::gaze {

/// A stream of bytes that can be read again.
class ByteSource {
 public:
  virtual ~ByteSource() = default;

  /// Reads up to `count` > 0 bytes.
  /// @returns how many were read; 0 only at the end
  /// @throws InputError where reading fails or the packing is damaged
  [[nodiscard]] virtual std::size_t read(char* bytes, std::size_t count) = 0;

  /// Back to the first byte. @throws InputError where the stream cannot
  virtual void rewind() = 0;
};

/// The text in a stream as UTF-8 without a byte order mark: gzip (any number of members) is
/// inflated, then UTF-16 is converted (by its mark, or by the zero beside a first ASCII character;
/// surrogates that have no partner become U+FFFD).
/// @param in must outlive the result
/// @param name stands in messages
/// @throws InputError saying what it is where it is no text
[[nodiscard]] std::unique_ptr<ByteSource> openText(std::istream& in, std::string_view name);

}  // namespace macula::gaze
