// Canonical gaze CSV from any bytes: refused with an InputError, or a log that survives being
// written and replayed.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <utility>

#include "engine/core/error.h"
#include "engine/gaze/log.h"
#include "engine/gaze/quality.h"
#include "engine/gaze/source.h"

namespace {

using namespace macula::gaze;

GazeLog parse(const std::string& text) {
  std::istringstream in(text);
  return readGazeLog(in, "fuzz", "macula-csv");
}

void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    GazeLog log = parse(std::string(reinterpret_cast<const char*>(data), size));
    const GazeQuality quality = assess(log);
    require(quality.lost + quality.offScreen <= quality.samples);

    const std::string text = canonicalCsv(log);
    require(canonicalCsv(parse(text)) == text);

    GazeSettings settings;
    settings.latencyMs = 50.0;
    ReplayGaze replay(std::move(log), settings);
    for (int frame = 0; frame < 120; ++frame) {
      const PointOfInterest point = replay.at(frame / 60.0);
      require(point.position.x >= 0.0F && point.position.x <= 1.0F);
      require(point.position.y >= 0.0F && point.position.y <= 1.0F);
      require(point.ageSeconds >= 0.0F);
    }
  } catch (const macula::InputError&) {
    // The expected end of most inputs.
  }
  return 0;
}
