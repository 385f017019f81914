#include "provenance.h"

#include <filesystem>
#include <fstream>
#include <vector>

#include "engine/core/file.h"
#include "engine/core/sha256.h"
#include "engine/core/shell.h"
#include "engine/gaze/log_reader.h"
#include "engine/recording/reader.h"
#include "engine/scene/gltf_loader.h"
#include "engine/scene/load.h"
#include "macula_version.h"

namespace macula::tools {
namespace {

namespace fs = std::filesystem;
using measure::Input;

/// A file beside another, whose path is relative to the folder of that.
measure::InputFile fileBeside(const fs::path& folder, const fs::path& path) {
  std::error_code error;
  const bool there = fs::is_regular_file(folder / path, error);
  return {path.string(), there ? fileSha256(folder / path) : std::string()};
}

/// The command line of this process, which keeps it in its own words; the program by its bare name.
std::string ownCommandLine() {
  std::ifstream in("/proc/self/cmdline", std::ios::binary);
  std::vector<std::string> words;
  for (std::string word; std::getline(in, word, '\0');) words.push_back(word);
  if (!words.empty()) words.front() = fs::path(words.front()).filename().string();
  return shellCommand(words);
}

}  // namespace

Input sceneInput(const std::string& nameOrPath) {
  if (!scene::isSceneFile(nameOrPath)) return {.name = nameOrPath, .files = {}};
  Input input = measure::inputOf(nameOrPath);
  const fs::path folder = fs::path(nameOrPath).parent_path();
  for (const fs::path& file : scene::referencedFiles(nameOrPath)) {
    input.files.push_back(fileBeside(folder, file));
  }
  return input;
}

Input gazeInput(const std::string& spec, const gaze::LogOptions& options) {
  std::error_code error;
  if (spec == "center" || !fs::is_regular_file(spec, error)) return {.name = spec, .files = {}};
  Input input = measure::inputOf(spec);
  for (const fs::path& file : gaze::sidecarFiles(spec, options)) {
    input.files.push_back(fileBeside({}, file));
  }
  return input;
}

Input cameraInput(const std::string& spec) {
  if (spec == "auto" || spec == "scene") return {.name = spec, .files = {}};
  if (!recording::isRecording(spec)) return measure::inputOf(spec);
  Input input{.name = spec, .path = spec, .files = {}};
  for (const char* file : {recording::kSessionFile, recording::kFramesFile}) {
    input.files.push_back(fileBeside(spec, file));
  }
  return input;
}

measure::Provenance provenanceOfRun() {
  return {.command = ownCommandLine(), .version = MACULA_VERSION, .commit = MACULA_COMMIT};
}

measure::Provenance provenanceOfRun(const settings::Registry& registry) {
  measure::Provenance provenance = provenanceOfRun();
  for (const settings::Entry& entry : registry.entries()) {
    if (entry.type() != settings::Type::Path) continue;
    const std::string path = settings::formatValue(entry.get());
    std::error_code error;
    if (!fs::is_regular_file(path, error)) continue;
    provenance.inputs["settings"][entry.key()] = measure::toJson(measure::inputOf(path));
  }
  return provenance;
}

}  // namespace macula::tools
