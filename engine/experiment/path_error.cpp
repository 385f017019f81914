#include "engine/experiment/path_error.h"

#include <cmath>

#include "engine/measure/image_error.h"

namespace macula::experiment {

void PathError::add(const image::ImageF& reference, const image::ImageF& test) {
  measure::CompareOptions numbersOnly;
  numbersOnly.flip = false;
  const double rmse = measure::compareImages(reference, test, numbersOnly).rmse;
  flickers_ += meter_.next(reference, test).value_or(0.0);
  squares_ += rmse * rmse;
  ++frames_;
}

Point PathError::toPoint(double fps) const {
  return {{"frames", frames_},
          {"fps", fps},
          {"flicker", frames_ > 1 ? Point(flickers_ / (frames_ - 1)) : Point(nullptr)},
          {"rmse", frames_ > 0 ? Point(std::sqrt(squares_ / frames_)) : Point(nullptr)}};
}

}  // namespace macula::experiment
