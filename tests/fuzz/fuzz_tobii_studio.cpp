// Tobii Studio TSV from any bytes: refused with an InputError, or a log whose valid samples have a
// place and whose canonical text can be read.
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

void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace macula::gaze;
  try {
    std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
    GazeLog log = readGazeLog(in, "fuzz", "tobii-studio");
    for (const GazeSample& sample : log.samples) {
      require(!sample.valid ||
              (std::isfinite(sample.position.x) && std::isfinite(sample.position.y)));
    }
    std::istringstream canonical(canonicalCsv(log));
    const GazeLog again = readGazeLog(canonical, "canonical");
    require(again.samples.size() == log.samples.size());
    require(assess(again).lost == assess(log).lost);

    ReplayGaze replay(std::move(log));
    for (int frame = 0; frame < 120; ++frame) {
      const PointOfInterest point = replay.at(frame / 60.0);
      require(point.position.x >= 0.0F && point.position.x <= 1.0F);
      require(point.position.y >= 0.0F && point.position.y <= 1.0F);
    }
  } catch (const macula::InputError&) {
    // The expected end of most inputs.
  }
  return 0;
}
