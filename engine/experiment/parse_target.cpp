#include "engine/experiment/parse_target.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "engine/core/error.h"
#include "engine/experiment/point.h"
#include "engine/experiment/study.h"

namespace macula::experiment {
namespace {

using Kind = Target::Kind;

/// "<= 1.25"
void readLimit(TableReader& reader, Target& target) {
  std::string text;
  reader.require("limit");
  reader.text("limit", text);
  const bool upper = text.starts_with("<=");
  const bool lower = text.starts_with(">=");
  std::size_t at = upper || lower ? 2 : 1;
  while (at < text.size() && text[at] == ' ') ++at;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data() + std::min(at, text.size()), end, target.limit);
  if (!(upper || text.starts_with(">")) || parsed.ec != std::errc{} || parsed.ptr != end ||
      !std::isfinite(target.limit)) {
    failInput("{}: limit: '{}' is no limit; write \"<= 1.25\", \">= 1.5\" or \"> 0\"",
              reader.place("limit"), oneLine(text));
  }
  target.bound = upper   ? Target::Bound::AtMost
                 : lower ? Target::Bound::AtLeast
                         : Target::Bound::Above;
}

/// Any metric of results.csv; times of passes go by names that only a frame knows.
void readMetric(TableReader& reader, const char* key, std::string& metric) {
  reader.text(key, metric);
  if (metric.empty() || metric.starts_with("ms.passes.")) return;
  requireKnown(metric, metricNames(), "metric", reader.place(key));
}

/// Reads `at` or `against_at`, which names a point of a swept variant.
void readAt(TableReader& reader, const char* key, const Variant& variant,
            std::optional<double>& value) {
  reader.number(key, value);
  if (!value) return;
  if (!variant.sweep) {
    failInput("{}: {}: variant '{}' has no sweep; leave it out", reader.place(key), key,
              variant.id);
  }
  if (variant.sweep->holds(*value)) return;
  std::string known;
  for (const double v : variant.sweep->values)
    known += fmt::format("{}{:g}", known.empty() ? "" : ", ", v);
  failInput("{}: {}: {:g} is no value of the sweep of '{}'; it has {}", reader.place(key), key,
            *value, variant.id, known);
}

/// What only curves say, checked.
void readCurve(TableReader& reader, const Experiment& experiment, Target& target) {
  readMetric(reader, "cost", target.cost);
  std::size_t statistic = 0;
  reader.choice("statistic", statistic, {"least", "mean"});
  target.statistic = static_cast<Target::Statistic>(statistic);
  if (target.metric != "psnr_db") {
    failInput("{}: metric: curves are of psnr_db; give that, or another kind",
              reader.place("metric"));
  }
  if (target.against.size() != 1) {
    failInput("{}: against: a curve is held against one other; give one variant",
              reader.place("against"));
  }
  for (const auto& [key, id] : {std::pair{"of", target.of}, {"against", target.against.front()}}) {
    if (experiment.variant(id).sweep) continue;
    failInput("{}: {}: variant '{}' has no sweep, so it is no curve; give it one, or another kind",
              reader.place(key), key, oneLine(id));
  }
}

/// Which points of swept variants a target is about.
void readPoints(TableReader& reader, const Experiment& experiment, Target& target) {
  const bool order = target.kind == Kind::Order;
  readAt(reader, "at", experiment.variant(order ? target.against.front() : target.of), target.at);
  if (!target.divides()) return;
  const bool lead = experiment.variant(target.of).sweep.has_value();
  for (const std::string& id : target.against) {
    const Variant& variant = experiment.variant(id);
    if (variant.sweep || target.against.size() == 1) {
      readAt(reader, "against_at", variant, target.againstAt);
    }
    if (variant.sweep && !lead && !target.againstAt) {
      failInput("{}: against: '{}' is swept and '{}' is not; say which point, against_at = {:g}",
                reader.place("against"), id, target.of, variant.sweep->values.front());
    }
  }
}

std::vector<std::string> idsOf(const auto& elements) {
  std::vector<std::string> ids;
  for (const auto& element : elements) ids.push_back(element.id);
  return ids;
}

/// Whom and which numbers a target is about.
void readSubject(TableReader& reader, const Experiment& experiment, Target& target) {
  const std::vector<std::string> variants = idsOf(experiment.variants);
  reader.require("metric");
  readMetric(reader, "metric", target.metric);
  if (target.kind != Kind::Order) {
    reader.require("of");
    reader.text("of", target.of);
    requireKnown(target.of, variants, "variant", reader.place("of"));
    readLimit(reader, target);
  }
  if (target.kind != Kind::Value) {
    const char* key = target.kind == Kind::Order ? "order" : "against";
    reader.require(key);
    reader.textOrTexts(key, target.against);
    for (const std::string& id : target.against) {
      requireKnown(id, variants, "variant", reader.place(key));
    }
  }
  if (target.divides()) readMetric(reader, "against_metric", target.againstMetric);
  if (target.kind == Kind::Value) reader.flag("unless_all_stored", target.unlessAllStored);
  if (target.kind == Kind::Curve) {
    readCurve(reader, experiment, target);
  } else {
    readPoints(reader, experiment, target);
  }
}

}  // namespace

Target readTarget(const toml::table& table, const Experiment& experiment) {
  TableReader reader(table, experiment.name);
  Target target;
  reader.require("name");
  reader.text("name", target.name);
  reader.text("papers", target.papers);
  std::size_t kind = 0;
  reader.require("kind");
  reader.choice("kind", kind, {"ratio", "order", "value", "curve", "mean"});
  target.kind = static_cast<Kind>(kind);
  readSubject(reader, experiment, target);
  reader.texts("studies", target.studies);
  for (const std::string& id : target.studies) {
    requireKnown(id, idsOf(experiment.studies), "study", reader.place("studies"));
  }
  std::vector<std::string> scenes;
  for (const Study& study : experiment.studies) {
    scenes.insert(scenes.end(), study.scenes.begin(), study.scenes.end());
  }
  reader.texts("scenes", target.scenes);
  for (const std::string& scene : target.scenes) {
    requireKnown(scene, scenes, "scene", reader.place("scenes"));
  }
  reader.texts("lights", target.lights);
  reader.texts("budgets", target.budgets);
  reader.finish();
  return target;
}

}  // namespace macula::experiment
