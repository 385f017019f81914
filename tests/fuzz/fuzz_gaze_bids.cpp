// BIDS recordings from any bytes: a JSON, a zero, and the rows that it describes.
#include "gaze_log_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace macula::gaze;
  const std::string bytes = bytesOf(data, size);
  const std::size_t zero = bytes.find('\0');
  if (zero == std::string::npos) return fuzzGazeLog(bytes, {.format = "bids"});
  return fuzzGazeLog(bytes.substr(zero + 1), {}, bytes.substr(0, zero));
}
