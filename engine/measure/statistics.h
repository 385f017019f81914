// Numbers that describe a set of measurements.
#pragma once

#include <optional>
#include <span>

namespace macula::measure {

/// The value below which the share `fraction` (0..1) of the sorted values lies, interpolated
/// linearly between neighbours at position fraction * (n - 1): Hyndman & Fan 1996, type 7, which is
/// also NumPy's default. None for no values. Values must be finite.
/// @throws std::invalid_argument for a fraction outside 0..1
[[nodiscard]] std::optional<double> percentile(std::span<const double> values, double fraction);

/// percentile(values, 0.5): the middle value, or the mean of the middle two.
[[nodiscard]] std::optional<double> median(std::span<const double> values);

/// percentile(values, 0.95).
[[nodiscard]] std::optional<double> p95(std::span<const double> values);

/// Arithmetic mean; none for no values.
[[nodiscard]] std::optional<double> mean(std::span<const double> values);

/// Standard deviation of the population (divided by n); none for no values.
[[nodiscard]] std::optional<double> standardDeviation(std::span<const double> values);

}  // namespace macula::measure
