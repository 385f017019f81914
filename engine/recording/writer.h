// Writes a recording while it happens.
#pragma once

#include <filesystem>
#include <string>

#include "engine/gaze/log.h"
#include "engine/recording/recording.h"

namespace macula::recording {

/// A file that only grows. What was appended is in the hands of the operating system: it survives
/// the end of the program, however sudden.
class AppendedFile {
 public:
  /// @throws InputError where the file is there already or cannot be made
  explicit AppendedFile(std::filesystem::path path);
  ~AppendedFile();
  AppendedFile(const AppendedFile&) = delete;
  AppendedFile& operator=(const AppendedFile&) = delete;
  /// One write of all bytes. @throws InputError where not all of them fit
  void append(std::string_view bytes);

 private:
  std::filesystem::path path_;
  int descriptor_;
};

/// Checks that a recording can be made in this folder, and makes the folder.
/// @throws InputError where it holds a recording or cannot be written
void makeRecordingFolder(const std::filesystem::path& folder);

class RecordingWriter {
 public:
  /// Writes session.json.
  /// @param folder made by makeRecordingFolder()
  /// @throws InputError as makeRecordingFolder()
  RecordingWriter(const std::filesystem::path& folder, const Session& session);

  /// Appends a frame; its index is the number of frames before it. Allocates nothing once a line
  /// as long was written.
  void frame(const Frame& frame);
  /// Appends a sample of the gaze as it came.
  /// @param sample its time is that since the session's start
  void raw(const gaze::GazeSample& sample);

 private:
  AppendedFile frames_;
  AppendedFile gaze_;
  std::string line_;
};

}  // namespace macula::recording
