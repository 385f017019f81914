#include "engine/measure/statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace macula::measure {

std::optional<double> percentile(std::span<const double> values, double fraction) {
  if (!(fraction >= 0.0 && fraction <= 1.0)) {
    throw std::invalid_argument("a percentile's fraction lies from 0 to 1");
  }
  if (values.empty()) return std::nullopt;
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  const double position = fraction * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  const double share = position - static_cast<double>(below);
  return sorted[below] + share * (sorted[above] - sorted[below]);
}

std::optional<double> median(std::span<const double> values) {
  return percentile(values, 0.5);
}

std::optional<double> p95(std::span<const double> values) {
  return percentile(values, 0.95);
}

std::optional<double> mean(std::span<const double> values) {
  if (values.empty()) return std::nullopt;
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

std::optional<double> standardDeviation(std::span<const double> values) {
  const auto centre = mean(values);
  if (!centre) return std::nullopt;
  double squares = 0.0;
  for (const double value : values) squares += (value - *centre) * (value - *centre);
  return std::sqrt(squares / static_cast<double>(values.size()));
}

}  // namespace macula::measure
