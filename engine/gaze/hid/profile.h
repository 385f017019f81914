// A plain description of a vendor's HID tracker, for devices that do not speak usage page 0x12.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "engine/gaze/hid/layout.h"

namespace macula::gaze::hid {

/// What a profile file says. The keys are in README.md of this folder, an example is
/// assets/trackers/example.toml.
struct TrackerProfile {
  std::string name;
  std::uint16_t vendorId = 0;
  std::uint16_t productId = 0;
  TrackerLayout layout;                ///< reads by the same decoder as a descriptor's
  std::optional<glm::dvec2> screenMm;  ///< absent where positions are shares of the display
};

/// @param name what to call the text in messages, usually its path
/// @throws InputError "name:line: ..." for an unknown key (naming the nearest), a missing or
/// refused
///   value, and a number that does not lie within the report
[[nodiscard]] TrackerProfile parseProfile(std::string_view text, std::string_view name);
[[nodiscard]] TrackerProfile readProfile(const std::filesystem::path& path);

}  // namespace macula::gaze::hid
