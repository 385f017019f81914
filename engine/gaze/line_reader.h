// Lines of a text in bounded memory.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "engine/gaze/byte_source.h"

namespace macula::gaze {

/// Gives the lines of a text one at a time, ended by LF (with any number of CR before it) or the
/// end of the text; a UTF-8 byte order mark is dropped.
class LineReader {
 public:
  /// A longer line is an error: rows of trackers have below 2,000 bytes, and what is no text must
  /// not fill the memory.
  static constexpr std::size_t kLongestLine = 65536;

  /// @param text must outlive the reader
  /// @param name stands in messages
  LineReader(ByteSource& text, std::string_view name);

  /// Moves on to the next line.
  /// @param line points into the reader until the next call
  /// @returns false at the end
  /// @throws InputError where a line is too long or reading fails
  [[nodiscard]] bool next(std::string_view& line);

  /// Number of the line that next() gave last; the first is 1.
  [[nodiscard]] std::size_t number() const { return number_; }

  /// Back to before the first line.
  void rewind();

 private:
  void refill();

  ByteSource& text_;
  std::string name_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::size_t number_ = 0;
  bool ended_ = false;
};

}  // namespace macula::gaze
