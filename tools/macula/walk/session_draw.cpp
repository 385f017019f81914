// WalkSession: rendering, what is undone where the device refuses, overlays and stills.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <string_view>
#include <utility>

#include "engine/core/error.h"
#include "engine/image/image.h"
#include "engine/ui/widgets.h"
#include "walk/gaze_cursor.h"
#include "walk/session.h"
#include "walk/still.h"

namespace macula::tools {
namespace {

constexpr std::string_view kNeedsNothing = "blend";

}  // namespace

void WalkSession::draw() {
  const bool changed = change_ || events_.resized || events_.sceneChanged;
  const int axis = options_.settings.tonemap.ssaa;  // may be what has changed
  control_->resized(axis * events_.pictureSize);
  if (events_.sceneChanged) control_->restart();
  control_->steer(*renderer_);
  if (firstImage_) {
    device_->programs.onProgress([this](std::size_t done, std::size_t total) {
      firstImage_->showProgress(done, total, size_);
    });
    if (firstImage_->show(options_.settings, *device_, *scene_.gpu, events_)) {
      firstImageMs_ = std::chrono::duration<double, std::milli>(Clock::now() - begin_).count();
    }
  }
  const double before = threadMs();
  for (;;) {
    try {
      drawFirst();
      break;
    } catch (const InputError& error) {
      if (!takeBack(error)) throw;
    }
  }
  device_->programs.onProgress({});
  firstImage_.reset();
  change_.reset();
  sceneBefore_ = {};
  cameraBefore_.reset();
  control_->drawn(*renderer_);
  if (resultNew_) panels_.add(*renderer_, result_, *control_);
  if (second_->shown()) drawSecond(changed);
  drawMs_ = threadMs() - before;
}

passes::Wanted WalkSession::wanted() const {
  const bool shown = panels_.numbersShown();
  return {.times = shown || second_->shown() || control_->settings().law != "off" ||
                   !options_.json.empty(),
          .statistics = shown || recorder_.has_value()};
}

void WalkSession::drawFirst() {
  // resize() also checks what the settings make of the size.
  const bool begins = change_ || events_.resized || events_.sceneChanged;
  if (change_ || events_.resized) renderer_->resize(events_.pictureSize);
  if (events_.sceneChanged) renderer_->setScene(*scene_.gpu);
  renderer_->want(wanted());
  resultNew_ = false;
  // The first frame by other settings compiles and allocates anyway, and is waited for, so that its
  // pool suffices. So is each that is recorded: a replay, which waits, has to repeat it.
  if (begins || recorder_) {
    adoptResult(renderer_->render(events_.camera, events_.gaze, events_.cut));
    return;
  }
  renderer_->draw(events_.camera, events_.gaze, events_.cut);
  if (const auto result = renderer_->takeResult()) adoptResult(*result);
}

void WalkSession::adoptResult(const passes::FrameResult& result) {
  if (result.overflows > result_.overflows) {
    say("the pool of fragments was too small and grows; some were missing for a moment");
  }
  result_ = result;
  resultNew_ = true;
}

bool WalkSession::takeBack(const InputError& error) {
  if (change_) {
    panels_.settings().setRefusal(error.what());
    say(error.what(), true);
    // A request for the next method means the next one that can be drawn.
    if (change_->cycled && change_->advance()) return true;
    change_->undo();
    std::erase(events_.changed, change_->entry);
    change_.reset();
    events_.resized = true;
    return true;
  }
  if (sceneBefore_.gpu) {
    say(error.what(), true);
    scene_ = std::move(sceneBefore_);
    sceneBefore_ = {};
    if (cameraBefore_) camera_ = std::move(*cameraBefore_);
    cameraBefore_.reset();
    events_.camera = camera_.camera();
    events_.scene = scene_.name;
    window_.setTitle(fmt::format("Macula: {}", oneLine(scene_.name)));
    return true;
  }
  settings::Entry& method = *options_.registry.find("oit.method");
  if (events_.resized && options_.settings.oit.method != kNeedsNothing) {
    // A larger window must not end the walk: what needs no memory can always be drawn.
    say(fmt::format("{}; drawn by {} now", error.what(), kNeedsNothing), true);
    method.setText(kNeedsNothing, "--method");
    return true;
  }
  return false;
}

void WalkSession::drawSecond(bool firstChanged) {
  try {
    second_->render(events_, *scene_.gpu, firstChanged,
                    {.times = true, .statistics = panels_.numbersShown()});
  } catch (const InputError& error) {
    say(error.what(), true);
    second_->setMode(ViewMode::One);
  }
}

void WalkSession::compose() {
  if (const gl::Texture* map = errors_.texture()) {
    screen_.clear(glm::vec3(0.0F));
    screen_.show(*map);
  } else {
    second_->compose(screen_, *renderer_, size_);
    legends_.show(screen_, *renderer_, *second_, size_);
  }
}

void WalkSession::drawOverlays() {
  // The UI counts in screen coordinates, which the content scale may tell from pixels.
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const glm::vec2 window(display.x, display.y);
  const glm::vec2 picture = window * glm::vec2(pictureSize_) / glm::vec2(size_);
  const bool mapShown = errors_.map() != ErrorCheck::Map::None;
  if (gaze_.cursorShown && !mapShown) {
    drawGazeCursor(events_.gaze, glm::vec2(0.0F), picture);
    if (second_->mode() == ViewMode::SideBySide) {
      drawGazeCursor(events_.gaze, {window.x - picture.x, 0.0F}, picture);
    }
  }
  // Above what stands along the lower edge, where no panel reaches; a message stands higher.
  constexpr float kNamesEms = 5.0F;
  constexpr float kNameEms = 2.0F;
  const float em = ImGui::GetFontSize();
  const float top = window.y - std::max(kNamesEms * em, panels_.footHeight() + kNameEms * em);
  if (mapShown) {
    ui::pictureLabel(fmt::format("{} map of {}; not the live picture",
                                 errors_.map() == ErrorCheck::Map::Flip ? "FLIP" : "difference",
                                 errors_.title(scene_.name)),
                     {0.5F * window.x, top}, 0.5F);
  } else {
    second_->drawOverlay(panels_.time(), !ui_.wantsPointer(), top);
  }
  recordings_.clear();
  if (recorder_) {
    recordings_.push_back(
        fmt::format("recording into {}: {}", options_.record, recorder_->facts()));
  }
  if (camera_.recording()) {
    recordings_.push_back(fmt::format("recording the camera's path: {:.1f} s, {}; L ends it",
                                      camera_.recordedSeconds(),
                                      ui::numberOf(camera_.recordedKeys(), "key")));
  }
  const bool labelled = mapShown || second_->shown();
  const PanelInput input{events_,     *renderer_,
                         result_,     options_.settings,
                         scene_,      camera_,
                         gaze_,       *second_,
                         errors_,     *control_,
                         rate_,       panels_.time(),
                         recordings_, labelled ? top : window.y};
  panels_.draw(input, requests_);
  if (loader_.busy()) panels_.drawLoading(loader_, true, requests_);
  if (panels_.drawMessage(message_ ? &*message_ : nullptr, top - em)) message_.reset();
}

void WalkSession::takeStills() {
  try {
    if (!pendingPicture_.empty()) {
      const std::string file = std::exchange(pendingPicture_, {});
      startPicture(file, [file, shot = readScreen(size_)] { image::writePng(file, shot); });
    }
    if (!pendingLinear_.empty()) writeLinearPicture(std::exchange(pendingLinear_, {}));
    if (!pendingErrors_.empty()) measureErrors(std::exchange(pendingErrors_, {}));
  } catch (const InputError& error) {
    say(error.what(), true);
  }
}

void WalkSession::writeLinearPicture(const std::string& file) {
  if (!image::hasExr()) failInput("{}: this build writes no EXR; use PNG (F12)", file);
  image::ImageF picture = drawLinearStill(options_.settings, *device_, *scene_.gpu, events_,
                                          renderer_->inputs().controls);
  startPicture(file, [file, picture = std::move(picture)] { image::writeExr(file, picture); });
}

void WalkSession::measureErrors(const std::string& against) {
  const passes::RenderSettings& a = options_.settings;
  const passes::RenderSettings reference =
      against == "second" ? second_->settings() : passes::referenceOf(a);
  PicturePair pair;
  pair.testName = a.oit.method;
  pair.referenceName = reference.oit.method;
  pair.scene = events_.scene;
  pair.frame = events_.index;
  // What is seen is what is measured, but for a heat map over it.
  pair.test = {pictureSize_.x, pictureSize_.y, 3, {}};
  renderer_->readDisplay(pair.test.pixels);
  pair.reference = drawStill(reference, *device_, *scene_.gpu, events_, {});
  errors_.start(std::move(pair));
}

}  // namespace macula::tools
