// How a result was made: what a report says so that it can be made again.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace macula::measure {

/// A file that a run read. A path stands as the command line or the naming file gives it.
struct InputFile {
  std::string path;
  std::string sha256;  ///< empty: the file is missing, and was left out
};

/// One thing that a run was given by name.
struct Input {
  std::string name;         ///< "smoke", "center", "auto", or a path
  std::string path = {};    ///< empty: no file, what it stands for follows from name and seed
  std::string sha256 = {};  ///< of the file; empty for a folder
  std::vector<InputFile>
      files;  ///< further files: those that the named one refers to, in its order
};

/// The named file alone. @throws InputError where it cannot be read
[[nodiscard]] Input inputOf(const std::filesystem::path& file);

/// {"name","path","sha256","files":[{"path","sha256"}]}; what there is not is null.
[[nodiscard]] nlohmann::ordered_json toJson(const Input& input);
[[nodiscard]] nlohmann::ordered_json toJson(const std::vector<Input>& inputs);

/// What made a result. Nothing in it differs between two runs of one command: no time, no machine.
struct Provenance {
  std::string command;  ///< as a shell reads it back
  std::string version;
  std::string commit;
  /// What the run was given: scene, gaze, camera, fps, seed, ...
  nlohmann::ordered_json inputs = nlohmann::ordered_json::object();
};

/// {"command","version","commit", and each of the inputs}. Bytes that are not UTF-8 are replaced.
[[nodiscard]] nlohmann::ordered_json toJson(const Provenance& provenance);

}  // namespace macula::measure
