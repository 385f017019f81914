#include "engine/gaze/byte_source.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/error.h"
#include "engine/gaze/foreign_file.h"

namespace macula::gaze {
namespace {

// Large enough that a call costs nothing beside the bytes, small enough for the second cache.
constexpr std::size_t kChunk = 65536;

class StreamSource final : public ByteSource {
 public:
  StreamSource(std::istream& in, std::string_view name)
      : in_(in), name_(name), start_(in.tellg()) {}

  std::size_t read(char* bytes, std::size_t count) override {
    if (!in_.good()) return 0;
    in_.read(bytes, static_cast<std::streamsize>(count));
    if (in_.bad()) failInput("{}: reading failed; check the disk and the permissions", name_);
    return static_cast<std::size_t>(in_.gcount());
  }

  void rewind() override {
    in_.clear();
    in_.seekg(start_);
    if (!in_) failInput("{}: cannot be read twice; save it to a regular file", name_);
  }

 private:
  std::istream& in_;
  std::string name_;
  std::istream::pos_type start_;
};

/// A source that is made of another one, whose bytes it takes in chunks.
class PackedSource : public ByteSource {
 public:
  PackedSource(std::unique_ptr<ByteSource> packed, std::string_view name)
      : name_(name), packed_(std::move(packed)), chunk_(kChunk) {}

  void rewind() override {
    packed_->rewind();
    begin_ = end_ = 0;
  }

 protected:
  /// Makes at least `count` bytes lie between begin_ and end_, unless the source ends first.
  void fetch(std::size_t count) {
    if (end_ - begin_ >= count) return;
    std::memmove(chunk_.data(), chunk_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
    while (end_ < count) {
      const std::size_t got = packed_->read(chunk_.data() + end_, chunk_.size() - end_);
      if (got == 0) return;
      end_ += got;
    }
  }

  std::string name_;
  std::unique_ptr<ByteSource> packed_;
  std::vector<char> chunk_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
};

/// Gives what it was given; looked into before it is known what it holds.
class PlainSource final : public PackedSource {
 public:
  using PackedSource::PackedSource;

  /// The first bytes, at most `count`; nothing is consumed.
  [[nodiscard]] std::string_view peek(std::size_t count) {
    fetch(count);
    return {chunk_.data() + begin_, std::min(count, end_ - begin_)};
  }
  void skip(std::size_t count) { begin_ += count; }

  std::size_t read(char* bytes, std::size_t count) override {
    if (begin_ == end_) return packed_->read(bytes, count);
    const std::size_t taken = std::min(count, end_ - begin_);
    std::memcpy(bytes, chunk_.data() + begin_, taken);
    begin_ += taken;
    return taken;
  }
};

class GzipSource final : public PackedSource {
 public:
  GzipSource(std::unique_ptr<ByteSource> packed, std::string_view name)
      : PackedSource(std::move(packed), name) {
    constexpr int kGzipOnly = 16;  // added to the window bits, see zlib.h
    if (inflateInit2(&stream_, MAX_WBITS + kGzipOnly) != Z_OK) {
      failInput("{}: no memory to inflate it; close other programs", name_);
    }
  }
  ~GzipSource() override { inflateEnd(&stream_); }
  GzipSource(const GzipSource&) = delete;
  GzipSource& operator=(const GzipSource&) = delete;

  std::size_t read(char* bytes, std::size_t count) override {
    stream_.next_out = reinterpret_cast<Bytef*>(bytes);
    stream_.avail_out = static_cast<uInt>(std::min<std::size_t>(count, kChunk));
    const uInt wanted = stream_.avail_out;
    while (stream_.avail_out == wanted) {
      fetch(1);
      if (begin_ == end_) {
        if (!between_) failInput("{}: the gzip data is cut off; copy the file again", name_);
        return 0;
      }
      if (between_ && chunk_[begin_] == '\0') {  // padding that tapes and copies leave
        ++begin_;
        continue;
      }
      stream_.next_in = reinterpret_cast<Bytef*>(chunk_.data() + begin_);
      stream_.avail_in = static_cast<uInt>(end_ - begin_);
      const int result = inflate(&stream_, Z_NO_FLUSH);
      begin_ = end_ - stream_.avail_in;
      between_ = result == Z_STREAM_END;
      if (between_) {
        inflateReset(&stream_);  // another member may follow
      } else if (result != Z_OK && result != Z_BUF_ERROR) {
        failInput("{}: the gzip data is damaged; copy the file again", name_);
      }
    }
    return wanted - stream_.avail_out;
  }

