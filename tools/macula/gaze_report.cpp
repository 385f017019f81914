#include "gaze_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/core/error.h"
#include "engine/gaze/point_error.h"

namespace macula::tools {

using nlohmann::ordered_json;

ordered_json toJson(const gaze::KnownDisplay& known) {
  return {{"width_mm", known.display.widthMm},
          {"height_mm", known.display.heightMm},
          {"distance_mm", known.display.distanceMm},
          {"size_by", known.sizeBy},
          {"distance_by", known.distanceBy}};
}

FollowedGaze::FollowedGaze(const gaze::GazeSource& source, const gaze::GazeSettings& settings)
    : log_(dynamic_cast<const gaze::ReplayGaze*>(&source)), settings_(settings) {}

std::vector<std::string> FollowedGaze::warnings() const {
  std::vector<std::string> lines;
  if (log_ == nullptr) return lines;
  for (const std::string& warning : log_->viewing().warnings) {
    lines.push_back(fmt::format("{}: {}", oneLine(log_->name()), warning));
  }
  return lines;
}

void FollowedGaze::printWarnings() const {
  for (const std::string& line : warnings()) fmt::print(stderr, "warning: {}\n", line);
}

void FollowedGaze::printEnd(double fps, int frames) const {
  if (log_ == nullptr) return;
  const double end = log_->endSeconds();
  if (!((frames - 1) / fps > end)) return;
  auto frame = static_cast<int>(std::max(end * fps - 1.0, 0.0));  // and by the same division:
  while (frame / fps <= end) ++frame;
  fmt::print(stderr,
             "gaze log ended at {:.2f} s, before frame {} of {}; the point of interest was held, "
             "then eased to the centre\n",
             end, frame, frames);
}

bool FollowedGaze::hasDegrees() const {
  return log_ == nullptr || log_->viewing().hasDegrees;
}

const gaze::Display& FollowedGaze::display() const {
  return log_ == nullptr ? settings_.display : log_->viewing().display.display;
}

std::string FollowedGaze::errorBasis() const {
  if (log_ == nullptr) return "0 by definition: the point is known exactly";
  if (!log_->viewing().hasDegrees) return fmt::format("none: {}", gaze::kNoDegrees);
  if (gaze::isUndelayed(settings_)) {
    return "0 by definition: the point is the newest believed sample, without latency, filter or "
           "prediction";
  }
  return "from the point of interest to the newest believed sample at the frame's time, on a "
         "display of " +
         describe(log_->viewing().display);
}

ordered_json FollowedGaze::toJson() const {
  if (log_ == nullptr) return nullptr;
  const gaze::GazeLog& log = log_->log();
  return {{"format", log.format},
          {"coordinates", describe(log.coordinates)},
          {"of", log.coordinates.of},
          {"end_s", log_->endSeconds()},
          {"display", tools::toJson(log_->viewing().display)},
          {"has_degrees", log_->viewing().hasDegrees},
          {"warnings", log_->viewing().warnings}};
}

}  // namespace macula::tools
