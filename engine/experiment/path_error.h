// How far a member is from the exact frames along a camera path.
#pragma once

#include "engine/experiment/point.h"
#include "engine/measure/flicker.h"

namespace macula::experiment {

/// Takes a path's frames in order, each beside the exact one.
class PathError {
 public:
  /// Encoded display values 0..1.
  /// @throws InputError where sizes differ or a value is not finite
  void add(const image::ImageF& reference, const image::ImageF& test);

  /// "path" of a point: {"frames", "fps", "flicker", "rmse"}. `flicker` is the mean of
  /// FlickerMeter's values, one fewer than frames, null of less than two; `rmse` the root of the
  /// mean square over all frames, null of none.
  /// @param fps frames a second, as they were drawn
  [[nodiscard]] Point toPoint(double fps) const;

 private:
  measure::FlickerMeter meter_;
  double flickers_ = 0.0;  ///< sum over the changes
  double squares_ = 0.0;   ///< sum over the frames
  int frames_ = 0;
};

}  // namespace macula::experiment
