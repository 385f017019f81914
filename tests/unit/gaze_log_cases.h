// What the tests of the log readers share: texts in, logs or messages out.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>

#include "engine/core/error.h"
#include "engine/gaze/log.h"
#include "engine/gaze/log_reader.h"
#include "engine/gaze/quality.h"

namespace macula::gaze {

inline GazeLog parseLog(const std::string& text, const LogOptions& options = {},
                        const std::string& sidecar = {}) {
  std::istringstream in(text);
  GazeLogReader reader(in, "log.csv", options, sidecar);
  GazeLog log;
  GazeSample sample;
  while (reader.next(sample)) log.samples.push_back(sample);
  static_cast<GazeLogHead&>(log) = reader.head();
  return log;
}

inline std::string errorOfLog(const std::string& text, const LogOptions& options = {},
                              const std::string& sidecar = {}) {
  try {
    (void)parseLog(text, options, sidecar);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

inline void expectPlace(const GazeSample& sample, double x, double y) {
  EXPECT_TRUE(sample.valid);
  EXPECT_NEAR(sample.position.x, x, 1e-12);
  EXPECT_NEAR(sample.position.y, y, 1e-12);
}

inline void expectLost(const GazeSample& sample) {
  EXPECT_FALSE(sample.valid);
}

/// A file of the recordings that are not part of the project; skips where they are absent.
#define MACULA_RECORDING(variable, file)                                                 \
  const std::filesystem::path variable = MACULA_SOURCE_DIR "/../shared/data/gaze/" file; \
  if (!std::filesystem::exists(variable)) GTEST_SKIP() << variable << " is absent"

}  // namespace macula::gaze
