// WalkSession: what the user asks for.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/core/error.h"
#include "engine/core/nearest.h"
#include "engine/core/plural.h"
#include "engine/scene/load.h"
#include "engine/ui/widgets.h"
#include "walk/command_text.h"
#include "walk/file_names.h"
#include "walk/session.h"

namespace macula::tools {
namespace {

/// The name after the present one, or the one that is asked for.
std::size_t chosen(const std::vector<std::string>& names, std::size_t present,
                   const std::string& wanted) {
  if (wanted.empty()) return (present + 1) % names.size();
  const auto found = std::find(names.begin(), names.end(), wanted);
  if (found == names.end()) {
    failInput("'{}' is not one of the choices; the nearest is '{}'", wanted,
              nearestName(wanted, names));
  }
  return static_cast<std::size_t>(found - names.begin());
}

/// Dear ImGui gives a field the keyboard two frames after it is asked to; one more, to be sure.
constexpr int kFocusFrames = 3;

/// What a name or a dropped file may be.
constexpr std::string_view kOpened = "open a scene (.glb, .gltf), a gaze log or a camera path";

}  // namespace

void WalkSession::say(std::string text, bool error) {
  lastMessage_ = text;
  message_ = Message{std::move(text), error, Clock::now()};
}

void WalkSession::grantRequests() {
  noteChange();  // by a widget of the frame before
  // What one request asks for in turn is granted with the next frame; and so is what comes behind a
  // change, because each change is drawn before the next: it may have to be taken back.
  Requests requests = std::exchange(requests_, {});
  for (std::size_t i = 0; i < requests.size(); ++i) {
    if (change_) {
      requests_.insert(requests_.begin(), requests.begin() + static_cast<std::ptrdiff_t>(i),
                       requests.end());
      return;
    }
    const Request& request = requests[i];
    // Before the first scene there is nothing to change.
    const bool always = request.action == Action::Close || request.action == Action::Quit;
    if (!scene_.gpu && !always) continue;
    try {
      grant(request);
    } catch (const InputError& error) {
      say(error.what(), true);
    }
    noteChange();
  }
}

void WalkSession::noteChange() {
  std::optional<ui::SettingChange> change = panels_.settings().takeChange();
  if (!change) return;
  events_.changed.push_back(change->entry);
  if (change->rival != nullptr) say(change->rivalNote());
  switch (change->entry->effect()) {
    case settings::Effect::Immediate:
      return;
    case settings::Effect::ReopensGaze:
      return gaze_.reopen();
    case settings::Effect::ReloadsScene:
      sceneChange_ = change;
      loadScene(loader_.busy() ? loader_.name() : scene_.name);
      break;
    case settings::Effect::DropsHistory:
      break;
  }
  change_ = std::move(change);
}

void WalkSession::grant(const Request& request) {
  const std::string& argument = request.argument;
  switch (request.action) {
    case Action::TogglePanels:
      return panels_.toggle();
    case Action::ToggleHelp:
      return panels_.toggleHelp();
    case Action::ShowTab:
      return panels_.showTab(argument);
    case Action::ToggleNumbers:
      return panels_.toggleNumbers();
    case Action::Search:
      focusFrames_ = kFocusFrames;
      return panels_.search(argument);
    case Action::Close:
      return close();
    case Action::Quit:
      return window_.requestClose();
    case Action::NextMethod:
      return panels_.settings().chooseNext("oit.method");
    case Action::NextHeatmap:
      return panels_.settings().chooseNext("view.heatmap");
    case Action::Set:
      return panels_.settings().assign(argument);
    case Action::SetSecond:
      return second_->panel().assign(argument);
    case Action::LoadScene:
      return askForScene(argument);
    case Action::Drop:
      return drop(argument);
    case Action::ResetCamera:
      return camera_.reset();
    case Action::RecordPath:
      return toggleRecording();
    case Action::PlayPath:
      return togglePath(argument);
    case Action::GazeSource:
      if (!argument.empty() && argument == gaze_.opening())
        return say("already opening " + argument);
      return gaze_.choose(argument);
    case Action::NextGaze:
      gaze_.chooseNext();
      return say("gaze: " + (gaze_.opening().empty() ? gaze_.spec() : gaze_.opening()));
    case Action::ToggleCursor:
      gaze_.cursorShown = !gaze_.cursorShown;
      return;
    case Action::View:
      return second_->setMode(static_cast<ViewMode>(
          chosen(viewModeNames(), static_cast<std::size_t>(second_->mode()), argument)));
    case Action::ScaleDifference:
      return second_->scaleDifference(argument == "up");
    case Action::Measure:
      return askForErrors(argument);
    case Action::ShowMap:
      return nextMap(argument);
    case Action::Png:
      if (picture_.busy() || !pendingPicture_.empty() || !pendingLinear_.empty()) {
        requests_.push_back(request);  // one picture at a time, and none is left out
        return;
      }
      pendingPicture_ = argument.empty() ? freshName("macula", "png") : argument;
      return;
    case Action::Exr:
      if (picture_.busy() || !pendingPicture_.empty() || !pendingLinear_.empty()) {
        requests_.push_back(request);
        return;
      }
      pendingLinear_ = argument.empty() ? freshName("macula", "exr") : argument;
      return;
    case Action::CopyCommand:
      window_.setClipboard(commandLine());
      return say("copied: " + commandLine());
    case Action::Refuse:
      failInput("{}", argument);
  }
}

void WalkSession::askForScene(const std::string& name) {
  if (loader_.busy() && loader_.name() == name) return say("already loading " + name);
  loadScene(name);
}

void WalkSession::drop(const std::string& path) {
  if (path.empty()) failInput("no file is named; {}", kOpened);
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    panels_.showTab("scene");
    panels_.listFolder(path);
    return say(fmt::format("{} is a folder with {}{}", path,
                           ui::numberOf(panels_.listed(), "scene file"),
                           panels_.listed() > 0 ? "; choose one on the scene tab" : ""));
  }
  if (scene::isProcedural(path)) return askForScene(path);
  if (!std::filesystem::exists(path, error)) {
    failInput("{}: no such file; {}", path, kOpened);
  }
  if (scene::isSceneFile(path)) {
    panels_.listFolder(std::filesystem::path(path).parent_path());
    return askForScene(path);
  }
  if (isCameraPathFile(path)) {
    camera_.play(path);
    return say("camera path: " + path);
  }
  if (path == gaze_.opening()) return say("already opening " + path);
  gaze_.choose(path);
  guessedLog_ = path;
}

