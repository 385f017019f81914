// Targets, judged from points.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/experiment/point.h"

namespace macula::experiment {

/// A target on one scene, size, seed, light and budget.
struct TargetRow {
  enum class State : std::uint8_t {
    Met,
    Missed,
    NotApplicable,  ///< measured, but the target says nothing here: neither met nor missed
    Unmeasured,
  };
  const Target* target = nullptr;
  std::string study;
  std::string where;            ///< "smoke 384x384, k_ave 2"; empty where nothing matches at all
  std::optional<double> value;  ///< none for an order
  State state = State::Unmeasured;
  std::string note;    ///< what the value is made of, or why there is none
  std::string reason;  ///< why the target is not applicable, as "everything fits"; else empty
};

/// "met", "missed", "n/a" or "unmeasured"
[[nodiscard]] std::string_view nameOf(TargetRow::State state);

/// "2 met, 1 missed, 3 n/a, 0 unmeasured"
[[nodiscard]] std::string summaryOf(std::span<const TargetRow> rows);

/// All rows, in the order of the targets. A target that no point can answer gets one row that says
/// so: a target never falls silent.
[[nodiscard]] std::vector<TargetRow> judge(const Experiment& experiment,
                                           std::span<const Point> points);

[[nodiscard]] nlohmann::ordered_json toJson(std::span<const TargetRow> rows);

}  // namespace macula::experiment
