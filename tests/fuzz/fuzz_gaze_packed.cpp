// Packed and encoded logs: any bytes as they are (gzip, UTF-16, or neither), and text that is
// packed here, which must give the same log as the plain text.
#include <zlib.h>

#include <optional>
#include <vector>

#include "gaze_log_fuzz.h"

namespace {

using namespace macula::gaze;

std::string utf16(const std::string& text, bool bigEndian) {
  std::string bytes = bigEndian ? "\xFE\xFF" : "\xFF\xFE";
  for (const char c : text) {
    if (bigEndian) bytes += '\0';
    bytes += c;
    if (!bigEndian) bytes += '\0';
  }
  return bytes;
}

std::string gzip(std::string text) {
  z_stream stream{};
  requireThat(deflateInit2(&stream, 1, Z_DEFLATED, MAX_WBITS + 16, 8, Z_DEFAULT_STRATEGY) == Z_OK);
  std::vector<Bytef> out(text.size() + 1000);
  stream.next_in = reinterpret_cast<Bytef*>(text.data());
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = out.data();
  stream.avail_out = static_cast<uInt>(out.size());
  requireThat(deflate(&stream, Z_FINISH) == Z_STREAM_END);
  const std::size_t size = out.size() - stream.avail_out;
  deflateEnd(&stream);
  return {reinterpret_cast<const char*>(out.data()), size};
}

/// The canonical text of a log; nothing where it is refused.
std::optional<std::string> canonical(const std::string& bytes) {
  try {
    return canonicalCsv(readFuzzed(bytes, {}));
  } catch (const macula::InputError&) {
    return std::nullopt;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes = bytesOf(data, size);
  (void)fuzzGazeLog(bytes, {});

  // Plain ASCII, so that no encoding changes it and none is seen in it.
  std::string text = "time_s,x,y,valid\n";
  for (const char c : bytes) text += static_cast<char>(static_cast<unsigned char>(c) & 0x7FU);
  for (char& c : text) c = c == '\0' ? ' ' : c;
  const std::optional<std::string> plain = canonical(text);
  requireThat(canonical(gzip(text)) == plain);
  requireThat(canonical(utf16(text, false)) == plain);
  requireThat(canonical(gzip(utf16(text, true))) == plain);
  return 0;
}
