// What every fuzz target of a gaze log reader does with its bytes: they are refused with an
// InputError, or make a log that keeps its promises, survives being written and can be replayed.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>

#include "engine/core/error.h"
#include "engine/gaze/log.h"
#include "engine/gaze/log_reader.h"
#include "engine/gaze/quality.h"
#include "engine/gaze/source.h"

namespace macula::gaze {

inline void requireThat(bool holds) {
  if (!holds) std::abort();
}

inline std::string bytesOf(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// The whole log; throws InputError.
inline GazeLog readFuzzed(const std::string& bytes, const LogOptions& options,
                          const std::string& sidecar = {}) {
  std::istringstream in(bytes);
  GazeLogReader reader(in, "fuzz", options, sidecar);
  GazeLog log;
  GazeSample sample;
  while (reader.next(sample)) log.samples.push_back(sample);
  requireThat(!reader.next(sample));
  static_cast<GazeLogHead&>(log) = reader.head();
  return log;
}

inline void checkLog(GazeLog log) {
  requireThat(!log.samples.empty());
  requireThat(log.samples.front().timeSeconds == 0.0);
  requireThat(!describe(log.coordinates).empty());
  requireThat(!nlohmann::json(log.notes).dump().empty());  // throws where they are not UTF-8
  for (const GazeSample& sample : log.samples) {
    requireThat(std::isfinite(sample.timeSeconds));
    requireThat(!sample.valid ||
                (std::isfinite(sample.position.x) && std::isfinite(sample.position.y)));
  }
  const GazeCounters& c = log.counters;
  requireThat(c.bothLost <= c.leftLost && c.bothLost <= c.rightLost &&
              c.leftLost <= c.twoEyeSamples && c.rightLost <= c.twoEyeSamples &&
              c.truncatedRows <= 1);
  const GazeQuality quality = assess(log);
  requireThat(quality.lost + quality.offScreen <= quality.samples);
  requireThat(quality.longestDropoutSeconds >= 0.0 && quality.jitterSeconds >= 0.0);
  requireThat(quality.movements.fixationSeconds >= 0.0 &&
              quality.movements.fixations <= quality.samples);

  const std::string text = canonicalCsv(log);
  const GazeLog again = readFuzzed(text, {.format = "macula-csv"});
  requireThat(again.samples.size() == log.samples.size());
  requireThat(canonicalCsv(again) == text);
  requireThat(assess(again).lost == quality.lost);

  GazeSettings settings;
  settings.latencyMs = 50.0;
  ReplayGaze replay(std::move(log), settings);
  for (int frame = 0; frame < 120; ++frame) {
    const PointOfInterest point = replay.at(frame / 60.0);
    requireThat(point.position.x >= 0.0F && point.position.x <= 1.0F);
    requireThat(point.position.y >= 0.0F && point.position.y <= 1.0F);
    requireThat(point.ageSeconds >= 0.0F);
  }
}

/// One execution of a target.
inline int fuzzGazeLog(const std::string& bytes, const LogOptions& options,
                       const std::string& sidecar = {}) {
  try {
    checkLog(readFuzzed(bytes, options, sidecar));
  } catch (const InputError&) {
    // The expected end of most inputs.
  }
  return 0;
}

}  // namespace macula::gaze
