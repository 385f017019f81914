#include "engine/measure/run_record.h"

#include "engine/measure/summary.h"

namespace macula::measure {
namespace {

using Json = nlohmann::ordered_json;

template <typename T>
Json orNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json frameJson(const FrameRecord& frame) {
  Json json = Json::object();
  addTo(json, frame, kReport, None::Null);
  for (const auto& [name, ms] : frame.passMs) json["ms"][name] = ms;
  return json;
}

Json summaryJson(const RunRecord& run) {
  Json summary = summaryOf(run.frames, kReport);
  summary["gaze_error_deg"]["basis"] = run.gazeErrorBasis;
  summary["load_ms"] = run.loadMs;
  summary["first_frame_ms"] = run.firstFrameMs;
  return summary;
}

Json recordingJson(const RecordingNumbers& recording) {
  return {{"frames", recording.frames},
          {"truncated_lines", recording.truncatedLines},
          {"unrecorded_frames", recording.unrecordedFrames},
          {"hashes_compared", recording.hashesCompared},
          {"hashes_equal", recording.hashesEqual},
          {"first_difference", orNull(recording.firstDifference)}};
}

}  // namespace

Json toJson(const RunRecord& run) {
  Json report{
      {"schema", 1},
      {"commit", run.commit},
      {"scene", run.scene},
      {"width", run.width},
      {"height", run.height},
      {"gl",
       {{"renderer", run.renderer}, {"version", run.version}, {"time_source", run.timeSource}}},
      {"method", run.method},
      {"sync", orNull(run.sync)},
      {"settings", Json(run.settings)},
      {"provenance", run.provenance}};
  addTo(report, run.frames.empty() ? FrameRecord() : run.frames.back(), kReportRun, None::Null);
  Json buffers = Json::object();
  for (const auto& [name, bytes] : run.transparencyBytes) buffers[name] = bytes;
  report["bytes"]["buffers"] = buffers;
  report["interrupted"] = run.interrupted;
  report["frames"] = Json::array();
  for (const FrameRecord& frame : run.frames) report["frames"].push_back(frameJson(frame));
  report["summary"] = summaryJson(run);
  report["gaze_log"] = run.gazeLog;
  if (run.recording) report["recording"] = recordingJson(*run.recording);
  return report;
}

}  // namespace macula::measure