  void rewind() override {
    PackedSource::rewind();
    inflateReset(&stream_);
    between_ = true;
  }

 private:
  z_stream stream_{};
  bool between_ = true;  ///< no member has begun that has not ended
};

class Utf16Source final : public PackedSource {
 public:
  Utf16Source(std::unique_ptr<ByteSource> packed, std::string_view name, bool bigEndian)
      : PackedSource(std::move(packed), name), high_(bigEndian ? 0U : 1U) {}

  std::size_t read(char* bytes, std::size_t count) override {
    std::size_t written = 0;
    // A code point takes up to four bytes, so fewer left over go to the next call.
    while (written + 4 <= count) {
      fetch(4);
      if (end_ - begin_ < 2) break;  // half a unit at the end is a file that was cut off
      std::uint32_t code = unit(0);
      begin_ += 2;
      if (code >= 0xD800 && code < 0xE000) {
        const bool paired = code < 0xDC00 && end_ - begin_ >= 2 && (unit(0) & 0xFC00U) == 0xDC00U;
        if (paired) {
          code = 0x10000 + ((code - 0xD800) << 10U) + (unit(0) - 0xDC00);
          begin_ += 2;
        } else {
          code = 0xFFFD;
        }
      }
      if (code == 0xFEFF && first_) continue;
      first_ = false;
      written += encode(code, bytes + written);
    }
    return written;
  }

  void rewind() override {
    PackedSource::rewind();
    first_ = true;
  }

 private:
  [[nodiscard]] std::uint32_t unit(std::size_t at) const {
    const auto byte = [&](std::size_t i) {
      return static_cast<std::uint32_t>(static_cast<unsigned char>(chunk_[begin_ + at + i]));
    };
    return (byte(high_) << 8U) | byte(1U - high_);
  }

  static std::size_t encode(std::uint32_t code, char* out) {
    if (code < 0x80) {
      *out = static_cast<char>(code);
      return 1;
    }
    const std::size_t more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
    constexpr std::array<std::uint32_t, 4> kLead{0, 0xC0, 0xE0, 0xF0};
    out[0] = static_cast<char>(kLead[more] | (code >> (6U * static_cast<std::uint32_t>(more))));
    for (std::size_t i = 1; i <= more; ++i) {
      const auto shift = 6U * static_cast<std::uint32_t>(more - i);
      out[i] = static_cast<char>(0x80U | ((code >> shift) & 0x3FU));
    }
    return more + 1;
  }

  std::size_t high_;  ///< which byte of a unit is the high one
  bool first_ = true;
};

}  // namespace

std::unique_ptr<ByteSource> openText(std::istream& in, std::string_view name) {
  auto plain = std::make_unique<PlainSource>(std::make_unique<StreamSource>(in, name), name);
  if (plain->peek(2) == "\x1F\x8B") {
    auto inflated = std::make_unique<GzipSource>(std::move(plain), name);
    plain = std::make_unique<PlainSource>(std::move(inflated), name);
  }
  if (const auto foreign = foreignBytes(plain->peek(kForeignBytes))) {
    failInput("{}: {}", name, *foreign);
  }
  const std::string_view start = plain->peek(2);
  if (start.size() < 2) return plain;
  const bool big = start == "\xFE\xFF" || (start[0] == '\0' && start[1] != '\0');
  const bool little = start == "\xFF\xFE" || (start[0] != '\0' && start[1] == '\0');
  if (big || little) return std::make_unique<Utf16Source>(std::move(plain), name, big);
  return plain;
}

}  // namespace macula::gaze
