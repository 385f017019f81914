#include "engine/gaze/line_reader.h"

#include <algorithm>
#include <cstring>

#include "engine/core/error.h"

namespace macula::gaze {

LineReader::LineReader(std::istream& in, std::string_view name)
    : in_(in), name_(name), buffer_(2 * kLongestLine) {}

void LineReader::refill() {
  std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
            buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
  end_ -= begin_;
  begin_ = 0;
  in_.read(buffer_.data() + end_, static_cast<std::streamsize>(buffer_.size() - end_));
  end_ += static_cast<std::size_t>(in_.gcount());
  if (in_.bad()) {
    failInput("{}: line {}: reading failed; check the disk and the permissions", name_,
              number_ + 1);
  }
}

bool LineReader::next(std::string_view& line) {
  const auto lineEnd = [&]() -> const char* {
    return end_ == begin_ ? nullptr
                          : static_cast<const char*>(
                                std::memchr(buffer_.data() + begin_, '\n', end_ - begin_));
  };
  const char* newline = lineEnd();
  if (newline == nullptr && in_.good()) {
    refill();
    newline = lineEnd();
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

  if (number_ == 1) {
    if (line.starts_with("\xFF\xFE") || line.starts_with("\xFE\xFF")) {
      failInput("{}: line 1: the text is UTF-16; save it as UTF-8", name_);
    }
    if (line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
  }
  if (line.ends_with('\r')) line.remove_suffix(1);
  return true;
}

}  // namespace macula::gaze
