// Gaze logs whose format is found by content from any bytes.
#include "gaze_log_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace macula::gaze;
  return fuzzGazeLog(bytesOf(data, size), {});
}
