// Flicker: change from frame to frame that the reference does not have.
#pragma once

#include <optional>

#include "engine/image/image.h"

namespace macula::measure {

/// Takes the frames of a run in order. For frame i with test t and reference r it gives the mean of
/// |(t_i - t_(i-1)) - (r_i - r_(i-1))| over pixels and R, G, B: motion and camera cuts that both
/// show cancel, and so does an error that stays. 0..2 on display values.
class FlickerMeter {
 public:
  /// @returns none for the first frame
  /// @throws InputError where sizes differ from each other or from those of the frame before
  [[nodiscard]] std::optional<double> next(const image::ImageF& reference,
                                           const image::ImageF& test);

 private:
  /// t - r of the frame before, three channels. It stands for the pair: the mean above is that of
  /// |(t_i - r_i) - (t_(i-1) - r_(i-1))|.
  image::ImageF before_;
};

}  // namespace macula::measure
