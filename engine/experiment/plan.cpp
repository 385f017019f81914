#include "engine/experiment/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>

#include "engine/core/sha256.h"

namespace macula::experiment {
namespace {

using Json = nlohmann::json;  // sorted keys: the order in the file decides nothing

constexpr std::size_t kKeyDigits = 16;

std::string keyOf(const Json& facts) {
  const std::string text = facts.dump(-1, ' ', false, Json::error_handler_t::replace);
  return sha256Hex(std::as_bytes(std::span(text))).substr(0, kKeyDigits);
}

void flatten(const toml::table& table, const std::string& prefix, Json& flat) {
  for (const auto& [key, node] : table) {
    const std::string name = prefix + std::string(key.str());
    if (const toml::table* inner = node.as_table()) {
      flatten(*inner, name + ".", flat);
    } else if (const auto flag = node.value_exact<bool>()) {
      flat[name] = *flag;
    } else if (const auto whole = node.value_exact<std::int64_t>()) {
      flat[name] = *whole;
    } else if (const auto real = node.value_exact<double>()) {
      flat[name] = *real;
    } else if (const auto text = node.value_exact<std::string>()) {
      flat[name] = *text;
    } else if (const toml::array* list = node.as_array()) {
      Json all = Json::array();
      for (const toml::node& element : *list) all.push_back(element.value_or(0.0));
      flat[name] = all;
    }
  }
}

std::string plainName(const std::string& text) {
  std::string plain;
  for (const unsigned char c : text) {
    const bool stays = std::isalnum(c) != 0 || c == '-' || c == '.' || c == '+';
    plain += stays ? static_cast<char>(c) : '-';
  }
  return plain;
}

Json groupFacts(const Group& group, const Study& study, const Fingerprint& fingerprint) {
  Json settings = Json::object();
  for (const toml::table* layer : study.settings) flatten(*layer, "", settings);
  Json facts{{"program", fingerprint.program},
             {"scene", group.scene},
             {"width", group.size.width},
             {"height", group.size.height},
             {"seed", group.seed},
             {"light", group.light},
             {"camera", study.camera},
             {"gaze", study.gaze},
             {"settings", settings},
             {"pixels_per_degree", study.pixelsPerDegree}};
  for (const std::string& name : {group.scene, study.camera, study.gaze}) {
    const auto file = fingerprint.files.find(name);
    if (file != fingerprint.files.end()) facts["files"][name] = file->second;
  }
  return facts;
}

/// Joins batches that may live together, oracles apart.
void join(std::vector<Batch>& batches, bool always) {
  std::size_t count = 0;
  for (const Batch& batch : batches) count += batch.oracles ? 0 : batch.points.size();
  if (!always && count > kMostTogether) return;
  std::vector<Batch> joined;
  for (Batch& batch : batches) {
    if (batch.oracles || joined.empty()) {
      joined.push_back(std::move(batch));
    } else {
      auto& points = joined.front().points;
      points.insert(points.end(), batch.points.begin(), batch.points.end());
    }
  }
  batches = std::move(joined);
}

/// The batches of one list of variants, one a budget, oracles apart and last, without keys.
std::vector<Batch> batchesOf(const Experiment& experiment, const std::vector<std::string>& ids,
                             const std::vector<Budget>& budgets) {
  Batch unlimited;
  Batch oracles{true, {}};
  std::vector<Batch> limited(budgets.size());
  for (const std::string& id : ids) {
    const auto index =
        static_cast<std::size_t>(&experiment.variant(id) - experiment.variants.data());
    const Variant& variant = experiment.variants[index];
    if (variant.sweep) {
      for (const double value : variant.sweep->values) {
        unlimited.points.push_back({index, std::nullopt, value, {}, {}});
      }
      continue;
    }
    if (!variant.budgets) {
      unlimited.points.push_back({index, std::nullopt, std::nullopt, {}, {}});
      continue;
    }
    for (std::size_t i = 0; i < budgets.size(); ++i) {
      Batch& batch = variant.oracle == Oracle::None ? limited[i] : oracles;
      batch.points.push_back({index, budgets[i], std::nullopt, {}, {}});
    }
  }
  std::vector<Batch> all;
  for (Batch& batch : limited) {
    if (!unlimited.points.empty()) {
      batch.points.insert(batch.points.begin(), unlimited.points.begin(), unlimited.points.end());
      unlimited.points.clear();
    }
    if (!batch.points.empty()) all.push_back(std::move(batch));
  }
  if (!unlimited.points.empty()) all.push_back(std::move(unlimited));
  if (!oracles.points.empty()) all.push_back(std::move(oracles));
  return all;
}

/// What of the frames along the camera's path decides a batch's numbers; oracles take no part.
Json pathFacts(const Batch& batch, const Study& study) {
  if (batch.oracles || study.pathFrames == 0) return nullptr;
  return {{"frames", study.pathFrames}, {"fps", study.pathFps}};
}

void giveKeys(Batch& batch, const Experiment& experiment, const Study& study, const Group& group,
              const Json& facts) {
  Json members = Json::array();
  for (const PointPlan& point : batch.points) {
    const Variant& variant = experiment.variants[point.variant];
    Json settings = Json::object();
    if (variant.settings != nullptr) flatten(*variant.settings, "", settings);
    members.push_back({{"id", variant.id},
                       {"oracle", nameOf(variant.oracle)},
                       {"settings", settings},
                       {"budget", point.budget ? point.budget->label() : ""},
                       {"sweep", point.value ? Json(variant.sweep->setting) : Json(nullptr)},
                       {"value", point.value ? Json(*point.value) : Json(nullptr)}});
  }
  for (std::size_t i = 0; i < batch.points.size(); ++i) {
    PointPlan& point = batch.points[i];
    point.key = keyOf({{"group", facts},
                       {"study", study.id},
                       {"batch", members},
                       {"frames", batch.oracles ? 0 : study.frames},
                       {"path", pathFacts(batch, study)},
                       {"flip_maps", study.flipMaps},
                       {"scale", experiment.differenceScale},
                       {"index", i}});
    const Variant& variant = experiment.variants[point.variant];
    std::string where;
    if (point.budget) where = "_" + plainName(point.budget->label());
    if (point.value) where = "_" + plainName(variant.sweep->label(*point.value));
    point.stem = fmt::format("{}_{}{}_{}", group.stem.substr(0, group.stem.rfind('_')), variant.id,
                             where, point.key.substr(0, 8));
  }
}

}  // namespace

std::string Group::label() const {
  std::string text = fmt::format("{} {}x{}", std::filesystem::path(scene).stem().string(),
                                 size.width, size.height);
  if (light != kOwnLight) text += " " + light;
  if (seed != 1) text += fmt::format(" seed {}", seed);
  return text;
}

std::vector<Group> expand(const Experiment& experiment, const Fingerprint& fingerprint) {
  std::vector<Group> groups;
  const auto add = [&](std::size_t index, const std::string& scene, const std::string& light,
                       Size size, std::int64_t seed) {
    const Study& study = experiment.studies[index];
    Group group{index, scene, size, seed, light, {}, {}, study.isOptional(scene)};
    const Json facts = groupFacts(group, study, fingerprint);
    group.stem = fmt::format("{}_{}x{}_{}_{}", plainName(std::filesystem::path(scene).stem()),
                             size.width, size.height, plainName(light), keyOf(facts).substr(0, 8));
    std::vector<Budget> budgets;
    for (const Budget& budget : study.budgets) {
      if (budget.appliesTo(scene)) budgets.push_back(budget);
    }
    for (const auto& ids : study.compare) {
      std::vector<Batch> batches = batchesOf(experiment, ids, budgets);
      join(batches, study.comparesByList);
      for (Batch& batch : batches) {
        giveKeys(batch, experiment, study, group, facts);
        group.batches.push_back(std::move(batch));
      }
    }
    groups.push_back(std::move(group));
  };
  for (std::size_t i = 0; i < experiment.studies.size(); ++i) {
    const Study& study = experiment.studies[i];
    for (const std::string& scene : study.scenes) {
      for (const std::string& light : study.lights) {
        for (const Size& size : study.sizes) {
          for (const std::int64_t seed : study.seeds) add(i, scene, light, size, seed);
        }
      }
    }
  }
  return groups;
}

}  // namespace macula::experiment
