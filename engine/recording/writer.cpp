#include "engine/recording/writer.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/recording/text.h"

namespace macula::recording {
namespace fs = std::filesystem;

namespace {

constexpr mode_t kFileMode = 0644;

}  // namespace

AppendedFile::AppendedFile(fs::path path)
    : path_(std::move(path)),
      descriptor_(
          ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, kFileMode)) {
  if (descriptor_ < 0) {
    failInput("{}: cannot be made ({}); record into a new folder", path_.string(),
              std::strerror(errno));
  }
}

AppendedFile::~AppendedFile() {
  ::close(descriptor_);
}

void AppendedFile::append(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      failInput("{}: cannot be written ({}); what was recorded so far can be replayed",
                path_.string(), std::strerror(errno));
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void makeRecordingFolder(const fs::path& folder) {
  for (const char* name : {kSessionFile, kFramesFile, kGazeFile}) {
    std::error_code error;
    if (fs::exists(folder / name, error)) {
      failInput("{}: holds a recording already; choose a new folder with --record",
                folder.string());
    }
  }
  makeOutputFolder(folder);
}

RecordingWriter::RecordingWriter(const fs::path& folder, const Session& session)
    : frames_((makeRecordingFolder(folder), folder / kFramesFile)), gaze_(folder / kGazeFile) {
  writeFileAtomically(folder / kSessionFile, sessionText(session));
  gaze_.append(kGazeHeader);
}

void RecordingWriter::frame(const Frame& frame) {
  line_.clear();
  appendFrameLine(frame, line_);
  frames_.append(line_);
}

void RecordingWriter::raw(const gaze::GazeSample& sample) {
  line_.clear();
  appendGazeRow(sample, line_);
  gaze_.append(line_);
}

}  // namespace macula::recording
