#include "recorded_levers.h"

#include <cmath>

#include "engine/control/levers.h"
#include "engine/core/error.h"
#include "engine/core/nearest.h"

namespace macula::tools {
namespace {

using control::kLeverOrder;
using control::Lever;
using control::LeverInfo;

float& memberOf(frame::Levers& levers, Lever lever) {
  return lever == Lever::Resize       ? levers.resize
         : lever == Lever::FoveaSlope ? levers.foveaSlope
                                      : levers.layerShare;
}

/// Values that a renderer takes: wider than what a controller uses, but for r.
bool isPossible(Lever lever, double value) {
  if (lever == Lever::LayerShare) return value > 0.0 && value <= 1.0;
  const bool finite = std::isfinite(value) && value >= 1.0;
  return finite && (lever != Lever::Resize || value <= control::kMostResize);
}

const char* rangeOf(Lever lever) {
  return lever == Lever::Resize       ? "1 to 8"
         : lever == Lever::FoveaSlope ? "1 or more"
                                      : "more than 0, and 1 at the most";
}

}  // namespace

std::vector<std::pair<std::string, double>> recordedLevers(const frame::Levers& levers) {
  std::vector<std::pair<std::string, double>> recorded;
  frame::Levers set = levers;
  frame::Levers rest;
  for (const LeverInfo& info : kLeverOrder) {
    const float value = memberOf(set, info.lever);
    if (value != memberOf(rest, info.lever)) {
      recorded.emplace_back(info.name, static_cast<double>(value));
    }
  }
  return recorded;
}

frame::Levers replayedLevers(const recording::Frame& frame, double lodResize,
                             const std::string& place) {
  frame::Levers levers;
  // Only of recordings by other programs: a walk records the lever wherever lod.r was not used.
  if (frame.r != 1.0 && lodResize == 1.0) levers.resize = static_cast<float>(frame.r);
  if (frame.r > control::kMostResize) {
    failInput("{}: 'r' is {}; give 1 to {}", place, frame.r, control::kMostResize);
  }
  std::vector<std::string> names;
  for (const LeverInfo& info : kLeverOrder) names.emplace_back(info.name);
  for (const auto& [name, value] : frame.levers) {
    const LeverInfo* known = nullptr;
    for (const LeverInfo& info : kLeverOrder) known = info.name == name ? &info : known;
    if (known == nullptr) {
      failInput(
          "{}: the lever '{}' is not known; the nearest is '{}', or replay it with the program "
          "that recorded it",
          place, oneLine(name), nearestName(name, names));
    }
    if (!isPossible(known->lever, value)) {
      failInput("{}: the lever '{}' is {}; give {}", place, name, value, rangeOf(known->lever));
    }
    memberOf(levers, known->lever) = static_cast<float>(value);
  }
  return levers;
}

}  // namespace macula::tools
