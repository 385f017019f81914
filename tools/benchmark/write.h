// Results as BENCHMARKS.md and JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "measure.h"

namespace macula::bench {

struct Run {
  std::string command;
  std::string commit;
  std::string date;
  std::string renderer;
  std::string version;
  std::string timeSource;
  int cores = 0;
  int frames = 0;
  int warmUp = 3;
  std::vector<SceneResult> scenes;
  std::optional<LoadResult> load;
};

[[nodiscard]] std::string toMarkdown(const Run& run);
[[nodiscard]] nlohmann::ordered_json toJson(const Run& run);

}  // namespace macula::bench
