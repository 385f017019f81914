#include "engine/experiment/points_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "engine/core/error.h"
#include "engine/core/file.h"

namespace macula::experiment {
namespace {

std::string lineOf(const Point& point) {
  return point.dump(-1, ' ', false, Point::error_handler_t::replace) + "\n";
}

/// A file descriptor that is closed.
struct Descriptor {
  int fd;
  explicit Descriptor(int opened) : fd(opened) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd >= 0) ::close(fd);
  }
};

}  // namespace

PointsFile::PointsFile(std::filesystem::path path) : path_(std::move(path)) {
  if (!std::filesystem::exists(path_)) return;
  const std::string text = readTextFile(path_);
  std::string whole;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t newline = text.find('\n', begin);
    const std::size_t end = newline == std::string::npos ? text.size() : newline;
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    const Point point = Point::parse(line, nullptr, false);
    const bool good = newline != std::string::npos && point.is_object() && point.contains("key") &&
                      point["key"].is_string();
    if (good) {
      points_[point["key"].get<std::string>()] = point;
      whole += line + "\n";
    } else {
      ++damaged_;
    }
  }
  if (damaged_ > 0) writeFileAtomically(path_, whole);
}

const Point* PointsFile::find(const std::string& key) const {
  const auto found = points_.find(key);
  return found == points_.end() ? nullptr : &found->second;
}

void PointsFile::append(std::span<const Point> points) {
  std::string lines;
  for (const Point& point : points) lines += lineOf(point);
  constexpr int kMode = 0644;
  const Descriptor file(::open(path_.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, kMode));
  std::size_t done = 0;
  while (file.fd >= 0 && done < lines.size()) {
    const ssize_t written = ::write(file.fd, lines.data() + done, lines.size() - done);
    if (written < 0 && errno != EINTR) break;
    if (written > 0) done += static_cast<std::size_t>(written);
  }
  if (file.fd < 0 || done < lines.size() || ::fsync(file.fd) != 0) {
    failInput("{}: cannot be written ({}); check the folder and the space left", path_.string(),
              std::strerror(errno));
  }
  for (const Point& point : points) points_[point["key"].get<std::string>()] = point;
}

}  // namespace macula::experiment
