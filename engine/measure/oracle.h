// Oracles: which layers to keep under a budget when every fragment is known. They say how much a
// method that must guess could still win.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <utility>
#include <vector>

#include "engine/measure/fragment_image.h"

namespace macula::measure {

/// Slots of every pixel, and what comes of them.
struct LayerChoice {
  std::vector<std::uint32_t> k;  ///< slots of each pixel, at most its depth
  std::uint64_t slots = 0;       ///< sum of k
  std::vector<glm::vec3> image;  ///< display values
  double rmse = 0.0;  ///< against all layers, over R, G and B of all pixels, display values
};

/// The image and the error of any choice of k; k beyond a pixel's depth counts as its depth.
/// @param k one entry a pixel
/// @throws std::invalid_argument where k or the image does not fit its size
[[nodiscard]] LayerChoice evaluate(const FragmentImage& image, std::vector<std::uint32_t> k,
                                   Tail tail, const DisplayTransform& display = displayColour);

/// Optimal K (Tsopouridis 2021, Algorithm 23): beginning with all fragments, takes one away where
/// the pixel then differs least from its exact colour, again and again, until `budget` are left.
/// Every covered pixel keeps one, so that a budget below coveredPixels() is exceeded. Ties go to
/// the lower pixel index. As published there is no tail.
/// @param budget fragments to keep, sum of k
[[nodiscard]] LayerChoice optimalK(const FragmentImage& image, std::uint64_t budget,
                                   const DisplayTransform& display = displayColour);

struct LeastRmseChoice : LayerChoice {
  /// No choice of as many slots, one for each covered pixel where there are that many, has a lower
  /// RMSE. Equal to `rmse` where the budget is met on the hulls: this choice is then the best.
  double bound = 0.0;
};

/// The k of least RMSE for a budget. The squared error e(k) of each pixel, k = 1 to its depth, is
/// replaced by its lower convex hull; steps along the hulls are taken in order of gain per slot
/// (Lagrangian relaxation: Everett 1963, "Generalized Lagrange Multiplier Method"; with hulls for
/// discrete choices, Shoham & Gersho 1988). Where the next step no longer fits, smaller ones are
/// taken, and then the best steps inside hulls. Slots stay unused only where every pixel has all
/// its layers or where any use of them raises the error.
/// Ties go to the lower pixel index. Every covered pixel gets at least one slot where the budget
/// has that many; below, k may be 0. O(F log F) time and O(F) memory for F fragments.
/// @param budget slots, never exceeded
[[nodiscard]] LeastRmseChoice leastRmse(const FragmentImage& image, std::uint64_t budget, Tail tail,
                                        const DisplayTransform& display = displayColour);

/// e(k) of one pixel after another: sums of squared differences over R, G and B of display values.
class ErrorCurve {
 public:
  /// The image must outlive the curve.
  ErrorCurve(const FragmentImage& image, Tail tail, DisplayTransform display)
      : image_(image), display_(std::move(display)), sweep_(tail) {}
  /// @returns e(0) ... e(depth) = 0, valid until the next call
  [[nodiscard]] std::span<const double> of(std::size_t pixel);

 private:
  const FragmentImage& image_;
  DisplayTransform display_;
  LayerSweep sweep_;
  std::vector<double> errors_;
};

}  // namespace macula::measure
