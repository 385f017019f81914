#include "engine/gaze/hid/link.h"

#include <fcntl.h>
#include <linux/hidraw.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace macula::gaze::hid {
namespace {

/// The request number of a feature ioctl holds its length in so many bits.
constexpr std::size_t kMaxIoctlBytes = (std::size_t{1} << _IOC_SIZEBITS) - 1;

}  // namespace

HidrawLink::HidrawLink(const std::string& path) {
  file_ = ::open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (file_ < 0) error_ = errno;
}

HidrawLink::~HidrawLink() {
  if (file_ >= 0) ::close(file_);
}

HidrawLink::Read HidrawLink::read(std::span<std::uint8_t> bytes, std::size_t& length,
                                  int timeoutMilliseconds) const {
  for (int attempt = 0; attempt < 2; ++attempt) {
    const ssize_t got = ::read(file_, bytes.data(), bytes.size());
    if (got >= 0) {
      length = static_cast<std::size_t>(got);
      return Read::Report;
    }
    if (errno != EAGAIN && errno != EINTR) return Read::Gone;
    if (attempt > 0) break;
    pollfd waited{.fd = file_, .events = POLLIN, .revents = 0};
    if (::poll(&waited, 1, timeoutMilliseconds) <= 0) break;
  }
  return Read::Nothing;
}

std::vector<std::uint8_t> HidrawLink::getFeature(std::uint8_t reportId, std::size_t bytes) const {
  // Without a number the id byte is still there, as 0, in front of the report.
  std::vector<std::uint8_t> report(bytes + (reportId == 0 ? 1U : 0U));
  if (report.empty() || report.size() > kMaxIoctlBytes) return {};
  report.front() = reportId;
  const int got = ::ioctl(file_, HIDIOCGFEATURE(report.size()), report.data());
  if (got <= 0) return {};
  report.resize(std::min(report.size(), static_cast<std::size_t>(got)));
  if (reportId == 0) report.erase(report.begin());
  return report;
}

bool HidrawLink::setFeature(std::span<const std::uint8_t> bytes) const {
  if (bytes.empty() || bytes.size() > kMaxIoctlBytes) return false;
  return ::ioctl(file_, HIDIOCSFEATURE(bytes.size()), bytes.data()) >= 0;
}

}  // namespace macula::gaze::hid
