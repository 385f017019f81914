// Which of the trackers that are plugged in is meant, and what is known of it beforehand.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "engine/gaze/hid/profile.h"

namespace macula::gaze::hid {

/// A tracker that is plugged in.
struct TrackerInfo {
  std::string name;  ///< what the device calls itself; may be empty
  std::string path;  ///< "/dev/hidraw3"; another one after each replug
  std::uint16_t vendorId = 0;
  std::uint16_t productId = 0;
  std::string serial;       ///< may be empty
  bool accessible = false;  ///< this user may open it
};

/// What is not given does not matter; of several that match, the first is taken.
struct TrackerChoice {
  std::optional<std::uint16_t> vendorId;
  std::optional<std::uint16_t> productId;
  std::string serial;
  /// How to read a device that does not speak usage page 0x12; its ids then choose the device.
  std::optional<TrackerProfile> profile;
  /// Size of the calibrated display, where the device does not tell it.
  std::optional<glm::dvec2> screenMm;

  [[nodiscard]] bool matches(const TrackerInfo& info) const;
  /// "any", "1234:abcd", "serial X" and so on, for messages.
  [[nodiscard]] std::string text() const;
};

/// "first" (or nothing): any tracker. "1234:abcd": vendor and product in hexadecimal digits;
/// "1234:abcd:SERIAL" with the serial number too. Anything else is a serial number.
[[nodiscard]] TrackerChoice parseTrackerChoice(std::string_view text);

}  // namespace macula::gaze::hid
