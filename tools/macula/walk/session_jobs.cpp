// WalkSession: work on other threads, and what becomes of its results.
#include <fmt/format.h>

#include "engine/core/error.h"
#include "walk/session.h"

namespace macula::tools {

void WalkSession::loadScene(const std::string& name) {
  loader_.request(name, options_.settings, name == scene_.name);
}

void WalkSession::pollJobs() {
  try {
    gaze_.poll();
    if (gaze_.opening().empty()) firstGaze_ = false;
    for (const std::string& warning : gaze_.takeWarnings()) {
      const std::string text = fmt::format("{}: {}", oneLine(gaze_.spec()), warning);
      fmt::print(stderr, "warning: {}\n", text);
      say(text);
    }
    if (gaze_.spec() == guessedLog_) guessedLog_.clear();
  } catch (const InputError& error) {
    if (firstGaze_) throw;
    const std::string reason = error.what();
    const bool guessed = !guessedLog_.empty() && reason.starts_with(guessedLog_);
    guessedLog_.clear();
    say(guessed ? reason + " (it is no scene and no camera path, so it was read as a gaze log)"
                : reason,
        true);
  }
  if (errors_.poll()) {
    say(fmt::format("measured: {}; the errors are on the compare tab", errors_.title(scene_.name)));
  }
  if (picture_.ready()) {
    try {
      say(picture_.take());
    } catch (const InputError& error) {
      say(error.what(), true);
    }
  }
  if (!device_) return;  // a scene waits until it can be drawn
  try {
    if (const std::optional<ReadyScene> ready = loader_.poll()) adopt(*ready);
  } catch (const InputError& error) {
    if (!scene_.gpu) throw;
    say(error.what(), true);
    if (sceneChange_) sceneChange_->undo();
    sceneChange_.reset();
  }
}

void WalkSession::adopt(const ReadyScene& ready) {
  for (const std::string& warning : ready.loaded.scene.warnings) {
    fmt::print(stderr, "warning: {}\n", oneLine(warning));
  }
  const bool first = scene_.gpu == nullptr;
  if (first && options_.camera == "scene" && ready.loaded.scene.cameras.empty()) {
    failInput("--camera: {} holds no camera; use auto or a path file", ready.name);
  }
  ShownScene shown = upload(ready);
  sceneBefore_ = std::move(scene_);
  cameraBefore_ = camera_;
  scene_ = std::move(shown);
  second_->forgetScene();
  camera_.setScene(ready.start, ready.orbit, scene_.gpu->bounds(), ready.keepsPlace);
  events_.sceneChanged = true;
  sceneChange_.reset();
  errors_.show(ErrorCheck::Map::None);
  window_.setTitle(fmt::format("Macula: {}", oneLine(scene_.name)));
  if (const auto& warnings = scene_.warnings; !warnings.empty()) {
    const auto more = warnings.size() - 1;
    say(more == 0 ? warnings.front()
                  : fmt::format("{} ({} more on the scene tab)", warnings.front(), more));
  }
  if (!first) return;
  if (!options_.camera.empty() && options_.camera != "scene") camera_.play(options_.camera);
  // The time of loading is no time of the walk.
  begin_ = last_ = Clock::now();
}

void WalkSession::startPicture(std::string file, std::function<void()> write) {
  if (picture_.busy()) say(picture_.take());
  picture_.start([file = std::move(file), write = std::move(write)] {
    write();
    return "written: " + file;
  });
}

}  // namespace macula::tools
