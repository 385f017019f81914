#include "engine/gaze/hid/device.h"

#include <hidapi/hidapi.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <mutex>

#include "engine/gaze/hid/usages.h"

namespace macula::gaze::hid {
namespace {

std::string utf8(const wchar_t* text) {
  std::string bytes;
  for (; text != nullptr && *text != 0; ++text) {
    const auto code = static_cast<std::uint32_t>(*text);
    const auto tail = [code](int shift) {
      return static_cast<char>(0x80 | ((code >> shift) & 0x3F));
    };
    if (code < 0x80) {
      bytes += static_cast<char>(code);
    } else if (code < 0x800) {
      bytes += {static_cast<char>(0xC0 | (code >> 6)), tail(0)};
    } else if (code < 0x10000) {
      bytes += {static_cast<char>(0xE0 | (code >> 12)), tail(6), tail(0)};
    } else {
      bytes += {static_cast<char>(0xF0 | ((code >> 18) & 7)), tail(12), tail(6), tail(0)};
    }
  }
  return bytes;
}

bool speaksTrackerPage(const hid_device_info& info) {
  // A tracker is listed once for each top-level collection, all with one path.
  return info.usage_page == kTrackerPage && info.usage == (kEyeTracker & 0xFFFFU);
}

/// "/dev/hidraw10" behind "/dev/hidraw9".
bool comesBefore(const TrackerInfo& a, const TrackerInfo& b) {
  return a.path.size() != b.path.size() ? a.path.size() < b.path.size() : a.path < b.path;
}

}  // namespace

std::vector<TrackerInfo> findDevices(const TrackerChoice& choice) {
  // hidapi keeps its last error in a global and is not to be entered twice.
  static std::mutex mutex;
  const std::scoped_lock lock(mutex);
  const std::unique_ptr<hid_device_info, decltype(&hid_free_enumeration)> list(
      hid_enumerate(0, 0), &hid_free_enumeration);
  std::vector<TrackerInfo> found;
  for (const hid_device_info* info = list.get(); info != nullptr; info = info->next) {
    if (info->path == nullptr || !(choice.profile || speaksTrackerPage(*info))) continue;
    TrackerInfo tracker{.name = utf8(info->product_string),
                        .path = info->path,
                        .vendorId = info->vendor_id,
                        .productId = info->product_id,
                        .serial = utf8(info->serial_number)};
    const bool known = std::any_of(found.begin(), found.end(), [&](const TrackerInfo& other) {
      return other.path == tracker.path;
    });
    if (known || !choice.matches(tracker)) continue;
    tracker.accessible = ::access(tracker.path.c_str(), R_OK | W_OK) == 0;
    found.push_back(std::move(tracker));
  }
  std::sort(found.begin(), found.end(), comesBefore);
  return found;
}

std::vector<std::uint8_t> readReportDescriptor(const std::string& path) {
  const std::filesystem::path file = std::filesystem::path("/sys/class/hidraw") /
                                     std::filesystem::path(path).filename() /
                                     "device/report_descriptor";
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

}  // namespace macula::gaze::hid
