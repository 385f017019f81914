// One scene, several methods, frames taken in turn.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "passes/machine.h"

namespace macula::bench {

/// Median and spread of one time over the frames of a run, in milliseconds.
struct Times {
  double median = 0.0;
  double p5 = 0.0;
  double p95 = 0.0;
};

/// What was measured of one method on one scene.
struct Row {
  std::string method;
  double kAve = 0.0;  ///< 0 where the method has no budget
  Times total;
  Times transparency;  ///< sum of the passes whose names start with "oit."
  std::vector<std::pair<std::string, Times>> passes;
  std::uint64_t oitBytes = 0;
  std::optional<std::uint64_t> budgetBytes;
  std::uint64_t overheadBytes = 0;
  std::optional<std::uint64_t> generated;
  std::optional<std::uint64_t> lost;
  std::uint32_t deepest = 0;
  std::optional<double> rmse;  ///< against ab-sbuffer, display values
  std::optional<double> psnrDb;
  std::string sync;
};

struct SceneResult {
  std::string scene;
  glm::ivec2 size{0};
  std::string light;  ///< how the transparent surfaces are lit
  std::vector<Row> rows;
};

/// Draws `frames` rounds; in each round every method draws one frame, so that whatever else the
/// machine does falls on all of them alike. The first rows are blend and ab-sbuffer.
[[nodiscard]] SceneResult measureScene(const std::string& scene, glm::ivec2 size, int frames,
                                       passes::Machine& machine);

/// Load time, peak memory and time to the first frame of a file, by a fresh process.
struct LoadResult {
  std::string file;
  double loadMs = 0.0;
  double firstFrameMs = 0.0;
  double peakMiB = 0.0;
};

/// @param program path of the macula command
[[nodiscard]] std::optional<LoadResult> measureLoad(const std::string& program,
                                                    const std::string& file);

}  // namespace macula::bench
