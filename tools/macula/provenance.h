// How the results of a command were made, for its report: engine/measure/README.md has the keys.
#pragma once

#include <string>

#include "engine/gaze/gaze_settings.h"
#include "engine/measure/provenance.h"
#include "engine/settings/registry.h"

namespace macula::tools {

/// A scene file with its buffers and images, or a procedural name.
/// @throws InputError, as the others here, where a file cannot be read
[[nodiscard]] measure::Input sceneInput(const std::string& nameOrPath);
/// A gaze log with the sidecars that it is read with, or `center` or a point.
[[nodiscard]] measure::Input gazeInput(const std::string& spec, const gaze::LogOptions& options);
/// A path file, the folder of a recording, or `auto` or `scene`.
[[nodiscard]] measure::Input cameraInput(const std::string& spec);

/// Program and command line, to be filled with inputs.
[[nodiscard]] measure::Provenance provenanceOfRun();
/// The same with the files that settings name: `environment`, `network`, ... under "settings".
[[nodiscard]] measure::Provenance provenanceOfRun(const settings::Registry& registry);

/// The block of a command whose options have a scene, a gaze, a camera and frames a second.
template <typename Options>
[[nodiscard]] nlohmann::ordered_json provenanceOfFrames(const Options& options) {
  const gaze::LogOptions log = gaze::logOptionsOf(options.gazeSettings);
  measure::Provenance provenance = provenanceOfRun(options.registry);
  provenance.inputs.update({{"scene", measure::toJson(sceneInput(options.scene))},
                            {"gaze", measure::toJson(gazeInput(options.gaze, log))},
                            {"camera", measure::toJson(cameraInput(options.camera))},
                            {"fps", options.fps},
                            {"seed", options.settings.seed}});
  return measure::toJson(provenance);
}

}  // namespace macula::tools
