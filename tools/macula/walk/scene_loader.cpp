#include "walk/scene_loader.h"

#include <fmt/format.h>

#include <utility>

#include "engine/scene/light_choice.h"
#include "engine/ui/widgets.h"

namespace macula::tools {

ShownScene upload(const ReadyScene& ready) {
  const LoadedScene& loaded = ready.loaded;
  ShownScene shown;
  shown.name = ready.name;
  shown.warnings = loaded.scene.warnings;
  shown.gpu = std::make_unique<scene::GpuScene>(
      loaded.scene, loaded.environment ? &*loaded.environment : nullptr);
  std::size_t triangles = 0;
  for (const scene::Instance& instance : loaded.scene.instances) {
    triangles += loaded.scene.primitives[instance.primitive].indices.size() / 3;
  }
  shown.facts = fmt::format("{}, {}, {}", ui::numberOf(triangles, "triangle"),
                            ui::numberOf(loaded.scene.instances.size(), "draw"),
                            ui::bytesText(shown.gpu->bytes()));
  return shown;
}

void SceneLoader::request(std::string name, const passes::RenderSettings& settings,
                          bool keepsPlace) {
  wanted_ = Wanted{std::move(name), settings, keepsPlace, std::chrono::steady_clock::now()};
  arrived_.reset();
  stale_ = job_.busy();
  if (!stale_) start();
}

void SceneLoader::start() {
  stage_ = Stage::Reading;
  job_.start([this, wanted = *wanted_] {
    ReadyScene ready;
    ready.name = wanted.name;
    ready.keepsPlace = wanted.keepsPlace;
    ready.loaded = loadForRendering(wanted.name, wanted.settings);
    stage_ = Stage::Framing;
    ready.orbit = scene::autoOrbit(ready.loaded.scene);
    scene::Scene& scene = ready.loaded.scene;
    ready.start = scene.cameras.empty() ? ready.orbit.at(0.0) : scene.cameras.front();
    const std::string lights =
        scene::lightsLeftOut(scene, ready.start, 1.0F, "where the walk begins");
    if (!lights.empty()) scene.warnings.push_back(lights);
    return ready;
  });
}

void SceneLoader::cancel() {
  wanted_.reset();
  arrived_.reset();
  stale_ = job_.busy();
}

std::string SceneLoader::stage() const {
  if (stale_) return "waiting for the scene before";
  switch (stage_) {
    case Stage::Reading:
      return "reading and decoding";
    case Stage::Framing:
      return "framing the camera";
    case Stage::Uploading:
      break;
  }
  return "uploading to the GPU";
}

double SceneLoader::seconds() const {
  if (!wanted_) return 0.0;
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - wanted_->begin).count();
}

std::optional<ReadyScene> SceneLoader::poll() {
  if (arrived_) {
    wanted_.reset();
    return std::exchange(arrived_, {});
  }
  if (!job_.ready()) return {};
  if (stale_) {
    stale_ = false;
    try {
      (void)job_.take();
    } catch (const std::exception&) {
      // It is no longer wanted.
    }
    if (wanted_) start();
    return {};
  }
  try {
    arrived_ = job_.take();
  } catch (...) {
    wanted_.reset();
    throw;
  }
  stage_ = Stage::Uploading;
  return {};
}

}  // namespace macula::tools
