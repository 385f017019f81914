// uhid_tracker as a child process.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <string>

namespace macula::gaze::hid::testing {

class DeviceProcess {
 public:
  /// @param program path of uhid_tracker
  explicit DeviceProcess(const std::string& program);
  DeviceProcess(const DeviceProcess&) = delete;
  DeviceProcess& operator=(const DeviceProcess&) = delete;
  ~DeviceProcess();

  /// Sends a command and does not wait for its end.
  void begin(const std::string& command);
  /// Waits for the answer to the oldest command that has none yet: what follows "ok".
  /// Throws std::runtime_error where it is an error.
  std::string finish();
  std::string obey(const std::string& command);

 private:
  pid_t child_ = -1;
  std::FILE* to_ = nullptr;
  std::FILE* from_ = nullptr;
};

}  // namespace macula::gaze::hid::testing
