// The inputs of a chart: its file, the program and machine that its numbers depend on, and their
// account in its report.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/experiment/report.h"
#include "passes/device_context.h"

namespace macula::tools {

/// A file as named, or the ready-made experiment of that name.
/// @throws InputError where there is neither
[[nodiscard]] std::filesystem::path findExperiment(const std::string& name);

/// Hashes of the program, its shaders and networks, the device, and the files of scenes, cameras
/// and gaze: what a point's numbers depend on.
[[nodiscard]] experiment::Fingerprint fingerprintOf(const experiment::Experiment& experiment,
                                                    const passes::DeviceContext& device);

/// Commit, processor, GL and date.
[[nodiscard]] experiment::Provenance provenanceOf(const passes::DeviceContext& device);

/// What the experiment reads: lists in the order of its studies, each input once.
/// @param name of the experiment on the command line @param file it was read from
[[nodiscard]] nlohmann::ordered_json madeFrom(const experiment::Experiment& experiment,
                                              const std::string& name,
                                              const std::filesystem::path& file);

}  // namespace macula::tools
