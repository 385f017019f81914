// The One Euro filter (Casiez, Roussel and Vogel 2012) for a point in the plane.
#pragma once

#include <glm/glm.hpp>

namespace macula::gaze {

struct OneEuroSettings {
  double minCutoffHz = 1.0;         ///< of a point at rest; lower: calmer and later
  double beta = 0.1;                ///< Hz of cutoff for each unit of speed
  double derivativeCutoffHz = 1.0;  ///< of the speed itself
};

/// A low-pass filter whose cutoff rises with the speed, so that rest is calm and motion is not
/// late. One cutoff serves both axes, by the length of the filtered velocity: a filter for each
/// axis would bend oblique motion. Along one axis it is the published filter.
class OneEuro {
 public:
  explicit OneEuro(const OneEuroSettings& settings = {}) : settings_(settings) {}

  /// The next point, filtered. The first one after reset() passes as it is.
  /// @param seconds since the point before, > 0
  [[nodiscard]] glm::dvec2 next(const glm::dvec2& point, double seconds);

  void reset() { started_ = false; }

 private:
  OneEuroSettings settings_;
  glm::dvec2 filtered_{0.0};
  glm::dvec2 velocity_{0.0};
  bool started_ = false;
};

}  // namespace macula::gaze
