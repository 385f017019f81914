#include "engine/gaze/source.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "engine/core/error.h"
#include "engine/gaze/cells.h"
#include "engine/gaze/quality.h"

namespace macula::gaze {
namespace {

constexpr std::string_view kAccepted = "give center, x,y (each 0..1 of the window) or a gaze log";

double latestTime(const GazeLog& log) {
  double latest = 0.0;
  for (const GazeSample& sample : log.samples) latest = std::max(latest, sample.timeSeconds);
  return latest;
}

}  // namespace

FixedGaze::FixedGaze(const glm::dvec2& position, std::string name)
    : position_(position), name_(std::move(name)) {}

PointOfInterest FixedGaze::at(double /*timeSeconds*/) {
  return exactPoint(position_);
}

void MouseGaze::move(const glm::dvec2& position, double timeSeconds) {
  // Some window systems report a pointer that has left as infinitely far or not at all.
  if (std::isnan(position.x) || std::isnan(position.y)) return;
  point_ = exactPoint(glm::clamp(position, -kFarthestPlace, kFarthestPlace));
  if (!listener_) return;
  GazeSample sample;
  sample.timeSeconds = timeSeconds;
  sample.position = position;
  sample.valid = true;
  listener_(sample);
}

PointOfInterest MouseGaze::at(double /*timeSeconds*/) {
  return point_;
}

ReplayGaze::ReplayGaze(GazeLog log, const GazeSettings& settings)
    : log_(std::move(log)),
      viewing_(viewingOf(log_, logOptionsOf(settings))),
      latency_(settings.latencyMs * 1e-3),
      interval_(medianInterval(log_)),
      lastTime_(latestTime(log_)),
      tracker_({.sampleInterval = interval_,
                .latencySeconds = latency_,
                .live = false,
                .pipeline = settings.pipeline,
                .display = viewing_.display.display}) {}

PointOfInterest ReplayGaze::at(double timeSeconds) {
  const double time = timeSeconds - latency_;
  while (next_ < log_.samples.size() && log_.samples[next_].timeSeconds <= time) {
    if (listener_) listener_(log_.samples[next_]);
    tracker_.observe(log_.samples[next_]);
    ++next_;
  }
  const bool ended =
      next_ > 0 && next_ == log_.samples.size() && time > lastTime_ + interval_ + kTimeTolerance;
  if (ended) tracker_.lose(lastTime_ + interval_);
  PointOfInterest point = tracker_.at(time);
  if (ended && point.state == GazeState::Lost) point.state = GazeState::Ended;
  return point;
}

std::unique_ptr<GazeSource> parseGazeSpec(const std::string& spec, const GazeSettings& settings) {
  if (spec == "center") return std::make_unique<FixedGaze>(glm::dvec2(0.5), spec);

  std::vector<std::string_view> cells;
  splitCells(spec, ',', cells);
  if (cells.size() == 2) {
    const std::optional<double> x = parseNumber(cells[0]);
    const std::optional<double> y = parseNumber(cells[1]);
    if (x && y) {
      const glm::dvec2 position{*x, *y};
      if (position != glm::clamp(position, 0.0, 1.0)) {
        failInput("--gaze {}: outside the window; {}", spec, kAccepted);
      }
      return std::make_unique<FixedGaze>(position, spec);
    }
  }
  std::error_code error;
  if (!std::filesystem::exists(spec, error)) {
    failInput("--gaze {}: no such file and no point; {}", spec, kAccepted);
  }
  return std::make_unique<ReplayGaze>(readGazeLog(spec, logOptionsOf(settings)), settings);
}

}  // namespace macula::gaze
