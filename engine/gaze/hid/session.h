// One open tracker without its thread: from reports and answers to samples and notes. No I/O.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "engine/gaze/hid/choice.h"
#include "engine/gaze/hid/eye_tracker.h"
#include "engine/gaze/hid/report.h"

namespace macula::gaze::hid {

class Session {
 public:
  /// @param choice says the display's size where the device does not
  Session(TrackerLayout layout, const TrackerChoice& choice);

  struct Taken {
    ReportClass kind = ReportClass::Garbage;
    HidSample sample;   ///< where kind is Gaze
    bool news = false;  ///< note() or samplingHz() may have changed
  };

  /// Takes one report that was read at `hostSeconds`.
  [[nodiscard]] Taken take(std::span<const std::uint8_t> bytes, double hostSeconds);

  /// The device's own word on its calibrated display, and what it did not answer.
  void learn(const std::optional<glm::dvec2>& screenMm, const std::string& problem);

  /// True once after each time that the status went from not ready to ready: the display's size may
  /// be another one now.
  [[nodiscard]] bool takeCalibrated() { return std::exchange(calibrated_, false); }

  /// What positions are divided by: the device's own word, else the choice's, else the profile's,
  /// else the extent of the stated range; absent where none is known, and where the device gives
  /// shares.
  [[nodiscard]] const std::optional<glm::dvec2>& screenMm() const { return screenMm_; }
  [[nodiscard]] double samplingHz() const { return decoder_.condition().samplingHz; }
  /// One line for a person: `first`, then all that is not as it should be. May be empty.
  [[nodiscard]] std::string note(std::string_view first) const;
  [[nodiscard]] const TrackerLayout& layout() const { return decoder_.layout(); }

 private:
  ReportDecoder decoder_;
  std::optional<glm::dvec2> expectedScreenMm_;  ///< where the device does not tell
  std::optional<glm::dvec2> screenMm_;
  std::string screenNote_;
  std::string problem_;
  bool hasStreamed_ = false;
  bool calibrated_ = false;
};

}  // namespace macula::gaze::hid
