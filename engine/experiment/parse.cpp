// The experiment file as a whole, and its variants.
#include <algorithm>
#include <cctype>
#include <cmath>

#include "engine/core/error.h"
#include "engine/experiment/parse_target.h"
#include "engine/experiment/study.h"
#include "engine/settings/toml_file.h"

namespace macula::experiment {
namespace {

constexpr int kLeastReportPixels = 32;
constexpr int kMostReportPixels = 2048;
/// All points of a sweep are renderers that live at the same time.
constexpr std::size_t kMostSweepValues = 64;

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

constexpr const char* kSweepForm = "one setting and its values, { lod.r = [1.25, 2, 4] }";

std::vector<double> readSweepValues(const toml::array& list, const std::string& place) {
  std::vector<double> values;
  for (const toml::node& element : list) {
    const auto value = element.is_number() ? element.value<double>() : std::nullopt;
    if (!value || !std::isfinite(*value)) {
      failInput("{}: sweep: takes {}, all of them finite numbers", place, kSweepForm);
    }
    if (std::find(values.begin(), values.end(), *value) != values.end()) {
      failInput("{}: sweep: {:g} stands twice; keep one", place, *value);
    }
    values.push_back(*value);
    if (values.size() > kMostSweepValues) {
      failInput("{}: sweep: more than {} values; shorten the list", place, kMostSweepValues);
    }
  }
  if (values.empty()) failInput("{}: sweep: takes {}", place, kSweepForm);
  return values;
}

/// @param table { lod.r = [1, 2] } or { "lod.r" = [1, 2] }
Sweep readSweep(const toml::table& table, const std::string& place) {
  Sweep sweep;
  sweep.place = place;
  const toml::table* inner = &table;
  while (inner != nullptr) {
    if (inner->size() != 1) failInput("{}: sweep: takes {}", place, kSweepForm);
    const auto only = inner->begin();  // what it points to lives in the iterator
    const auto& [key, node] = *only;
    sweep.setting += (sweep.setting.empty() ? "" : ".") + std::string(key.str());
    if (const toml::array* list = node.as_array()) {
      sweep.values = readSweepValues(*list, place);
      return sweep;
    }
    inner = node.as_table();
  }
  failInput("{}: sweep: takes {}", place, kSweepForm);
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
  if (const toml::table* sweep = reader.table("sweep")) {
    variant.sweep = readSweep(*sweep, reader.place("sweep"));
    if (variant.budgets) {
      failInput("{}: sweep: variant '{}' is measured at budgets already; keep one of the two",
                variant.sweep->place, variant.id);
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

void requireUniqueIds(const auto& elements, std::string_view what) {
  std::vector<std::string> ids;
  for (const auto& element : elements) {
    if (std::find(ids.begin(), ids.end(), element.id) != ids.end()) {
      failInput("{}: {} '{}' stands twice; give it another id", element.place, what, element.id);
    }
    ids.push_back(element.id);
  }
}

}  // namespace

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
  requireUniqueIds(experiment.studies, "study");
  for (Study& study : experiment.studies) completeStudy(study, experiment.variants);
  for (const toml::table* target : targetTables) {
    experiment.targets.push_back(readTarget(*target, experiment));
  }
  return experiment;
}

}  // namespace macula::experiment
