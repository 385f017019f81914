// What several subcommands need.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "engine/core/progress.h"
#include "engine/gl/program.h"
#include "engine/recording/frame_source.h"
#include "engine/scene/camera_path.h"
#include "engine/scene/environment.h"
#include "engine/scene/scene.h"
#include "engine/window/headless.h"
#include "passes/render_settings.h"

namespace macula::tools {

/// What was compared is not the same: one line, and exit status 1.
class Difference : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// "1024x768". @throws InputError naming the option; sides from 1 to 16384
[[nodiscard]] glm::ivec2 parseSize(const std::string& text);

/// Width over height.
[[nodiscard]] inline float aspectOf(glm::ivec2 size) {
  return static_cast<float>(size.x) / static_cast<float>(size.y);
}

/// "0.3,0.7", both from 0 to 1. @throws InputError naming the option, for example "--probe"
[[nodiscard]] glm::vec2 parsePlace(const std::string& option, const std::string& text);

/// Makes a scene as the renderer wants it: as transparent as scene.opacity says, lit as
/// scene.lighting says, with default lights where it has none, drawn as scene.order says.
void prepareForRendering(scene::Scene& scene, const passes::RenderSettings& settings);

/// A scene after prepareForRendering().
struct LoadedScene {
  scene::Scene scene;
  std::optional<scene::Environment> environment;
  double loadMs = 0.0;
};

/// @param nameOrPath procedural name or file
[[nodiscard]] LoadedScene loadForRendering(const std::string& nameOrPath,
                                           const passes::RenderSettings& settings);

/// Where a scene is first looked at from: its first camera, or else the beginning of its orbit.
[[nodiscard]] scene::Camera startCamera(const scene::Scene& scene);

/// Says what of a scene is not drawn as it is given, a line each on standard error.
/// @param camera, aspect of the first frame: they decide which lights it has
void printWarnings(const scene::Scene& scene, const scene::Camera& camera, float aspect);

/// `auto`, `scene`, or what readCamera() takes.
[[nodiscard]] scene::CameraPath parseCameraSpec(const std::string& spec, const scene::Scene& scene);
/// A path file or the folder of a recording. @throws InputError naming --camera, file and place
[[nodiscard]] scene::CameraPath readCamera(const std::string& file);

/// Adds `--out DIR` and `--force`, for OutputFolder.
template <typename Path>
CLI::Option* addOutOption(CLI::App& command, Path& folder, bool& force, const std::string& help) {
  CLI::Option* out = command.add_option("--out", folder, help)->type_name("DIR");
  command
      .add_flag("--force", force,
                "Write into --out although it holds something else, of which nothing is removed")
      ->needs(out);
  return out;
}

/// Adds `--json FILE`; `-` is standard output.
void addJsonOption(CLI::App& command, std::string& file);
/// Writes to the file of --json; nothing where it was not given.
void writeJson(const std::string& file, const nlohmann::ordered_json& value);

/// Adds `--platform auto|surfaceless|device` for the context without a window.
void addPlatformOption(CLI::App& command, std::string& platform);
[[nodiscard]] window::EglPlatform platformOf(const std::string& name);

/// A line that grows, on a terminal; when piped, a line now and then.
class ProgressBar {
 public:
  ProgressBar(std::string label, int total);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  void advance();
  /// Ends the bar's line, for what is printed next.
  void end();

 private:
  std::string label_;
  int total_;
  int done_ = 0;
  bool shown_;
  bool ended_ = false;
  ProgressLines lines_;
};

/// A bar for programs that are compiled; nothing while that is too short to be noticed.
[[nodiscard]] gl::ProgramCache::Progress compileProgress();

/// Draws frame after frame until the last, or until the user interrupts.
/// @returns false where the user did
bool playFrames(recording::FrameSource& frames, ProgressBar& progress,
                const std::function<void(const recording::Frame&)>& draw);

}  // namespace macula::tools
