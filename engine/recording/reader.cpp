#include "engine/recording/reader.h"

#include <cerrno>
#include <cstring>
#include <fstream>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/recording/parse.h"

namespace macula::recording {
namespace fs = std::filesystem;

bool isRecording(const fs::path& folder) {
  std::error_code error;
  return fs::is_regular_file(folder / kSessionFile, error);
}

Recording readRecording(const fs::path& folder) {
  const fs::path session = folder / kSessionFile;
  const fs::path frames = folder / kFramesFile;
  Session read = parseSession(readTextFile(session), session.string());
  std::error_code error;
  if (!fs::is_regular_file(frames, error)) {
    failInput("{}: no such file; without it the recording holds no frame", frames.string());
  }
  std::ifstream in(frames, std::ios::binary);
  if (!in) {
    failInput("{}: cannot be read ({}); check its permissions", frames.string(),
              std::strerror(errno));
  }
  Recording recording = parseFrames(in, frames.string());
  recording.session = std::move(read);
  return recording;
}

}  // namespace macula::recording
