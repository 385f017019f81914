#include "engine/control/hold_measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "engine/control/law.h"
#include "engine/measure/statistics.h"

namespace macula::control {
namespace {

constexpr double kLate = 1.02;
constexpr double kVeryLate = 1.1;
/// Frames of a running median: the camera moves, and what it sees is no noise.
constexpr std::size_t kHalfWindow = 15;
/// Frames whose median says whether the time has settled.
constexpr std::size_t kSettledFrames = 5;

using measure::median;
using measure::percentile;

/// Deviations of the frames of a part from their running median, as shares of it.
void addDeviations(std::span<const HeldFrame> part, std::vector<double>& deviations) {
  std::vector<double> near;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const std::size_t low = i - std::min(i, kHalfWindow);
    const std::size_t high = std::min(part.size(), i + kHalfWindow + 1);
    near.clear();
    for (std::size_t j = low; j < high; ++j) near.push_back(part[j].fixedMs);
    deviations.push_back(std::abs(part[i].fixedMs / *median(near) - 1.0));
  }
}

std::optional<std::size_t> settling(std::span<const HeldFrame> part, double goalMs,
                                    double tolerance) {
  if (part.size() < kSettledFrames) return {};
  const std::size_t last = part.size() - kSettledFrames;
  // One before the last median that lies outside.
  std::size_t from = last + 1;
  for (; from > 0; --from) {
    std::vector<double> next;
    for (const HeldFrame& frame : part.subspan(from - 1, kSettledFrames)) next.push_back(frame.ms);
    if (std::abs(*median(next) / goalMs - 1.0) > tolerance) break;
  }
  return from > last ? std::nullopt : std::optional(from);
}

/// Where the judged frames of a part should lie, ms.
double goalOf(const HoldPart& part, double targetMs) {
  return std::min(part.model.reachableMs, targetMs);
}

/// Whether a frame is where it should be: around the goal, or at full rate and in time.
bool isWithin(const HeldFrame& frame, double goalMs, double targetMs, double tolerance) {
  constexpr double kFullRate = 1.0 + 1e-6;
  const bool free = frame.resize <= kFullRate && frame.ms <= targetMs * (1.0 + tolerance);
  return free || std::abs(frame.ms / goalMs - 1.0) <= tolerance;
}

double shareOf(std::size_t count, std::size_t of) {
  return of == 0 ? 0.0 : static_cast<double>(count) / static_cast<double>(of);
}

/// Fills in HoldMeasures::changes and reversals.
void countChanges(std::span<const HeldFrame> frames, HoldMeasures& m) {
  double direction = 0.0;
  std::size_t changes = 0;
  std::size_t reversals = 0;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const double change = frames[i].resize - frames[i - 1].resize;
    if (change == 0.0) continue;
    ++changes;
    if (direction * change < 0.0) ++reversals;
    direction = change;
  }
  constexpr double kHundred = 100.0;
  m.changes = kHundred * shareOf(changes, frames.size());
  m.reversals = kHundred * shareOf(reversals, frames.size());
}

/// Fills in HoldMeasures::biasMs and sigmaMs.
void addSpread(const std::vector<double>& times, double targetMs, HoldMeasures& m) {
  if (times.empty()) return;
  const auto count = static_cast<double>(times.size());
  const double mean = std::accumulate(times.begin(), times.end(), 0.0) / count;
  double squares = 0.0;
  for (const double t : times) squares += (t - mean) * (t - mean);
  m.biasMs = mean - targetMs;
  m.sigmaMs = std::sqrt(squares / count);
}

}  // namespace

std::string textOf(ResizeLimit limit, double mostResize) {
  switch (limit) {
    case ResizeLimit::FullRate:
      return fmt::format("r at its end {:g}", kLeastResize);
    case ResizeLimit::NoWork:
      return "nothing is computed at 1/r";
    case ResizeLimit::End:
      return fmt::format("r at its end {:g}", mostResize);
    case ResizeLimit::Floor:
      return "floor of the cost that does not shrink";
    case ResizeLimit::Target:
      break;
  }
  return "target within reach";
}

ResizeModel modelOf(std::span<const HeldFrame> frames, double targetMs, double mostResize) {
  const bool anyAtRest = std::ranges::any_of(frames, &HeldFrame::othersAtRest);
  std::vector<double> works;
  std::vector<double> rests;
  for (const HeldFrame& frame : frames) {
    if (anyAtRest && !frame.othersAtRest) continue;
    works.push_back(frame.resizableMs * frame.resize * frame.resize);
    rests.push_back(frame.ms - frame.resizableMs);
  }
  ResizeModel model;
  model.workMs = median(works).value_or(0.0);
  model.restMs = median(rests).value_or(0.0);
  const double forWork = targetMs - model.restMs;
  if (model.workMs > 0.0) {
    const double meets =
        forWork > 0.0 ? std::sqrt(model.workMs / forWork) : std::numeric_limits<double>::infinity();
    model.idealResize = std::clamp(meets, kLeastResize, mostResize);
    model.limit = forWork <= 0.0          ? ResizeLimit::Floor
                  : meets > mostResize    ? ResizeLimit::End
                  : meets <= kLeastResize ? ResizeLimit::FullRate
                                          : ResizeLimit::Target;
  }
  model.reachableMs = model.workMs / (model.idealResize * model.idealResize) + model.restMs;
  return model;
}

