// What a run of `macula hold SCENE` has found, and its files.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/control/hold_measures.h"
#include "engine/frame/frame_inputs.h"
#include "engine/measure/frame_record.h"
#include "hold.h"
#include "passes/frame_renderer.h"

namespace macula::tools {

/// One load, measured at the start of the path, before the run.
struct LoadTimes {
  int times = 1;
  double fullRateMs = 0.0;   ///< median at r = 1
  double firstResize = 1.0;  ///< that meets the target on the first view; the fixed r is their mean
};

/// A frame with what control::HoldMeasures leave out.
struct HoldFrame {
  double timeSeconds = 0.0;         ///< on the path
  frame::QualityControls controls;  ///< as asked for; resize 0 where nothing was controlled
};

struct HoldNotice {
  std::size_t frame = 0;
  std::string text;  ///< empty: the one before is over
};

struct HoldRecord {
  double targetMs = 0.0;
  double fixedResize = 1.0;
  std::string clockFault;
  std::string timeSource;
  std::string glRenderer;
  std::string glVersion;
  nlohmann::ordered_json gazeLog;  ///< see FollowedGaze::toJson()
  nlohmann::ordered_json provenance;
  glm::ivec2 size{0};
  std::vector<LoadStep> steps;
  std::vector<LoadTimes> loads;
  // One of each a frame, in their order.
  std::vector<control::HeldFrame> held;
  std::vector<HoldFrame> frames;
  std::vector<measure::FrameRecord> records;
  std::vector<HoldNotice> notices;
  control::HoldMeasures measures;
  std::string interrupted;  ///< how far it came; empty: all frames were drawn
};

/// results.json, without frames.
[[nodiscard]] nlohmann::ordered_json toJson(const HoldRecord& record, const HoldOptions& options);
/// results.csv: a row a frame.
[[nodiscard]] std::string toCsv(const HoldRecord& record);
/// What report.html draws: results.json with the frames.
[[nodiscard]] nlohmann::ordered_json pageData(const HoldRecord& record, const HoldOptions& options);
/// Lines for a terminal.
[[nodiscard]] std::string summaryOf(const HoldRecord& record, const HoldOptions& options);

}  // namespace macula::tools
