// Sources of gaze: each gives a point of interest for a frame time.
#pragma once

#include <cstddef>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>

#include "engine/gaze/display_mapping.h"
#include "engine/gaze/gaze_settings.h"
#include "engine/gaze/log.h"
#include "engine/gaze/point_of_interest.h"
#include "engine/gaze/tracker.h"
#include "engine/gaze/viewing.h"

namespace macula::gaze {

/// Numbers of the clock fit, for people.
struct ClockReport {
  double offsetSeconds = 0.0;
  double driftPpm = 0.0;
  double residualSeconds = 0.0;
  std::size_t restarts = 0;
};

/// How a source fares, for a person who watches it.
struct SourceStatus {
  bool live = false;       ///< a device or pointer, not a recording or a fixed point
  bool connected = true;   ///< false while a device is away
  double rateHz = 0.0;     ///< samples that came in the last second; 0 where nothing is counted
  double lostShare = 0.0;  ///< 0..1 of those
  std::optional<ClockReport> clock;  ///< of a device that brings times of its own
  std::string message;  ///< one line: why nothing comes, or what was done; may be empty
};

/// Where the point of interest comes from. Asked once a frame, with times that do not decrease.
class GazeSource {
 public:
  GazeSource() = default;
  GazeSource(const GazeSource&) = delete;
  GazeSource& operator=(const GazeSource&) = delete;
  virtual ~GazeSource() = default;

  /// The point of interest of the frame at `timeSeconds` (frame i of a replay is at i / fps).
  [[nodiscard]] virtual PointOfInterest at(double timeSeconds) = 0;

  /// Short name for reports and the UI: "center", "0.3,0.7", "mouse" or the log's path.
  [[nodiscard]] virtual std::string name() const = 0;

  [[nodiscard]] virtual SourceStatus status() const { return {}; }

  /// Where display and window are now. Only trackers need it: other sources speak of the window.
  virtual void place(const WindowPlacement& /*placement*/) {}

  /// Called from at() for each sample that came, with its time on the clock of at() and its place
  /// in the window, before any rule or filter. Fixed points have no samples.
  using SampleListener = std::function<void(const GazeSample&)>;
  // Trackers keep it. NOLINTNEXTLINE(performance-unnecessary-value-param)
  virtual void onSample(SampleListener /*listener*/) {}
};

/// A fixed point. It is known exactly, so no rule ever takes it for lost.
class FixedGaze final : public GazeSource {
 public:
  /// @param position 0..1 of the window
  FixedGaze(const glm::dvec2& position, std::string name);
  [[nodiscard]] PointOfInterest at(double timeSeconds) override;
  [[nodiscard]] std::string name() const override { return name_; }

 private:
  glm::dvec2 position_;
  std::string name_;
};

/// The mouse pointer in place of an eye. It may rest as long as it likes and is never lost; outside
/// the window it counts as at the edge.
class MouseGaze final : public GazeSource {
 public:
  /// @param position 0..1 of the window from the top left; values outside and NaN are allowed
  /// @param timeSeconds of the frame; the listener hears it as the sample's time
  void move(const glm::dvec2& position, double timeSeconds = 0.0);
  /// State "none" and the centre until the first move().
  [[nodiscard]] PointOfInterest at(double timeSeconds) override;
  [[nodiscard]] std::string name() const override { return "mouse"; }
  void onSample(SampleListener listener) override { listener_ = std::move(listener); }

 private:
  PointOfInterest point_;
  SampleListener listener_;
};

/// Replays a log under the loss rule: the same log and frame times give the same points. The log's
/// first sample is at time 0. Every sample between two frames is seen, so that a blink between them
/// counts; after the last one the point is held, then eases to the centre, and has ended there.
class ReplayGaze final : public GazeSource {
 public:
  /// @param settings with a latency of L, a frame at t knows the samples up to t - L
  explicit ReplayGaze(GazeLog log, const GazeSettings& settings = {});
  [[nodiscard]] PointOfInterest at(double timeSeconds) override;
  [[nodiscard]] std::string name() const override { return log_.name; }
  void onSample(SampleListener listener) override { listener_ = std::move(listener); }
  [[nodiscard]] const GazeLog& log() const { return log_; }
  [[nodiscard]] const Viewing& viewing() const { return viewing_; }
  /// When the newest sample becomes known, on the clock of at(): frames after it see the end.
  [[nodiscard]] double endSeconds() const { return lastTime_ + latency_; }

 private:
  GazeLog log_;
  Viewing viewing_;
  double latency_;
  double interval_;
  double lastTime_;
  PointOfInterestTracker tracker_;
  std::size_t next_ = 0;
  SampleListener listener_;
};

/// Makes a source from what --gaze names: `center`, `x,y` (each 0..1 of the window), or a log file.
/// @param settings for logs; a fixed point is known at once and exactly
/// @throws InputError naming the fix
[[nodiscard]] std::unique_ptr<GazeSource> parseGazeSpec(const std::string& spec,
                                                        const GazeSettings& settings = {});

}  // namespace macula::gaze
