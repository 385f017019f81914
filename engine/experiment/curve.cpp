#include "engine/experiment/curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace macula::experiment {

std::vector<CurvePoint> envelopeOf(std::span<const CurvePoint> points) {
  std::vector<CurvePoint> sorted(points.begin(), points.end());
  std::sort(sorted.begin(), sorted.end(), [](const CurvePoint& a, const CurvePoint& b) {
    return a.speedup != b.speedup ? a.speedup > b.speedup : a.quality > b.quality;
  });
  // From the fastest: who is slower must be better than all before.
  std::vector<CurvePoint> kept;
  double best = -std::numeric_limits<double>::infinity();
  for (const CurvePoint& point : sorted) {
    if (point.quality <= best) continue;
    best = point.quality;
    if (std::isfinite(best)) kept.push_back(point);
  }
  std::reverse(kept.begin(), kept.end());
  return kept;
}

std::optional<double> qualityAt(std::span<const CurvePoint> envelope, double speedup) {
  if (envelope.empty() || speedup < envelope.front().speedup || speedup > envelope.back().speedup) {
    return std::nullopt;
  }
  const auto right = std::find_if(envelope.begin(), envelope.end(), [&](const CurvePoint& point) {
    return point.speedup >= speedup;
  });
  if (right->speedup == speedup) return right->quality;
  const CurvePoint& left = *std::prev(right);
  const double share = std::log(speedup / left.speedup) / std::log(right->speedup / left.speedup);
  return left.quality + share * (right->quality - left.quality);
}

std::optional<CurveGap> gapBetween(std::span<const CurvePoint> envelope,
                                   std::span<const CurvePoint> other) {
  std::vector<double> places;
  for (const auto& curve : {envelope, other}) {
    for (const CurvePoint& point : curve) places.push_back(point.speedup);
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  CurveGap gap;
  double sum = 0.0;
  for (const double place : places) {
    const auto own = qualityAt(envelope, place);
    const auto others = qualityAt(other, place);
    if (!own || !others) continue;
    const double difference = *own - *others;
    if (gap.places == 0) gap.from = place;
    if (gap.places == 0 || difference < gap.least) {
      gap.least = difference;
      gap.leastAt = place;
    }
    gap.to = place;
    sum += difference;
    ++gap.places;
  }
  if (gap.places == 0) return std::nullopt;
  gap.mean = sum / static_cast<double>(gap.places);
  return gap;
}

}  // namespace macula::experiment
