// Camera path files: any bytes give keys or one InputError.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "engine/core/error.h"
#include "engine/scene/camera_path.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto keys = macula::scene::parseCameraPath(
        std::string_view(reinterpret_cast<const char*>(data), size), "fuzz.csv");
    if (keys.empty()) std::abort();  // a path without keys must have been refused
    const macula::scene::CameraPath path(keys);
    static_cast<void>(path.at(0.5 * path.duration()));
  } catch (const macula::InputError&) {
  }
  return 0;
}