std::string verdictOf(const HoldMeasures& measures) {
  const auto held = [](const HoldPart& part) { return part.met == true; };
  const auto missed = [](const HoldPart& part) { return part.met == false; };
  const bool anyHeld = std::ranges::any_of(measures.parts, held);
  const bool anyMissed = std::ranges::any_of(measures.parts, missed);
  if (anyHeld) return anyMissed ? "held in part" : "held";
  return anyMissed ? "not held" : "not judged";
}

namespace {

/// The model of a load; HoldMeasures::loads gets what is not there yet.
ResizeModel loadOf(const HoldRun& run, int times, HoldMeasures& m) {
  const auto known = std::ranges::find(m.loads, times, &HoldLoad::times);
  if (known != m.loads.end()) return known->model;
  std::vector<HeldFrame> frames;
  for (const HeldFrame& frame : run.frames) {
    if (frame.load == times) frames.push_back(frame);
  }
  m.loads.push_back({times, modelOf(frames, run.targetMs, run.mostResize)});
  return m.loads.back().model;
}

}  // namespace

HoldMeasures measureHold(const HoldRun& run) {
  if (run.frames.empty()) throw std::invalid_argument("measureHold: no frames");
  HoldMeasures m;
  std::vector<std::size_t> bounds{0};
  bounds.insert(bounds.end(), run.steps.begin(), run.steps.end());
  bounds.push_back(run.frames.size());
  std::vector<double> deviations;
  for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
    const auto frames = run.frames.subspan(bounds[i], bounds[i + 1] - bounds[i]);
    if (frames.empty()) continue;
    HoldPart part;
    part.begin = bounds[i];
    part.end = bounds[i + 1];
    part.load = frames.front().load;
    part.model = loadOf(run, part.load, m);
    m.parts.push_back(part);
    addDeviations(frames, deviations);
  }
  m.fixedSpread = *percentile(deviations, kGateShare);
  m.tolerance = std::min(kGateTolerance + m.fixedSpread, kMostTolerance);
  std::size_t fixedWithin = 0;
  for (const double deviation : deviations) fixedWithin += deviation <= m.tolerance ? 1 : 0;
  m.fixedWithin = shareOf(fixedWithin, deviations.size());

  std::vector<double> times;
  std::size_t five = 0;
  std::size_t within = 0;
  std::size_t late = 0;
  std::size_t veryLate = 0;
  for (HoldPart& part : m.parts) {
    const auto frames = run.frames.subspan(part.begin, part.end - part.begin);
    const double goal = goalOf(part, run.targetMs);
    part.settleFrames = settling(frames, goal, m.tolerance);
    double pixels = 0.0;
    double ideal = 0.0;
    std::size_t partWithin = 0;
    for (std::size_t i = kSettling; i < frames.size(); ++i) {
      five += isWithin(frames[i], goal, run.targetMs, kGateTolerance) ? 1 : 0;
      partWithin += isWithin(frames[i], goal, run.targetMs, m.tolerance) ? 1 : 0;
      late += frames[i].ms > kLate * run.targetMs ? 1 : 0;
      veryLate += frames[i].ms > kVeryLate * run.targetMs ? 1 : 0;
      times.push_back(frames[i].ms);
      pixels += 1.0 / (frames[i].resize * frames[i].resize);
      ideal += 1.0 / (part.model.idealResize * part.model.idealResize);
      ++part.judged;
    }
    within += partWithin;
    part.within = shareOf(partWithin, part.judged);
    if (part.judged > 0) part.met = part.within >= kGateShare;
    if (ideal > 0.0) part.usedPixels = pixels / ideal;
  }
  std::size_t over = 0;
  for (const HeldFrame& frame : run.frames) {
    over = frame.ms > kLate * run.targetMs ? over + 1 : 0;
    m.longestOver = std::max(m.longestOver, over);
  }
  m.judged = times.size();
  m.withinFive = shareOf(five, m.judged);
  m.withinTolerance = shareOf(within, m.judged);
  m.over102 = shareOf(late, m.judged);
  m.over110 = shareOf(veryLate, m.judged);
  if (m.judged > 0) m.met = m.withinTolerance >= kGateShare;
  m.p50Ms = percentile(times, 0.5).value_or(0.0);
  m.p95Ms = percentile(times, 0.95).value_or(0.0);
  m.p99Ms = percentile(times, 0.99).value_or(0.0);
  addSpread(times, run.targetMs, m);
  countChanges(run.frames, m);
  return m;
}

}  // namespace macula::control
