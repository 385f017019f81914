// Lines of a stream in bounded memory.
#pragma once

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace macula::gaze {

/// Gives the lines of a stream one at a time, ended by LF or CRLF or the end of the stream; a UTF-8
/// byte order mark is dropped.
class LineReader {
 public:
  /// A longer line is an error: rows of trackers have below 2,000 bytes, and what is no text must
  /// not fill the memory.
  static constexpr std::size_t kLongestLine = 65536;

  /// @param name stands in messages
  LineReader(std::istream& in, std::string_view name);

  /// Moves on to the next line.
  /// @param line points into the reader until the next call
  /// @returns false at the end
  /// @throws InputError where a line is too long, the text is UTF-16, or reading fails
  [[nodiscard]] bool next(std::string_view& line);

  /// Number of the line that next() gave last; the first is 1.
  [[nodiscard]] std::size_t number() const { return number_; }

 private:
  void refill();

  std::istream& in_;
  std::string name_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::size_t number_ = 0;
};

}  // namespace macula::gaze
