#include "engine/experiment/target.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/experiment/target_rows.h"

namespace macula::experiment {

using State = TargetRow::State;

std::string_view nameOf(TargetRow::State state) {
  switch (state) {
    case State::Met:
      return "met";
    case State::Missed:
      return "missed";
    case State::NotApplicable:
      return "n/a";
    case State::Unmeasured:
      break;
  }
  return "unmeasured";
}

namespace {

/// Places that several studies share are told apart by the study.
void nameStudies(std::vector<TargetRow>& rows) {
  const std::vector<TargetRow> before = rows;
  for (TargetRow& row : rows) {
    const bool shared = std::any_of(before.begin(), before.end(), [&](const TargetRow& other) {
      return other.where == row.where && other.study != row.study;
    });
    if (shared) row.where += ", " + row.study;
  }
}

}  // namespace

std::vector<TargetRow> judge(const Experiment& experiment, std::span<const Point> points) {
  std::vector<TargetRow> rows;
  for (const Target& target : experiment.targets) {
    std::vector<TargetRow> own = rowsOf(experiment, target, points);
    nameStudies(own);
    for (TargetRow& row : own) rows.push_back(std::move(row));
  }
  return rows;
}

std::string summaryOf(std::span<const TargetRow> rows) {
  std::string text;
  for (const State state : {State::Met, State::Missed, State::NotApplicable, State::Unmeasured}) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ",
                        std::ranges::count(rows, state, &TargetRow::state), nameOf(state));
  }
  return text;
}

nlohmann::ordered_json toJson(std::span<const TargetRow> rows) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const TargetRow& row : rows) {
    all.push_back({{"name", row.target->name},
                   {"papers", row.target->papers},
                   {"metric", row.target->metric},
                   {"study", row.study},
                   {"where", row.where},
                   {"value", row.value ? nlohmann::ordered_json(*row.value) : nullptr},
                   {"limit", row.target->limitText()},
                   {"state", nameOf(row.state)},
                   {"reason", row.reason.empty() ? nullptr : nlohmann::ordered_json(row.reason)},
                   {"note", row.note}});
  }
  return all;
}

}  // namespace macula::experiment
