// Recordings: any bytes give a session, frames, or one InputError; what is read and written again
// reads the same.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>

#include "engine/core/error.h"
#include "engine/recording/parse.h"
#include "engine/recording/text.h"

namespace {

using namespace macula::recording;

std::string textOf(const Recording& recording) {
  std::string text;
  for (const Frame& frame : recording.frames) appendFrameLine(frame, text);
  return text;
}

Recording framesOf(const std::string& text) {
  std::istringstream in(text);
  return parseFrames(in, "frames.jsonl");
}

void checkFrames(const std::string& bytes) {
  const std::string once = textOf(framesOf(bytes));
  if (textOf(framesOf(once)) != once) std::abort();
}

void checkSession(const std::string& bytes) {
  const std::string once = sessionText(parseSession(bytes, "session.json"));
  if (sessionText(parseSession(once, "session.json")) != once) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  try {
    checkFrames(bytes);
  } catch (const macula::InputError&) {
  }
  try {
    checkSession(bytes);
  } catch (const macula::InputError&) {
  }
  return 0;
}
