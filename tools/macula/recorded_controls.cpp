#include "recorded_controls.h"

#include <cmath>

#include "engine/control/quality_controls.h"
#include "engine/core/error.h"
#include "engine/core/nearest.h"

namespace macula::tools {
namespace {

using control::ControlInfo;
using control::kControlOrder;
using control::QualityControl;

float& memberOf(frame::QualityControls& controls, QualityControl control) {
  return control == QualityControl::Resize       ? controls.resize
         : control == QualityControl::FoveaSlope ? controls.foveaSlope
                                                 : controls.layerShare;
}

/// Values that a renderer takes: wider than what a controller uses, but for r.
bool isPossible(QualityControl control, double value) {
  if (control == QualityControl::LayerShare) return value > 0.0 && value <= 1.0;
  const bool finite = std::isfinite(value) && value >= 1.0;
  return finite && (control != QualityControl::Resize || value <= control::kMostResize);
}

const char* rangeOf(QualityControl control) {
  return control == QualityControl::Resize       ? "1 to 8"
         : control == QualityControl::FoveaSlope ? "1 or more"
                                                 : "more than 0, and 1 at the most";
}

}  // namespace

std::vector<std::pair<std::string, double>> recordedControls(
    const frame::QualityControls& controls) {
  std::vector<std::pair<std::string, double>> recorded;
  frame::QualityControls set = controls;
  frame::QualityControls rest;
  for (const ControlInfo& info : kControlOrder) {
    const float value = memberOf(set, info.control);
    if (value != memberOf(rest, info.control)) {
      recorded.emplace_back(info.name, static_cast<double>(value));
    }
  }
  return recorded;
}

frame::QualityControls replayedControls(const recording::Frame& frame, double lodResize,
                                        const std::string& place) {
  frame::QualityControls controls;
  // Only of recordings by other programs: a walk records the control wherever lod.r was not used.
  if (frame.r != 1.0 && lodResize == 1.0) controls.resize = static_cast<float>(frame.r);
  if (frame.r > control::kMostResize) {
    failInput("{}: 'r' is {}; give 1 to {}", place, frame.r, control::kMostResize);
  }
  std::vector<std::string> names;
  for (const ControlInfo& info : kControlOrder) names.emplace_back(info.name);
  for (const auto& [name, value] : frame.controls) {
    const ControlInfo* known = nullptr;
    for (const ControlInfo& info : kControlOrder) known = info.name == name ? &info : known;
    if (known == nullptr) {
      failInput(
          "{}: the quality control '{}' is not known; the nearest is '{}', or replay it with the "
          "program "
          "that recorded it",
          place, oneLine(name), nearestName(name, names));
    }
    if (!isPossible(known->control, value)) {
      failInput("{}: the quality control '{}' is {}; give {}", place, name, value,
                rangeOf(known->control));
    }
    memberOf(controls, known->control) = static_cast<float>(value);
  }
  return controls;
}

}  // namespace macula::tools
