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
using settings::TypedReader;

/// "<= 1.25"
void readLimit(TypedReader& reader, Target& target) {
  const auto text = reader.get<std::string>("limit");
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
void requireMetric(const std::string& metric, const std::string& place) {
  if (!metric.starts_with("ms.passes.")) requireKnown(metric, metricNames(), "metric", place);
}

void takeMetric(TypedReader& reader, const char* key, std::string& metric) {
  if (!reader.has(key)) return;
  metric = reader.get<std::string>(key);
  requireMetric(metric, reader.place(key));
}

/// Reads `at` or `against_at`, which names a point of a swept variant.
void readAt(TypedReader& reader, const char* key, const Variant& variant,
            std::optional<double>& value) {
  reader.take(key, value);
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
void readCurve(TypedReader& reader, const Experiment& experiment, Target& target) {
  takeMetric(reader, "cost", target.cost);
  reader.takeChoice("statistic", target.statistic, {"least", "mean"});
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
void readPoints(TypedReader& reader, const Experiment& experiment, Target& target) {
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
void readSubject(TypedReader& reader, const Experiment& experiment, Target& target) {
  const std::vector<std::string> variants = idsOf(experiment.variants);
  target.metric = reader.get<std::string>("metric");
  requireMetric(target.metric, reader.place("metric"));
  if (target.kind != Kind::Order) {
    target.of = reader.get<std::string>("of");
    requireKnown(target.of, variants, "variant", reader.place("of"));
    readLimit(reader, target);
  }
  if (target.kind != Kind::Value) {
    const char* key = target.kind == Kind::Order ? "order" : "against";
    target.against = reader.getTexts(key);
    for (const std::string& id : target.against) {
      requireKnown(id, variants, "variant", reader.place(key));
    }
  }
  if (target.divides()) takeMetric(reader, "against_metric", target.againstMetric);
  if (target.kind == Kind::Value) reader.take("unless_all_stored", target.unlessAllStored);
  if (target.kind == Kind::Curve) {
    readCurve(reader, experiment, target);
  } else {
    readPoints(reader, experiment, target);
  }
}

}  // namespace

Target readTarget(settings::TypedReader& reader, const Experiment& experiment) {
  Target target;
  target.name = reader.get<std::string>("name");
  reader.take("papers", target.papers);
  target.kind =
      static_cast<Kind>(reader.getChoice("kind", {"ratio", "order", "value", "curve", "mean"}));
  readSubject(reader, experiment, target);
  reader.take("studies", target.studies);
  for (const std::string& id : target.studies) {
    requireKnown(id, idsOf(experiment.studies), "study", reader.place("studies"));
  }
  std::vector<std::string> scenes;
  for (const Study& study : experiment.studies) {
    scenes.insert(scenes.end(), study.scenes.begin(), study.scenes.end());
  }
  reader.take("scenes", target.scenes);
  for (const std::string& scene : target.scenes) {
    requireKnown(scene, scenes, "scene", reader.place("scenes"));
  }
  reader.take("lights", target.lights);
  reader.take("budgets", target.budgets);
  reader.finish();
  return target;
}

}  // namespace macula::experiment
