#include "tests/hid/device_process.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <stdexcept>

namespace macula::gaze::hid::testing {

DeviceProcess::DeviceProcess(const std::string& program) {
  std::array<int, 2> in{};
  std::array<int, 2> out{};
  if (::pipe2(in.data(), O_CLOEXEC) != 0 || ::pipe2(out.data(), O_CLOEXEC) != 0) {
    throw std::runtime_error("no pipe");
  }
  child_ = ::fork();
  if (child_ == 0) {
    ::dup2(in[0], STDIN_FILENO);
    ::dup2(out[1], STDOUT_FILENO);
    ::execl(program.c_str(), program.c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
  }
  ::close(in[0]);
  ::close(out[1]);
  to_ = ::fdopen(in[1], "w");
  from_ = ::fdopen(out[0], "r");
}

DeviceProcess::~DeviceProcess() {
  std::fclose(to_);  // the end of its input ends it
  std::fclose(from_);
  ::waitpid(child_, nullptr, 0);
}

void DeviceProcess::begin(const std::string& command) {
  std::fprintf(to_, "%s\n", command.c_str());
  std::fflush(to_);
}

std::string DeviceProcess::finish() {
  std::array<char, 256> line{};
  if (std::fgets(line.data(), static_cast<int>(line.size()), from_) == nullptr) {
    throw std::runtime_error("uhid_tracker has ended");
  }
  std::string answer(line.data());
  while (!answer.empty() && answer.back() == '\n') answer.pop_back();
  if (answer.rfind("ok", 0) != 0) throw std::runtime_error("uhid_tracker: " + answer);
  return answer.size() > 3 ? answer.substr(3) : "";
}

std::string DeviceProcess::obey(const std::string& command) {
  begin(command);
  return finish();
}

}  // namespace macula::gaze::hid::testing