void WalkSession::close() {
  if (ui_.wantsKeyboard()) return ui_.leaveField();
  if (!scene_.gpu) return window_.requestClose();
  if (loader_.busy()) {
    loader_.cancel();
    if (sceneChange_) sceneChange_->undo();
    sceneChange_.reset();
    return say("loading was cancelled");
  }
  if (message_ && message_->error) return message_.reset();
  if (panels_.close()) return;
  if (errors_.map() != ErrorCheck::Map::None) return errors_.show(ErrorCheck::Map::None);
  if (camera_.playing()) camera_.stopPlaying();
}

void WalkSession::togglePath(const std::string& path) {
  if (path.empty() && camera_.playing()) return camera_.stopPlaying();
  camera_.play(path);
}

void WalkSession::toggleRecording() {
  if (!camera_.recording()) {
    camera_.startRecording();
    return say("recording the camera; L ends it");
  }
  const std::filesystem::path file = nextFreeName("camera", "csv");
  camera_.finishRecording(file);
  say(fmt::format("{} written: {}; P plays the path", ui::numberOf(camera_.recordedKeys(), "key"),
                  file.string()));
}

void WalkSession::nextMap(const std::string& name) {
  if (!errors_.result()) failInput("nothing was measured yet; press X first");
  errors_.show(static_cast<ErrorCheck::Map>(
      chosen(mapNames(), static_cast<std::size_t>(errors_.map()), name)));
}

void WalkSession::askForErrors(const std::string& against) {
  if (errors_.busy()) return say("errors are being measured already");
  if (against == "second" && !second_->shown()) {
    failInput("there is no second method to measure against; press B");
  }
  pendingErrors_ = against;
  panels_.showTab("compare");
}

std::string WalkSession::commandLine() const {
  // --size counts screen coordinates, as the window does; pixels may be finer.
  const glm::ivec2 size(window_.placement(0).clientSize);
  return walkCommandLine(options_.registry, scene_.name, size, gaze_.spec());
}

std::string WalkSession::freshName(const std::string& prefix, std::string_view extension) {
  // A file that is still being written is not there yet.
  std::string name = nextFreeName(prefix, extension, givenNames_).string();
  givenNames_.insert(name);
  return name;
}

}  // namespace macula::tools
