#include "common.h"

#include <fmt/format.h>
#include <unistd.h>

#include <charconv>
#include <chrono>
#include <cstdio>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/core/interrupt.h"
#include "engine/image/image.h"
#include "engine/recording/reader.h"
#include "engine/scene/light_choice.h"
#include "engine/scene/load.h"
#include "engine/scene/material_override.h"

namespace macula::tools {

glm::ivec2 parseSize(const std::string& text) {
  constexpr int kMaxSide = 16384;
  glm::ivec2 size{0};
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, size.x);
  const bool cross = first.ec == std::errc{} && first.ptr != end && *first.ptr == 'x';
  const auto second = cross ? std::from_chars(first.ptr + 1, end, size.y) : first;
  if (!cross || second.ec != std::errc{} || second.ptr != end || size.x < 1 || size.y < 1 ||
      size.x > kMaxSide || size.y > kMaxSide) {
    failInput("--size: '{}' is no size; give WIDTHxHEIGHT with sides from 1 to {}, as 1024x768",
              text, kMaxSide);
  }
  return size;
}

glm::vec2 parsePlace(const std::string& option, const std::string& text) {
  glm::vec2 place{0.0F};
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, place.x);
  const bool comma = first.ec == std::errc{} && first.ptr != end && *first.ptr == ',';
  const auto second = comma ? std::from_chars(first.ptr + 1, end, place.y) : first;
  const auto inside = [](float v) { return v >= 0.0F && v <= 1.0F; };
  if (!comma || second.ec != std::errc{} || second.ptr != end || !inside(place.x) ||
      !inside(place.y)) {
    failInput("{}: '{}' is no place; give X,Y, both from 0 to 1, as 0.5,0.25", option, text);
  }
  return place;
}

void prepareForRendering(scene::Scene& scene, const passes::RenderSettings& settings) {
  scene::overrideOpacity(scene, settings.opacity);
  scene::overrideLighting(scene, settings.lighting);
  scene::addDefaultLights(scene);
  scene::orderTransparent(scene, settings.order, settings.seed);
}

LoadedScene loadForRendering(const std::string& nameOrPath,
                             const passes::RenderSettings& settings) {
  const auto begin = std::chrono::steady_clock::now();
  LoadedScene loaded;
  loaded.scene = scene::loadScene(nameOrPath, settings.seed);
  prepareForRendering(loaded.scene, settings);
  if (!settings.environment.empty()) {
    const image::ImageF image = image::readHdr(settings.environment);
    scene::Panorama panorama{image.width, image.height, {}};
    const auto channels = static_cast<std::size_t>(image.channels);
    for (std::size_t i = 0; i + 2 < image.pixels.size(); i += channels) {
      panorama.pixels.emplace_back(image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]);
    }
    loaded.environment = scene::makeEnvironment(std::move(panorama));
    for (const std::string& warning : loaded.environment->warnings) {
      loaded.scene.warnings.push_back(
          fmt::format("{}: {}", settings.environment.string(), warning));
    }
  }
  loaded.loadMs =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  return loaded;
}

scene::Camera startCamera(const scene::Scene& scene) {
  return scene.cameras.empty() ? scene::autoOrbit(scene).at(0.0) : scene.cameras.front();
}

void printWarnings(const scene::Scene& scene, const scene::Camera& camera, float aspect) {
  for (const std::string& warning : scene.warnings) {
    fmt::print(stderr, "warning: {}\n", oneLine(warning));
  }
  const std::string lights =
      scene::lightsLeftOut(scene, camera, aspect, "the first frame's camera");
  if (!lights.empty()) fmt::print(stderr, "warning: {}\n", oneLine(lights));
}

scene::CameraPath readCamera(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) {
    failInput("--camera {}: no such file; give auto, scene, a path file or a recording", file);
  }
  if (!recording::isRecording(file)) return scene::readCameraPath(file);
  const recording::Recording recording = recording::readRecording(file);
  if (recording.frames.empty()) {
    failInput("--camera: {}: no frame was recorded; record again", file);
  }
  return recording::cameraPathOf(recording);
}

scene::CameraPath parseCameraSpec(const std::string& spec, const scene::Scene& scene) {
  if (spec == "auto") return scene::autoOrbit(scene);
  if (spec != "scene") {
    scene::CameraPath path = readCamera(spec);
    path.fitPlanes(scene::boundsOf(scene));
    return path;
  }
  if (scene.cameras.empty()) {
    failInput("--camera: {} holds no camera; use auto or a path file", scene.name);
  }
  return scene::fixedCamera(scene.cameras.front());
}

void addJsonOption(CLI::App& command, std::string& file) {
  command.add_option("--json", file, "Write the numbers as JSON; - is standard output")
      ->type_name("FILE");
}

void writeJson(const std::string& file, const nlohmann::ordered_json& value) {
  if (file.empty()) return;
  const std::string text = value.dump(2) + "\n";
  if (file == "-") {
    std::fwrite(text.data(), 1, text.size(), stdout);
  } else {
    writeFileAtomically(file, text);
  }
}

void addPlatformOption(CLI::App& command, std::string& platform) {
  command.add_option("--platform", platform, "How EGL finds the device (default auto)")
      ->check(CLI::IsMember({"auto", "surfaceless", "device"}))
      ->type_name("auto|surfaceless|device");
}

window::EglPlatform platformOf(const std::string& name) {
  if (name == "surfaceless") return window::EglPlatform::Surfaceless;
  return name == "device" ? window::EglPlatform::Device : window::EglPlatform::Auto;
}

namespace {

double steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

ProgressBar::ProgressBar(std::string label, int total)
    : label_(std::move(label)),
      total_(total),
      shown_(::isatty(STDERR_FILENO) == 1),
      lines_(label_, total, steadySeconds) {}

ProgressBar::~ProgressBar() {
  end();
}

void ProgressBar::end() {
  if (shown_ && !ended_) std::fputc('\n', stderr);
  ended_ = true;
}

void ProgressBar::advance() {
  ++done_;
  if (!shown_) {
    const std::string line = lines_.advance();
    if (!line.empty()) std::fprintf(stderr, "%s\n", line.c_str());
    return;
  }
  constexpr int kWidth = 32;
  const int filled = total_ > 0 ? done_ * kWidth / total_ : kWidth;
  std::fprintf(stderr, "\r%s [%s%s] %d/%d", label_.c_str(),
               std::string(static_cast<std::size_t>(filled), '#').c_str(),
               std::string(static_cast<std::size_t>(kWidth - filled), '.').c_str(), done_, total_);
  std::fflush(stderr);
}

gl::ProgramCache::Progress compileProgress() {
  struct State {
    double begin = 0.0;
    std::size_t shown = 0;
    std::optional<ProgressBar> bar;
  };
  return [state = std::make_shared<State>()](std::size_t done, std::size_t total) {
    constexpr double kNoticedSeconds = 0.5;
    if (done == 1) state->begin = steadySeconds();
    const bool last = done == total;
    if (!state->bar && !last && steadySeconds() - state->begin > kNoticedSeconds) {
      state->bar.emplace("compiling", static_cast<int>(total));
      state->shown = 0;
    }
    if (!state->bar) return;
    for (; state->shown < done; ++state->shown) state->bar->advance();
    if (last) state->bar.reset();
  };
}

bool playFrames(recording::FrameSource& frames, ProgressBar& progress,
                const std::function<void(const recording::Frame&)>& draw) {
  while (const recording::Frame* frame = frames.next()) {
    draw(*frame);
    progress.advance();
    if (interruptAsked()) return false;
  }
  return true;
}

}  // namespace macula::tools
