// What a replay measured, frame by frame, and report.json.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/measure/image_error.h"

namespace macula::measure {

/// Numbers of fragments of one frame: generated = stored + merged + lost.
struct FragmentNumbers {
  std::uint64_t generated = 0;
  std::uint64_t stored = 0;
  std::uint64_t merged = 0;
  std::uint64_t lost = 0;
};

struct LayerNumbers {
  std::uint32_t min = 0;
  std::uint32_t max = 0;
  double mean = 0.0;
};

/// Pixels of one frame, samples that were shaded for them, and pixels that no low-rate sample fits.
struct ShadingNumbers {
  std::uint64_t pixels = 0;
  std::uint64_t shaded = 0;  ///< holes among them
  std::uint64_t holes = 0;
};

struct FrameRecord {
  int index = 0;
  double timeSeconds = 0.0;
  double gazeX = 0.5;  ///< 0..1 from the top left
  double gazeY = 0.5;
  double rawX = 0.0;  ///< as recorded; NaN where there is none
  double rawY = 0.0;
  std::string gazeState;
  double gazeAgeSeconds = 0.0;  ///< infinite where no sample has come yet
  double gazeRadius = 0.0;      ///< share of the window's height
  bool gazeSaccade = false;
  /// Degrees between the point of interest and where the eye was at the frame's time by the newest
  /// believed sample; none where that is not known.
  std::optional<double> gazeErrorDegrees;
  double resizeFactor = 1.0;
  std::optional<ShadingNumbers> shading;
  double totalMs = 0.0;
  std::vector<std::pair<std::string, double>> passMs;
  std::optional<FragmentNumbers> fragments;
  std::optional<LayerNumbers> layers;
  std::optional<ImageError> error;
  std::optional<double> flicker;         ///< see FlickerMeter; none for the first frame
  std::optional<std::uint64_t> hazards;  ///< see countUnlikePixels(); of racy methods only
  bool exact = false;
  std::string imageSha256;
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
  std::uint64_t oitBytes = 0;
  std::optional<std::uint64_t> budgetBytes;
  std::uint64_t overheadBytes = 0;
  std::uint64_t gbufferBytes = 0;
  /// Each buffer and texture of the transparency, by name; they add up to oitBytes + overheadBytes.
  std::vector<std::pair<std::string, std::uint64_t>> transparencyBytes;
  double loadMs = 0.0;
  double firstFrameMs = 0.0;  ///< from the start of the command to the end of the first frame
  bool interrupted = false;   ///< frames that were asked for are missing
  std::vector<FrameRecord> frames;
};

/// report.json, schema 1. What does not apply is null.
/// The summary: median and 95th percentile of the frame times; the errors' means over frames, with
/// rmse as the root of the mean square, psnr_db from it, and max as the largest; the mean flicker
/// of all frames but the first; median, 95th percentile and largest error of the point of interest;
/// fragment sums.
[[nodiscard]] nlohmann::ordered_json toJson(const RunRecord& run);

}  // namespace macula::measure
