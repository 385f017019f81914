// Usages of HID page 0x12, Eye and Head Trackers (USB-IF review request HUTRR74, 2018).
#pragma once

#include <cstdint>

namespace macula::gaze::hid {

/// A usage with its page: page in the high 16 bits, id in the low ones.
using Usage = std::uint32_t;

inline constexpr std::uint16_t kTrackerPage = 0x12;

[[nodiscard]] constexpr Usage trackerUsage(std::uint16_t id) {
  return (Usage{kTrackerPage} << 16) | id;
}

/// What stands for padding: a field that no usage names.
inline constexpr Usage kNoUsage = 0;

// Collections.
inline constexpr Usage kEyeTracker = trackerUsage(0x01);
inline constexpr Usage kGazePoint = trackerUsage(0x24);
inline constexpr Usage kLeftEye = trackerUsage(0x25);
inline constexpr Usage kRightEye = trackerUsage(0x26);
inline constexpr Usage kHeadPosition = trackerUsage(0x27);
inline constexpr Usage kHeadDirection = trackerUsage(0x28);

// Values of the tracking data.
inline constexpr Usage kSensorTimestamp = trackerUsage(0x20);
inline constexpr Usage kPositionX = trackerUsage(0x21);
inline constexpr Usage kPositionY = trackerUsage(0x22);
inline constexpr Usage kPositionZ = trackerUsage(0x23);

// Values of capabilities, configuration, status and control.
inline constexpr Usage kTrackerQuality = trackerUsage(0x100);
inline constexpr Usage kCalibratedScreenWidth = trackerUsage(0x204);
inline constexpr Usage kCalibratedScreenHeight = trackerUsage(0x205);
inline constexpr Usage kSamplingFrequency = trackerUsage(0x300);
inline constexpr Usage kConfigurationStatus = trackerUsage(0x301);
inline constexpr Usage kModeRequest = trackerUsage(0x400);

/// Bits of the mode request: what the tracker shall send. Without a bit it sends nothing.
inline constexpr std::uint64_t kModeGaze = 1;
inline constexpr std::uint64_t kModeEyes = 2;

/// Values of the configuration status.
enum class ConfigurationStatus : std::uint8_t {
  Unknown = 0,
  Ready = 1,
  Configuring = 2,
  ScreenSetupNeeded = 3,
  CalibrationNeeded = 4,
};

}  // namespace macula::gaze::hid
