// What the system knows about HID devices without opening them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/gaze/hid/choice.h"

namespace macula::gaze::hid {

/// Devices with an eye tracker's application collection, or, with a profile, all that bear its
/// ids; ordered by path, each once. Safe to call from several threads.
[[nodiscard]] std::vector<TrackerInfo> findDevices(const TrackerChoice& choice);

/// The report descriptor of "/dev/hidrawN" from sysfs, which everybody may read; empty where the
/// device has gone.
[[nodiscard]] std::vector<std::uint8_t> readReportDescriptor(const std::string& path);

}  // namespace macula::gaze::hid
