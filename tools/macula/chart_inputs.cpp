#include "chart_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <span>
#include <thread>

#include "chart_settings.h"
#include "common.h"
#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/core/nearest.h"
#include "engine/core/sha256.h"
#include "engine/scene/load.h"
#include "engine/settings/toml_file.h"
#include "macula_version.h"
#include "provenance.h"

namespace macula::tools {
namespace {

namespace fs = std::filesystem;
using namespace experiment;

std::string hashOf(std::string_view bytes) {
  return sha256Hex(std::as_bytes(std::span(bytes)));
}

/// The program itself, its shaders and networks, and where they run: numbers of another are not
/// these numbers.
std::string programFingerprint(const passes::DeviceContext& device) {
  std::string all = fmt::format("{} {} {} {} ", MACULA_COMMIT, device.capabilities.renderer,
                                device.capabilities.version, std::thread::hardware_concurrency());
  all += hashOf(readTextFile(fs::read_symlink("/proc/self/exe")));
  std::vector<fs::path> files;
  for (const fs::path& folder : {dataFolder("shaders"), dataFolder("assets") / "networks"}) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.is_regular_file()) files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) all += hashOf(readTextFile(file));
  return hashOf(all);
}

/// Hashes of the networks that settings name in place of those of assets/.
std::string networksNamedBy(const Experiment& experiment) {
  std::string hashes;
  const auto add = [&](const VariantSettings& settings) {
    const fs::path& network = settings.render.oit.network;
    std::error_code error;
    if (fs::is_regular_file(network, error)) hashes += " " + hashOf(readTextFile(network));
  };
  for (const Study& study : experiment.studies) {
    VariantSettings shared;
    for (const toml::table* layer : study.settings) {
      settings::applyTable(shared.registry, *layer, experiment.name);
    }
    add(shared);
  }
  for (const Variant& variant : experiment.variants) {
    VariantSettings own;
    own.applyVariant(experiment, variant);
    add(own);
  }
  return hashes;
}

std::string processorName() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) {
      return line.substr(colon + 2);
    }
  }
  return "unknown";
}

}  // namespace

fs::path findExperiment(const std::string& name) {
  const fs::path path(name);
  if (path.extension() == ".toml" || path.has_parent_path() || fs::is_regular_file(path)) {
    return path;
  }
  const fs::path folder = dataFolder("assets") / "experiments";
  const fs::path ready = folder / (name + ".toml");
  if (fs::exists(ready)) return ready;
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  failInput("{}: no such experiment; did you mean '{}'? Otherwise name a .toml file", name,
            nearestName(name, names));
}

Fingerprint fingerprintOf(const Experiment& experiment, const passes::DeviceContext& device) {
  Fingerprint fingerprint{programFingerprint(device) + networksNamedBy(experiment), {}};
  std::error_code error;
  const auto add = [&](const std::string& name) {
    if (fs::is_regular_file(name, error)) fingerprint.files[name] = hashOf(readTextFile(name));
  };
  for (const Study& study : experiment.studies) {
    for (const std::string& scene : study.scenes) add(scene);
    add(study.camera);
    add(study.gaze);
  }
  return fingerprint;
}

Provenance provenanceOf(const passes::DeviceContext& device) {
  const std::time_t now = std::time(nullptr);
  char date[16];
  std::strftime(date, sizeof(date), "%Y-%m-%d", std::gmtime(&now));
  return {MACULA_COMMIT,
          processorName(),
          static_cast<int>(std::thread::hardware_concurrency()),
          device.capabilities.renderer,
          device.capabilities.version,
          device.time.source == gl::TimeSource::Finish ? "glFinish and a steady clock"
                                                       : "GL timer queries",
          date,
          {}};
}

nlohmann::ordered_json madeFrom(const Experiment& experiment, const std::string& name,
                                const fs::path& file) {
  using nlohmann::ordered_json;
  measure::Provenance made = provenanceOfRun();
  ordered_json& inputs = made.inputs;
  measure::Input own = measure::inputOf(file);
  own.name = name;
  inputs["experiment"] = measure::toJson(own);
  for (const char* key : {"scene", "gaze", "camera", "fps", "seed"}) {
    inputs[key] = ordered_json::array();
  }
  const auto add = [&](const char* key, const ordered_json& value) {
    ordered_json& list = inputs[key];
    if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
  };
  for (const Study& study : experiment.studies) {
    for (const std::string& scene : study.scenes) {
      const bool absent = scene::isSceneFile(scene) && !fs::exists(scene);  // an optional one
      if (!absent) add("scene", measure::toJson(sceneInput(scene)));
    }
    add("gaze", measure::toJson(gazeInput(study.gaze, {})));
    add("camera", measure::toJson(cameraInput(study.camera)));
    if (study.pathFrames > 0) add("fps", study.pathFps);
    for (const std::int64_t seed : study.seeds) add("seed", seed);
  }
  return measure::toJson(made);
}

}  // namespace macula::tools
