// macula chart: an experiment, from its file to its report.
#pragma once

#include <string>

namespace macula::tools {

struct ChartOptions {
  std::string experiment = "quick";  ///< a file, or the name of one in assets/experiments
  std::string out;
  bool force = false;  ///< it may hold something else
  std::string platform = "auto";
  std::string json;  ///< also results.json's text; - is standard output
};

/// Runs what is missing and writes points.jsonl, images/, results.csv, results.json and
/// report.html into the output folder.
/// @throws InputError for a wrong experiment
/// @throws Interrupted when what is finished has been written; the same call goes on from there
void chart(const ChartOptions& options);

}  // namespace macula::tools
