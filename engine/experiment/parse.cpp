// The experiment file as a whole, and its variants.
#include <algorithm>
#include <cctype>

#include "engine/core/error.h"
#include "engine/experiment/parse_target.h"
#include "engine/experiment/study.h"
#include "engine/settings/toml_file.h"

namespace macula::experiment {
namespace {

using settings::TypedReader;

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

std::vector<double> readSweepValues(TypedReader& reader, const std::string& key) {
  const std::string place = reader.place(key);
  const auto values = reader.get<std::vector<double>>(key, {}, kSweepForm);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto before = values.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(values.begin(), before, values[i]) != before) {
      failInput("{}: sweep: {:g} stands twice; keep one", place, values[i]);
    }
  }
  if (values.size() > kMostSweepValues) {
    failInput("{}: sweep: more than {} values; shorten the list", place, kMostSweepValues);
  }
  return values;
}

/// @param reader of { lod.r = [1, 2] } or { "lod.r" = [1, 2] }
Sweep readSweep(TypedReader reader, const std::string& place) {
  Sweep sweep;
  sweep.place = place;
  while (true) {
    const std::vector<std::string> keys = reader.keys();
    if (keys.size() != 1) failInput("{}: sweep: takes {}", place, kSweepForm);
    sweep.setting += (sweep.setting.empty() ? "" : ".") + keys.front();
    if (!reader.holdsTable(keys.front())) {
      sweep.values = readSweepValues(reader, keys.front());
      return sweep;
    }
    reader = reader.getTable(keys.front());
  }
}

Variant readVariant(TypedReader& reader) {
  Variant variant;
  variant.place = reader.place();
  variant.id = reader.get<std::string>("id");
  requireId(variant.id, variant.place);
  variant.label = variant.id;
  reader.take("label", variant.label);
  variant.settings = reader.table("settings").toml();
  reader.take("budgets", variant.budgets);
  if (reader.has("oracle")) {
    const std::size_t index =
        reader.getChoice("oracle", {"optimal-k", "least-rmse", "least-rmse-tail"});
    variant.oracle = static_cast<Oracle>(index + 1);
    if (variant.settings != nullptr || !variant.budgets) {
      failInput("{}: an oracle takes no settings, and needs budgets = true", variant.place);
    }
  }
  if (reader.has("sweep")) {
    variant.sweep = readSweep(reader.getTable("sweep"), reader.place("sweep"));
    if (variant.budgets) {
      failInput("{}: sweep: variant '{}' is measured at budgets already; keep one of the two",
                variant.sweep->place, variant.id);
    }
  }
  reader.finish();
  return variant;
}

Study readStudy(TypedReader& reader, const Study& defaults) {
  Study study = defaults;
  study.place = reader.place();
  study.id = reader.get<std::string>("id");
  requireId(study.id, study.place);
  study.title = study.id;
  reader.take("title", study.title);
  reader.take("variants", study.variants);
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
  TypedReader reader(settings::DataNode(*experiment.document), name);
  experiment.title = reader.get<std::string>("title");
  reader.take("description", experiment.description);
  reader.take("difference_scale", experiment.differenceScale, {.min = 1.0, .max = 256.0});
  reader.take("report_pixels", experiment.reportPixels,
              {.min = kLeastReportPixels, .max = kMostReportPixels}, "pixels");
  Study defaults;
  defaults.place = reader.place();
  readStudyKeys(reader, defaults);
  auto variants = reader.tables("variant");
  auto studies = reader.tables("study");
  auto targets = reader.tables("target");
  reader.finish();  // before anything is found missing that was only misspelt
  for (TypedReader& variant : variants) experiment.variants.push_back(readVariant(variant));
  if (experiment.variants.empty()) {
    failInput("{}: no variants; add [[variant]] with an id and settings", reader.place());
  }
  requireUniqueIds(experiment.variants, "variant");
  for (TypedReader& study : studies) experiment.studies.push_back(readStudy(study, defaults));
  if (experiment.studies.empty()) {
    defaults.id = "all";
    defaults.title = experiment.title;
    experiment.studies.push_back(defaults);
  }
  requireUniqueIds(experiment.studies, "study");
  for (Study& study : experiment.studies) completeStudy(study, experiment.variants);
  for (TypedReader& target : targets) {
    experiment.targets.push_back(readTarget(target, experiment));
  }
  return experiment;
}

}  // namespace macula::experiment
