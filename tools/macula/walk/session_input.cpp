// WalkSession: keys, text and the pointer, event by event.
#define GLFW_INCLUDE_NONE  // OpenGL is declared by the loader
#include <GLFW/glfw3.h>

#include <cmath>

#include "walk/actions.h"
#include "walk/session.h"

namespace macula::tools {
namespace {

constexpr float kWheelStep = 1.2F;  ///< factor of the speed for a notch of the wheel

}  // namespace

void WalkSession::takeInput() {
  // A frame of the UI for each event, without a picture, until all are taken: what one of them
  // does, as a click into a field, decides what the next means.
  for (;;) {
    settleFocus();
    const std::optional<window::InputEvent> event = window_.input().take();
    ui_.beginFrame(event ? &*event : nullptr);
    if (event) readEvent(*event);
    grantRequests();
    if (window_.input().empty() || pictureComesFirst()) return;
    drawOverlays();
    ui_.skipFrame();
  }
}

void WalkSession::settleFocus() {
  if (!scene_.gpu || events_.index == 0) return;
  for (; focusFrames_ > 0; --focusFrames_) {
    ui_.beginFrame();
    if (ui_.wantsKeyboard()) focusFrames_ = 1;  // the last one
    drawOverlays();
    ui_.skipFrame();
  }
}

bool WalkSession::pictureComesFirst() const {
  // Panels need a first picture; what was asked for is drawn, or written, before the next change.
  return !scene_.gpu || events_.index == 0 || change_ || !requests_.empty() ||
         !pendingPicture_.empty() || !pendingLinear_.empty() || !pendingErrors_.empty();
}

void WalkSession::readEvent(const window::InputEvent& event) {
  using Kind = window::InputEvent::Kind;
  switch (event.kind) {
    case Kind::Key:
      if (event.down) {
        readPress(event.code, event.modifiers);
      } else {
        keys_.release(event.code);
      }
      break;
    case Kind::Button:
      if (event.code == GLFW_MOUSE_BUTTON_RIGHT) lookAround(event.down);
      break;
    case Kind::Pointer:
      if (looking_ && pointer_) looked_ += event.place - *pointer_;
      pointer_ = event.place;
      break;
    case Kind::Wheel:
      if (!ui_.wantsPointer()) {
        camera_.scaleSpeed(std::pow(kWheelStep, static_cast<float>(event.place.y)));
      }
      break;
    case Kind::Text:
    case Kind::Enter:
    case Kind::Focus:
      break;
  }
}

void WalkSession::readPress(int key, int modifiers) {
  // While a field is edited, keys are text.
  if (ui_.wantsKeyboard()) {
    keys_.letGo();
    if (key != GLFW_KEY_ESCAPE) return;
  }
  if ((modifiers & GLFW_MOD_CONTROL) != 0) {
    if (key == GLFW_KEY_Q) requests_.push_back({Action::Quit});
    return;
  }
  keys_.press(key);
  for (const ActionRow& row : actionRows()) {
    if (row.key != key) continue;
    requests_.push_back({row.action, std::string(row.argument)});
    ui_.dropText();  // it may open a field, for which the key's letter is not meant
  }
}

void WalkSession::lookAround(bool wanted) {
  // A press on a panel belongs to the panel.
  wanted = wanted && (looking_ || !ui_.wantsPointer());
  if (wanted == looking_) return;
  looking_ = wanted;
  // Hidden and free of the window's edges while it turns the camera; back in its place afterwards.
  glfwSetInputMode(window_.handle(), GLFW_CURSOR,
                   wanted ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
}

}  // namespace macula::tools
