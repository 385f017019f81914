// What a replay measured, and report.json.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/measure/frame_record.h"

namespace macula::measure {

/// How the replay of a recording compares with it.
struct RecordingNumbers {
  std::uint64_t frames = 0;  ///< that were recorded
  std::uint64_t truncatedLines = 0;
  std::uint64_t unrecordedFrames = 0;  ///< drawn in between, and not recorded
  std::uint64_t hashesCompared = 0;
  std::uint64_t hashesEqual = 0;
  std::optional<std::uint64_t> firstDifference = {};  ///< index of the frame
};

struct RunRecord {
  std::string commit;
  std::string scene;
  int width = 0;
  int height = 0;
  std::string renderer;
  std::string version;
  std::string timeSource;
  std::string method;
  std::optional<std::string> sync;
  nlohmann::json settings;
  nlohmann::ordered_json provenance;  ///< of measure::Provenance
  /// Each buffer and texture of transparency by name, while it is alive. Where lives do not meet,
  /// buffers share memory, so these add up to the metric bytes.total or more.
  std::vector<std::pair<std::string, std::uint64_t>> transparencyBytes;
  double loadMs = 0.0;
  double firstFrameMs = 0.0;       ///< from the start of the command to the end of the first frame
  bool interrupted = false;        ///< frames that were asked for are missing
  nlohmann::ordered_json gazeLog;  ///< null: the gaze is no log
  std::string gazeErrorBasis;      ///< what the metric fovea.error_deg rests on
  std::optional<RecordingNumbers> recording;  ///< where a recording was replayed
  std::vector<FrameRecord> frames;
};

/// report.json, schema 1: the metrics of the table, and the keys of report_keys.h. What does not
/// apply is null.
[[nodiscard]] nlohmann::ordered_json toJson(const RunRecord& run);

}  // namespace macula::measure
