#include "engine/gaze/hid/session.h"

#include <utility>

namespace macula::gaze::hid {
namespace {

std::string_view textOf(ConfigurationStatus status) {
  switch (status) {
    case ConfigurationStatus::Configuring:
      return "the tracker is configuring itself";
    case ConfigurationStatus::ScreenSetupNeeded:
      return "the tracker needs its screen set-up; run the vendor's tool";
    case ConfigurationStatus::CalibrationNeeded:
      return "the tracker needs a calibration; run the vendor's tool";
    case ConfigurationStatus::Unknown:
    case ConfigurationStatus::Ready:
      break;
  }
  return "";
}

}  // namespace

Session::Session(TrackerLayout layout, const TrackerChoice& choice) : decoder_(std::move(layout)) {
  expectedScreenMm_ = choice.screenMm;
  if (!expectedScreenMm_ && choice.profile) expectedScreenMm_ = choice.profile->screenMm;
  learn(std::nullopt, "");
}

void Session::learn(const std::optional<glm::dvec2>& screenMm, const std::string& problem) {
  problem_ = problem;
  screenNote_.clear();
  const TrackerLayout& layout = decoder_.layout();
  if (layout.gaze.shares) return;
  screenMm_ = screenMm ? screenMm : expectedScreenMm_;
  if (!screenMm_ && layout.statedScreenMm) {
    screenMm_ = layout.statedScreenMm;
    screenNote_ = "the display's size is taken from the range of its reports";
  }
  if (screenMm_) {
    decoder_.setScreen(*screenMm_);
  } else {
    screenNote_ = "the size of its calibrated display is not known, so gaze has no place";
  }
}

Session::Taken Session::take(std::span<const std::uint8_t> bytes, double hostSeconds) {
  const ConfigurationStatus statusBefore = decoder_.condition().status;
  HidGazeReport gaze;
  Taken taken{.kind = decoder_.decode(bytes, gaze), .sample = {}, .news = false};
  taken.news = taken.kind == ReportClass::Status;
  if (decoder_.condition().status == ConfigurationStatus::Ready &&
      statusBefore > ConfigurationStatus::Ready) {
    calibrated_ = true;
  }
  if (taken.kind != ReportClass::Gaze) return taken;
  taken.sample = {.hostSeconds = hostSeconds,
                  .deviceSeconds = gaze.deviceSeconds,
                  .position = gaze.position,
                  .valid = gaze.valid};
  taken.news = !hasStreamed_;
  hasStreamed_ = true;
  return taken;
}

std::string Session::note(std::string_view first) const {
  std::string note;
  const auto add = [&note](std::string_view text) {
    if (!text.empty()) note.append(note.empty() ? "" : "; ").append(text);
  };
  add(first);
  add(textOf(decoder_.condition().status));
  add(problem_);
  add(screenNote_);
  return note;
}

}  // namespace macula::gaze::hid
