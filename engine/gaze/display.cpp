#include "engine/gaze/display.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace macula::gaze {
namespace {

// From a phone to a wall, in millimetres.
constexpr settings::Range kSizes{.min = 10.0, .max = 100000.0};
// From a phone before the nose to a wall; trackers write 0, -1 or 1e6 for an eye that is not there.
constexpr double kNearest = 100.0;
constexpr double kFarthest = 10000.0;

/// A length that notes that a person has said it.
struct SaidLength {
  double& millimetres;
  bool& given;
};

/// Found by Registry::add().
settings::Binding bindField(SaidLength& length) {
  settings::Binding binding = settings::bindField(length.millimetres);
  binding.set = [set = std::move(binding.set), &given = length.given](const settings::Value& v) {
    set(v);
    given = true;
  };
  return binding;
}

/// From the eye to a place, in millimetres.
glm::dvec3 lineOfSight(const glm::dvec2& place, const Display& display) {
  return {(place.x - 0.5) * display.widthMm, (place.y - 0.5) * display.heightMm,
          display.distanceMm};
}

}  // namespace

void RecordedDisplay::setSize(const glm::dvec2& millimetres) {
  if (kSizes.holds(millimetres.x) && kSizes.holds(millimetres.y)) sizeMm_ = millimetres;
}

void RecordedDisplay::noteDistance(double millimetres) {
  if (!(millimetres >= kNearest && millimetres <= kFarthest)) return;
  distanceSumMm_ += millimetres;
  ++distances_;
}

std::optional<double> RecordedDisplay::distanceMm() const {
  if (distances_ == 0) return std::nullopt;
  return distanceSumMm_ / static_cast<double>(distances_);
}

KnownDisplay knownDisplay(const Display& settings, const RecordedDisplay& file) {
  KnownDisplay known{.display = settings};
  if (settings.sizeGiven) {
    known.sizeBy = "setting";
  } else if (file.sizeMm()) {
    known.display.widthMm = file.sizeMm()->x;
    known.display.heightMm = file.sizeMm()->y;
    known.sizeBy = "file";
  }
  if (settings.distanceGiven) {
    known.distanceBy = "setting";
  } else if (file.distanceMm()) {
    known.display.distanceMm = *file.distanceMm();
    known.distanceBy = "file";
  }
  return known;
}

std::string describe(const KnownDisplay& known) {
  // Tenths are finer than anybody measures.
  const auto shown = [](double millimetres) { return std::round(10.0 * millimetres) / 10.0; };
  const Display& display = known.display;
  return fmt::format("{:g}x{:g} mm ({}) at {:g} mm ({})", shown(display.widthMm),
                     shown(display.heightMm), known.sizeBy, shown(display.distanceMm),
                     known.distanceBy);
}

void registerSettings(settings::Registry& registry, Display& display) {
  SaidLength width{display.widthMm, display.sizeGiven};
  SaidLength height{display.heightMm, display.sizeGiven};
  SaidLength distance{display.distanceMm, display.distanceGiven};
  registry.add({.key = "display.widthMm", .unit = "mm", .help = "width of the picture's area"},
               width, kSizes);
  registry.add({.key = "display.heightMm", .unit = "mm", .help = "height of the picture's area"},
               height, kSizes);
  registry.add({.key = "display.distanceMm", .unit = "mm", .help = "from the eyes to the display"},
               distance, kSizes);
}

glm::dvec2 placeOfAngles(const glm::dvec2& degrees, const Display& display) {
  const glm::dvec2 fromMiddle = display.distanceMm * glm::tan(glm::radians(degrees));
  return 0.5 + fromMiddle / glm::dvec2(display.widthMm, display.heightMm);
}

double angleBetween(const glm::dvec2& a, const glm::dvec2& b, const Display& display) {
  const glm::dvec3 u = lineOfSight(a, display);
  const glm::dvec3 v = lineOfSight(b, display);
  // atan2 stays exact for small angles, where acos of the cosine does not.
  return glm::degrees(std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v)));
}

}  // namespace macula::gaze
