#include "engine/gaze/line_reader.h"

#include <cstring>

#include "engine/core/error.h"

namespace macula::gaze {

LineReader::LineReader(ByteSource& text, std::string_view name)
    : text_(text), name_(name), buffer_(2 * kLongestLine) {}

void LineReader::rewind() {
  text_.rewind();
  begin_ = end_ = number_ = 0;
  ended_ = false;
}

void LineReader::refill() {
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  const std::size_t got = text_.read(buffer_.data() + end_, buffer_.size() - end_);
  end_ += got;
  ended_ = got == 0;
}

bool LineReader::next(std::string_view& line) {
  std::size_t searched = 0;
  const char* newline = nullptr;
  while (true) {
    const std::size_t left = end_ - begin_;
    if (left > searched) {
      newline = static_cast<const char*>(
          std::memchr(buffer_.data() + begin_ + searched, '\n', left - searched));
    }
    searched = left;
    // Sources may give little at a time; a line is too long when none ends in this much.
    if (newline != nullptr || ended_ || left > kLongestLine) break;
    refill();
  }
  if (begin_ == end_) return false;

  const char* const first = buffer_.data() + begin_;
  const std::size_t length =
      newline == nullptr ? end_ - begin_ : static_cast<std::size_t>(newline - first);
  if (length > kLongestLine) {
    failInput("{}: line {}: longer than {} bytes, so not a gaze log; check the file", name_,
              number_ + 1, kLongestLine);
  }
  line = {first, length};
  begin_ += length + (newline == nullptr ? 0 : 1);
  ++number_;

  if (number_ == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
  while (line.ends_with('\r')) line.remove_suffix(1);
  return true;
}

}  // namespace macula::gaze
