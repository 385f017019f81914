// Curves of quality against speed, and how far one lies above another.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace macula::experiment {

/// A point of a swept variant.
struct CurvePoint {
  double speedup = 1.0;  ///< over the base, > 0
  double quality = 0.0;  ///< higher is better; +infinity for an image that equals the exact one
};

/// What a viewer can have: the points that no other of the curve beats in one value without losing
/// in the other, in ascending speed-up, so that quality falls strictly. A larger r that is slower
/// or better than a smaller one by the noise of a measurement would otherwise make the curve stand
/// at two heights at one speed-up. Points of infinite quality beat others and are then left out,
/// because nothing can be interpolated towards them.
[[nodiscard]] std::vector<CurvePoint> envelopeOf(std::span<const CurvePoint> points);

/// Quality of an envelope at a speed-up: linear in its logarithm between neighbours. None outside.
[[nodiscard]] std::optional<double> qualityAt(std::span<const CurvePoint> envelope, double speedup);

/// How far one envelope lies above another at equal speed-up.
struct CurveGap {
  double least = 0.0;    ///< of all differences; negative where the other lies above
  double leastAt = 1.0;  ///< the speed-up of it
  double mean = 0.0;     ///< of all differences
  double from = 1.0;     ///< the range of speed-ups that both curves have
  double to = 1.0;
  std::size_t places = 0;  ///< where they were compared
};

/// Compared at every point of either envelope in the range that both have: a difference of two
/// piecewise linear functions is least at a corner of one of them. None where they share no range.
[[nodiscard]] std::optional<CurveGap> gapBetween(std::span<const CurvePoint> envelope,
                                                 std::span<const CurvePoint> other);

}  // namespace macula::experiment
