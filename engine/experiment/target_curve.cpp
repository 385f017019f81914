#include "engine/experiment/target_curve.h"

#include <fmt/format.h>

#include <limits>

#include "engine/core/plural.h"
#include "engine/experiment/curve.h"
#include "engine/experiment/speedup.h"

namespace macula::experiment {
namespace {

/// The points of a swept variant as a curve, and what was left out of it.
struct Curve {
  std::vector<CurvePoint> envelope;
  std::size_t points = 0;  ///< with speed-up and quality
  std::size_t exact = 0;   ///< of them, those that equal the exact image
};

/// The metric of a point; infinite where it has none because its image is the exact one.
std::optional<double> qualityOf(const Point& point, const std::string& metric) {
  const auto quality = metricOf(point, metric);
  if (!quality && metricOf(point, "rmse") == 0.0) return std::numeric_limits<double>::infinity();
  return quality;
}

class CurveJudge {
 public:
  CurveJudge(const Experiment& experiment, std::span<const Point> points, const Point& lead,
             TargetRow& row)
      : points_(points),
        lead_(lead),
        target_(*row.target),
        base_(baseOf(experiment, points, lead)),
        row_(row) {}

  void judge() {
    if (base_ == nullptr) {
      row_.note = "nothing to be faster than: the study needs a base that is interleaved with " +
                  target_.of;
      return;
    }
    const std::string& other = target_.against.front();
    const Curve own = curveOf(target_.of);
    const Curve others = curveOf(other);
    const auto gap = gapBetween(own.envelope, others.envelope);
    if (gap) {
      const bool least = target_.statistic == Target::Statistic::Least;
      row_.value = least ? gap->least : gap->mean;
      row_.state = target_.admits(*row_.value) ? TargetRow::State::Met : TargetRow::State::Missed;
      row_.note =
          fmt::format("{} over {} at {} from {:.3g} to {:.3g}: least {:.3g} at {:.3g}, mean {:.3g}",
                      target_.of, other, counted(gap->places, "speed-up"), gap->from, gap->to,
                      gap->least, gap->leastAt, gap->mean);
    } else {
      row_.note =
          "no speed-up that both have: " + rangeOf(target_.of, own) + ", " + rangeOf(other, others);
    }
    noteLeftOut(target_.of, own);
    noteLeftOut(other, others);
  }

 private:
  Curve curveOf(const std::string& variant) const {
    Curve curve;
    std::vector<CurvePoint> all;
    for (const Point& point : points_) {
      if (textOf(point, "variant") != variant || !sameGroup(lead_, point)) continue;
      if (!interleaved(*base_, point)) continue;
      const auto speedup = speedupOf(*base_, point, target_.cost);
      const auto quality = qualityOf(point, target_.metric);
      if (!speedup || !quality) continue;
      all.push_back({*speedup, *quality});
      curve.exact += *quality == std::numeric_limits<double>::infinity() ? 1 : 0;
    }
    curve.points = all.size();
    curve.envelope = envelopeOf(all);
    return curve;
  }

  static std::string rangeOf(const std::string& variant, const Curve& curve) {
    if (curve.envelope.empty()) return variant + " none";
    return fmt::format("{} {:.3g} to {:.3g}", variant, curve.envelope.front().speedup,
                       curve.envelope.back().speedup);
  }

  void noteLeftOut(const std::string& variant, const Curve& curve) {
    const std::size_t beaten = curve.points - curve.exact - curve.envelope.size();
    if (curve.exact > 0) row_.note += fmt::format("; {} of {} exact", curve.exact, variant);
    if (beaten > 0) row_.note += fmt::format("; {} of {} beaten by its others", beaten, variant);
  }

  std::span<const Point> points_;
  const Point& lead_;
  const Target& target_;
  const Point* base_;
  TargetRow& row_;
};

}  // namespace

void judgeCurve(const Experiment& experiment, std::span<const Point> points, const Point& lead,
                TargetRow& row) {
  CurveJudge(experiment, points, lead, row).judge();
}

}  // namespace macula::experiment
