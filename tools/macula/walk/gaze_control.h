// Which source the gaze comes from, how it fares, and what was seen of it lately.
#pragma once

#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/gaze/delay.h"
#include "engine/gaze/gaze_settings.h"
#include "engine/gaze/quality.h"
#include "engine/gaze/source.h"
#include "walk/background_job.h"
#include "walk/gaze_sources.h"

namespace macula::tools {

class GazeControl {
 public:
  /// @param settings must outlive the control
  GazeControl(GazeSources sources, const gaze::GazeSettings& settings)
      : sources_(std::move(sources)), settings_(settings) {}

  /// Opens a source in the background; the one before stays until it is there.
  /// @param spec `mouse`, or what GazeSources::open() takes
  void choose(const std::string& spec);
  /// Chooses the source after the present one in choices().
  void chooseNext();
  /// What is being opened; empty: nothing.
  [[nodiscard]] const std::string& opening() const { return opening_; }
  /// To be called once a frame. @throws InputError where a source could not be opened
  void poll();

  /// Opens the present source again, as after a change of its settings.
  void reopen();

  /// Where the pointer is, 0..1 of the window; counts while the mouse is the source.
  void movePointer(const glm::dvec2& place, double seconds) {
    if (isMouse()) mouse_.move(place, seconds);
  }
  /// Where window and display are, for trackers.
  void place(const gaze::WindowPlacement& placement);
  /// Called for each sample of any source, with its time in seconds of the walk.
  void onSample(gaze::GazeSource::SampleListener listener);
  /// The point of interest of this frame, `seconds` after the walk began.
  [[nodiscard]] gaze::PointOfInterest at(double seconds);

  /// Mouse, centre, devices and the logs that were opened.
  [[nodiscard]] const std::vector<GazeChoice>& choices() const { return choices_; }
  [[nodiscard]] const std::string& spec() const { return spec_; }
  [[nodiscard]] gaze::SourceStatus status() const;
  [[nodiscard]] bool isMouse() const { return source_ == nullptr; }

  /// Of a recording: its quality and how far it has played.
  struct Recording {
    gaze::GazeQuality quality;
    std::string format;
    std::vector<std::string> warnings;  ///< see gaze::Viewing
  };
  [[nodiscard]] const std::optional<Recording>& recording() const { return recording_; }
  /// Of a recording that has just been opened; empty from the second call on.
  [[nodiscard]] std::vector<std::string> takeWarnings() { return std::exchange(untold_, {}); }
  [[nodiscard]] double sourceSeconds() const { return sourceSeconds_; }

  /// The states of the last frames, a ring for a strip.
  static constexpr std::size_t kStrip = 240;
  [[nodiscard]] gaze::GazeState stateAgo(std::size_t frames) const {
    return strip_[(next_ + kStrip - 1 - frames) % kStrip];
  }

  bool cursorShown = true;

 private:
  using Clock = std::chrono::steady_clock;
  struct Opened {
    std::string spec;
    std::unique_ptr<gaze::GazeSource> source;
    std::optional<Recording> recording;
  };
  void listChoices();
  void listen();

  GazeSources sources_;
  const gaze::GazeSettings& settings_;
  gaze::GazeDelay delay_;
  gaze::GazeSource::SampleListener listener_;
  gaze::MouseGaze mouse_;
  std::unique_ptr<gaze::GazeSource> source_;  ///< null: the mouse
  std::string spec_ = "mouse";
  std::string opening_;
  std::optional<std::string> queued_;
  std::optional<Recording> recording_;
  std::vector<std::string> untold_;
  std::optional<double> begin_;  ///< of the source, in seconds of the walk
  double sourceSeconds_ = 0.0;
  std::vector<std::string> logs_;
  std::vector<GazeChoice> choices_;
  Clock::time_point listed_{};
  std::array<gaze::GazeState, kStrip> strip_ = filledStrip();
  std::size_t next_ = 0;
  BackgroundJob<Opened> job_;
  std::vector<GazeChoice> devices_;
  BackgroundJob<std::vector<GazeChoice>> deviceJob_;

  static std::array<gaze::GazeState, kStrip> filledStrip() {
    std::array<gaze::GazeState, kStrip> strip{};
    strip.fill(gaze::GazeState::None);
    return strip;
  }
};

}  // namespace macula::tools
