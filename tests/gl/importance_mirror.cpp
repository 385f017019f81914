#include "importance_mirror.h"

#include <algorithm>
#include <cmath>

namespace macula::test {

double importanceOf(glm::dvec2 p, glm::dvec2 o, glm::dvec2 size, double layers,
                    const MirrorSettings& s) {
  const double depth = s.rangeBias + (1.0 - s.rangeBias) * std::min(1.0, layers / s.layerLimit);
  const double diagonal = std::hypot(size.x, size.y);
  const double distance = std::max(0.0, std::hypot(p.x - o.x, p.y - o.y) - s.widened);
  const double away = 2.0 * distance / (1.1 * diagonal);
  const double periphery = std::clamp(1.0 - std::pow(away, s.periphery), 0.0, 1.0);
  return depth * periphery;
}

std::vector<std::uint32_t> layersOf(const std::vector<std::uint32_t>& importance,
                                    const std::vector<std::uint32_t>& counts, std::uint64_t slots) {
  std::uint64_t total = 0;
  std::uint64_t covered = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    total += importance[i];
    ++covered;
  }
  const auto share = [&](std::uint64_t value, std::uint64_t of) {
    return total == 0 ? 0 : value * of / total;
  };
  std::uint64_t starved = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] > 0 && share(importance[i], slots - covered) == 0) ++starved;
  }
  std::vector<std::uint32_t> k(counts.size(), 0);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    k[i] = static_cast<std::uint32_t>(
        std::max<std::uint64_t>(1, share(importance[i], slots - starved)));
  }
  return k;
}

}  // namespace macula::test
