#include "engine/experiment/target_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "engine/experiment/target_curve.h"
#include "engine/experiment/target_mean.h"

namespace macula::experiment {
namespace {

using State = TargetRow::State;

constexpr const char* kAllFits = "everything fits";

bool listed(const std::vector<std::string>& list, const std::string& name) {
  return list.empty() || std::find(list.begin(), list.end(), name) != list.end();
}

/// Where a point stands, budget apart.
std::string placeOf(const Point& point) {
  const std::filesystem::path scene = textOf(point, "scene");
  std::string text = fmt::format("{} {}x{}", scene.stem().string(), point["width"].get<int>(),
                                 point["height"].get<int>());
  if (textOf(point, "light") != kOwnLight) text += " " + textOf(point, "light");
  if (point["seed"].get<std::int64_t>() != 1) {
    text += fmt::format(" seed {}", point["seed"].get<std::int64_t>());
  }
  return text;
}

/// The value of a point of a sweep.
std::optional<double> sweepOf(const Point& point) {
  const auto found = point.find("sweep");
  if (found == point.end() || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

class Judge {
 public:
  Judge(const Experiment& experiment, const Target& target, std::span<const Point> points)
      : experiment_(experiment), target_(target), points_(points) {}

  std::vector<TargetRow> rows() const {
    const std::string& lead =
        target_.kind == Target::Kind::Order ? target_.against.front() : target_.of;
    std::vector<TargetRow> all;
    std::vector<ScenePart> parts;
    const Point* before = nullptr;
    for (const Point& point : points_) {
      if (textOf(point, "variant") != lead || !listed(target_.studies, textOf(point, "study")) ||
          !listed(target_.scenes, textOf(point, "scene")) ||
          !listed(target_.lights, textOf(point, "light")) ||
          !listed(target_.budgets, textOf(point, "budget")) ||
          (target_.at && sweepOf(point) != target_.at)) {
        continue;
      }
      if (target_.kind == Target::Kind::Mean) {
        parts.push_back({&point, rowOf(point)});
        continue;
      }
      // All points of a curve make one row.
      const bool sameCurve =
          target_.kind == Target::Kind::Curve && before != nullptr && sameGroup(*before, point);
      if (!sameCurve) all.push_back(rowOf(point));
      before = &point;
    }
    if (target_.kind == Target::Kind::Mean) all = meansOverScenes(experiment_, target_, parts);
    if (all.empty()) {
      all.push_back({&target_,
                     "",
                     "",
                     {},
                     State::Unmeasured,
                     "no point of " + lead + " on these scenes and budgets",
                     {}});
    }
    return all;
  }

 private:
  TargetRow rowOf(const Point& point) const {
    TargetRow row{&target_, textOf(point, "study"), placeOf(point), {}, State::Unmeasured, {}, {}};
    if (target_.kind == Target::Kind::Curve) {
      judgeCurve(experiment_, points_, point, row);
      return row;
    }
    if (!textOf(point, "budget").empty()) row.where += ", " + textOf(point, "budget");
    row.where += sweptText(point, ", ");
    if (target_.kind == Target::Kind::Order) {
      judgeOrder(point, row);
      return row;
    }
    const auto value = metricOf(point, target_.metric);
    if (!value) {
      row.note = missing(point, target_.of, target_.metric);
      return row;
    }
    if (target_.divides()) {
      judgeRatio(point, *value, row);
    } else {
      judgeValue(point, *value, row);
    }
    return row;
  }

  /// `before` and the value of a sweep, as "r=2"; nothing for other points.
  std::string sweptText(const Point& point, const char* before) const {
    const auto value = sweepOf(point);
    if (!value) return "";
    return before + experiment_.variant(textOf(point, "variant")).sweep.value().label(*value);
  }

  /// The point of another variant beside this one: at its budget, else without one; of a swept
  /// variant at the value that the target names, else at the same value.
  const Point* partner(const Point& point, const std::string& variant) const {
    const Point* without = nullptr;
    const auto value = target_.againstAt ? target_.againstAt : sweepOf(point);
    for (const Point& other : points_) {
      if (textOf(other, "variant") != variant || !sameGroup(point, other)) continue;
      if (sweepOf(other) && sweepOf(other) != value) continue;
      if (textOf(other, "budget") == textOf(point, "budget")) return &other;
      if (textOf(other, "budget").empty()) without = &other;
    }
    return without;
  }

  /// Times may only be divided where the frames were interleaved.
  [[nodiscard]] bool comparable(const Point& a, const Point& b) const {
    return !target_.metric.starts_with("ms.") || interleaved(a, b);
  }

  /// What a ratio divides by.
  [[nodiscard]] const std::string& below() const {
    return target_.againstMetric.empty() ? target_.metric : target_.againstMetric;
  }

  static std::string missing(const Point& point, const std::string& variant,
                             const std::string& metric) {
    const std::string reason = textOf(point, "reason");
    return variant + ": " + (reason.empty() ? "no " + metric : reason);
  }

  void settle(double value, TargetRow& row) const {
    row.value = value;
    row.state = target_.admits(value) ? State::Met : State::Missed;
  }

  static void exempt(std::string reason, TargetRow& row) {
    row.state = State::NotApplicable;
    row.reason = std::move(reason);
  }

  void judgeRatio(const Point& point, double value, TargetRow& row) const {
    std::optional<double> least;
    std::string of;
    std::string gaps;
    for (const std::string& id : target_.against) {
      const Point* other = partner(point, id);
      if (other != nullptr && !comparable(point, *other)) {
        gaps += "; " + id + " was not interleaved with " + target_.of + ", name both in compare";
        continue;
      }
      const auto number = other == nullptr ? std::nullopt : metricOf(*other, below());
      if (number && (!least || *number < *least)) {
        least = number;
        of = id + sweptText(*other, " ");
      } else if (!number) {
        gaps +=
            "; " + (other == nullptr ? id + " has no point here" : missing(*other, id, below()));
      }
    }
    if (!least) {
      row.note = gaps.substr(2);
      return;
    }
    if (!target_.againstMetric.empty()) of += " " + target_.againstMetric;
    row.note = fmt::format("{:.4g} ({}{}) / {:.4g} ({}){}", value, target_.of,
                           sweptText(point, " "), *least, of, gaps);
    if (*least > 0.0) {
      settle(value / *least, row);
    } else if (*least == 0.0 && value == 0.0) {
      exempt("both are 0", row);
    } else {
      row.note += ": nothing to divide by";
    }
  }

  void judgeValue(const Point& point, double value, TargetRow& row) const {
    settle(value, row);
    const auto budget = metricOf(point, "bytes.budget");
    const auto generated = metricOf(point, "fragments.generated");
    const auto merged = metricOf(point, "fragments.merged").value_or(0.0);
    const auto lost = metricOf(point, "fragments.lost");
    const bool all = budget && generated && lost && *lost + merged == 0.0;
    if (target_.unlessAllStored && all) exempt(kAllFits, row);
  }

  void judgeOrder(const Point& point, TargetRow& row) const {
    bool falling = true;
    std::string least;  // the first that is at 0, where the next one is, too
    std::size_t zeros = 0;
    std::optional<double> before;
    const std::string* last = nullptr;
    for (const std::string& id : target_.against) {
      const Point* other = id == textOf(point, "variant") ? &point : partner(point, id);
      const auto value = other == nullptr ? std::nullopt : metricOf(*other, target_.metric);
      if (!value) {
        row.note =
            other == nullptr ? id + " has no point here" : missing(*other, id, target_.metric);
        return;
      }
      // Where nothing is left to lower, nothing can be compared.
      const bool atLeast = *value == 0.0 && before == 0.0;
      if (atLeast && least.empty()) least = *last;
      zeros += *value == 0.0 ? 1 : 0;
      falling = falling && (!before || *value < *before || atLeast);
      last = &id;
      row.note += fmt::format("{}{:.4g} ({})", before ? ", " : "", *value, id);
      before = value;
    }
    if (!falling) row.note = "not falling: " + row.note;
    row.state = falling ? State::Met : State::Missed;
    if (!falling || least.empty()) return;
    const bool losses = target_.metric.starts_with("fragments.lo");
    const bool allZero = zeros == target_.against.size();
    exempt(allZero ? std::string(losses ? kAllFits : "all are 0")
                   : fmt::format("{} is at 0 already", least),
           row);
  }

  const Experiment& experiment_;
  const Target& target_;
  std::span<const Point> points_;
};

}  // namespace

std::vector<TargetRow> rowsOf(const Experiment& experiment, const Target& target,
                              std::span<const Point> points) {
  return Judge(experiment, target, points).rows();
}

}  // namespace macula::experiment
