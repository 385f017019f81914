// The experiment file as a whole, its variants and its targets.
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "engine/core/error.h"
#include "engine/experiment/point.h"
#include "engine/experiment/study.h"
#include "engine/settings/toml_file.h"

namespace macula::experiment {
namespace {

constexpr int kLeastReportPixels = 32;
constexpr int kMostReportPixels = 2048;

/// Ids are parts of file names and of the report's addresses.
void requireId(const std::string& id, const std::string& place) {
  const bool plain = std::all_of(id.begin(), id.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '+' || c == '.';
  });
  if (id.empty() || !plain || id.size() > 64) {
    failInput("{}: id: '{}' is no id; use 1 to 64 letters, digits, '-', '_', '+' and '.'", place,
              oneLine(id));
  }
}

Variant readVariant(const toml::table& table, const std::string& file) {
  TableReader reader(table, file);
  Variant variant;
  variant.place = reader.place();
  reader.require("id");
  reader.text("id", variant.id);
  requireId(variant.id, variant.place);
  variant.label = variant.id;
  reader.text("label", variant.label);
  variant.settings = reader.table("settings");
  reader.flag("budgets", variant.budgets);
  if (reader.has("oracle")) {
    const std::vector<std::string> names{"optimal-k", "least-rmse", "least-rmse-tail"};
    std::size_t index = 0;
    reader.choice("oracle", index, names);
    variant.oracle = static_cast<Oracle>(index + 1);
    if (reader.has("settings") || !variant.budgets) {
      failInput("{}: an oracle takes no settings, and needs budgets = true", variant.place);
    }
  }
  reader.finish();
  return variant;
}

Study readStudy(const toml::table& table, const std::string& file, const Study& defaults) {
  TableReader reader(table, file);
  Study study = defaults;
  study.place = reader.place();
  reader.require("id");
  reader.text("id", study.id);
  requireId(study.id, study.place);
  study.title = study.id;
  reader.text("title", study.title);
  reader.texts("variants", study.variants);
  readStudyKeys(reader, study);
  reader.finish();
  return study;
}

/// "<= 1.25"
void readLimit(TableReader& reader, Target& target) {
  std::string text;
  reader.require("limit");
  reader.text("limit", text);
  const bool upper = text.starts_with("<=");
  std::size_t at = 2;
  while (at < text.size() && text[at] == ' ') ++at;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data() + std::min(at, text.size()), end, target.limit);
  if ((!upper && !text.starts_with(">=")) || parsed.ec != std::errc{} || parsed.ptr != end ||
      !std::isfinite(target.limit)) {
    failInput("{}: limit: '{}' is no limit; write \"<= 1.25\" or \">= 1.5\"", reader.place("limit"),
              oneLine(text));
  }
  target.atMost = upper;
}

Target readTarget(const toml::table& table, const std::string& file,
                  const std::vector<std::string>& variants,
                  const std::vector<std::string>& studies) {
  TableReader reader(table, file);
  Target target;
  reader.require("name");
  reader.text("name", target.name);
  reader.text("papers", target.papers);
  std::size_t kind = 0;
  reader.require("kind");
  reader.choice("kind", kind, {"ratio", "order", "value"});
  target.kind = static_cast<Target::Kind>(kind);
  reader.require("metric");
  reader.text("metric", target.metric);
  requireKnown(target.metric.starts_with("ms.passes.") ? "ms.total" : target.metric, metricNames(),
               "metric", reader.place("metric"));
  if (target.kind != Target::Kind::Order) {
    reader.require("of");
    reader.text("of", target.of);
    requireKnown(target.of, variants, "variant", reader.place("of"));
    readLimit(reader, target);
  }
  if (target.kind != Target::Kind::Value) {
    const char* key = target.kind == Target::Kind::Ratio ? "against" : "order";
    reader.require(key);
    reader.texts(key, target.against);
    for (const std::string& id : target.against) {
      requireKnown(id, variants, "variant", reader.place(key));
    }
  }
  if (target.kind == Target::Kind::Value) {
    reader.flag("unless_all_stored", target.unlessAllStored);
  }
  reader.texts("studies", target.studies);
  for (const std::string& id : target.studies) {
    requireKnown(id, studies, "study", reader.place("studies"));
  }
  reader.texts("scenes", target.scenes);
  reader.texts("lights", target.lights);
  reader.texts("budgets", target.budgets);
  reader.finish();
  return target;
}

std::vector<std::string> requireUniqueIds(const auto& elements, std::string_view what) {
  std::vector<std::string> ids;
  for (const auto& element : elements) {
    if (std::find(ids.begin(), ids.end(), element.id) != ids.end()) {
      failInput("{}: {} '{}' stands twice; give it another id", element.place, what, element.id);
    }
    ids.push_back(element.id);
  }
  return ids;
}

}  // namespace

const Variant& Experiment::variant(std::string_view id) const {
  const auto found =
      std::find_if(variants.begin(), variants.end(), [&](const Variant& v) { return v.id == id; });
  if (found == variants.end()) throw std::logic_error("a variant that was not checked");
  return *found;
}

Experiment parseExperiment(const std::string& text, const std::string& name) {
  Experiment experiment;
  experiment.name = name;
  experiment.text = text;
  experiment.document = std::make_shared<const toml::table>(settings::parseToml(text, name));
  TableReader reader(*experiment.document, name);
  reader.require("title");
  reader.text("title", experiment.title);
  reader.text("description", experiment.description);
  reader.number("difference_scale", experiment.differenceScale, 1.0, 256.0);
  reader.integer("report_pixels", experiment.reportPixels, kLeastReportPixels, kMostReportPixels);
  Study defaults;
  defaults.place = reader.place();
  readStudyKeys(reader, defaults);
  const auto variantTables = reader.tables("variant");
  const auto studyTables = reader.tables("study");
  const auto targetTables = reader.tables("target");
  reader.finish();  // before anything is found missing that was only misspelt
  for (const toml::table* variant : variantTables) {
    experiment.variants.push_back(readVariant(*variant, name));
  }
  if (experiment.variants.empty()) {
    failInput("{}: no variants; add [[variant]] with an id and settings", reader.place());
  }
  requireUniqueIds(experiment.variants, "variant");
  for (const toml::table* study : studyTables) {
    experiment.studies.push_back(readStudy(*study, name, defaults));
  }
  if (experiment.studies.empty()) {
    defaults.id = "all";
    defaults.title = experiment.title;
    experiment.studies.push_back(defaults);
  }
  const auto studies = requireUniqueIds(experiment.studies, "study");
  for (Study& study : experiment.studies) completeStudy(study, experiment.variants);
  std::vector<std::string> variants;
  for (const Variant& variant : experiment.variants) variants.push_back(variant.id);
  std::vector<std::string> scenes;
  for (const Study& study : experiment.studies) {
    scenes.insert(scenes.end(), study.scenes.begin(), study.scenes.end());
  }
  for (const toml::table* target : targetTables) {
    experiment.targets.push_back(readTarget(*target, name, variants, studies));
    for (const std::string& scene : experiment.targets.back().scenes) {
      requireKnown(scene, scenes, "scene", TableReader(*target, name).place("scenes"));
    }
  }
  return experiment;
}

}  // namespace macula::experiment
