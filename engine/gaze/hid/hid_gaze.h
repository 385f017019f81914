// A HID eye tracker as a source of gaze.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "engine/gaze/hid/eye_tracker.h"
#include "engine/gaze/live_gaze.h"

namespace macula::gaze::hid {

/// What --gaze names a tracker by: `hid` for the first, `hid:1234:abcd`, `hid:1234:abcd:SERIAL`,
/// `hid:SERIAL`, or `hid:FILE.toml` for a device with a profile.
[[nodiscard]] bool isTrackerSpec(std::string_view spec);

/// Time 0 of at() is set by the first call: its time is now by the steady clock.
/// @throws InputError where this build reads no HID devices, or a profile is wrong. A tracker that
/// is
///   not there is no error: it is waited for, and status() says so.
[[nodiscard]] std::unique_ptr<GazeSource> openTracker(const std::string& spec,
                                                      const GazeSettings& settings);

}  // namespace macula::gaze::hid
