// A tracker that is read now: from its samples to the point of interest.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/gaze/clock_fit.h"
#include "engine/gaze/clock_judge.h"
#include "engine/gaze/display_mapping.h"
#include "engine/gaze/gaze_settings.h"
#include "engine/gaze/source.h"
#include "engine/gaze/tracker.h"

namespace macula::gaze {

/// A sample as a device gave it.
struct DeviceSample {
  double hostSeconds = 0.0;             ///< when it was read, by the host's steady clock
  std::optional<double> deviceSeconds;  ///< when it was taken, by the device's clock
  glm::dvec2 position = kNoPosition;    ///< 0..1 of the device's display from the top left
  bool valid = false;
};

/// Where samples of a device come from, and how it fares.
class DeviceReader {
 public:
  DeviceReader() = default;
  DeviceReader(const DeviceReader&) = delete;
  DeviceReader& operator=(const DeviceReader&) = delete;
  virtual ~DeviceReader() = default;

  /// Appends the samples that came since the last call, in their order.
  virtual void drain(std::vector<DeviceSample>& samples) = 0;
  [[nodiscard]] virtual bool connected() const = 0;
  [[nodiscard]] virtual std::string name() const = 0;
  /// One line: what a person should know or do; empty where all is well.
  [[nodiscard]] virtual std::string message() const = 0;
};

/// Clock, mapping, loss rule, filter and prediction on the samples of a device.
class LiveGaze final : public GazeSource {
 public:
  /// Samples that stay in memory for status(): two seconds at 2 kHz.
  static constexpr std::size_t kMostRecent = 4096;
  /// By the host's clock no sample is older than this when it is read: beyond it the device's clock
  /// is wrong.
  static constexpr double kOldestSeconds = 1.0;

  /// @param hostStart the host's steady clock in seconds at time 0 of at()
  LiveGaze(DeviceReader& reader, const GazeSettings& settings, double hostStart);

  /// Where display and window are now; samples that come later are placed by it.
  void place(const WindowPlacement& placement) override;
  void onSample(SampleListener listener) override { listener_ = std::move(listener); }

  [[nodiscard]] PointOfInterest at(double timeSeconds) override;
  [[nodiscard]] std::string name() const override { return reader_.name(); }
  [[nodiscard]] SourceStatus status() const override;

 private:
  struct Recent {
    double time = 0.0;
    bool valid = false;
  };

  [[nodiscard]] GazeSample toWindow(const DeviceSample& sample);
  /// Intervals that the nominal one is the median of: half a second at 60 Hz. A blink's silence is
  /// one of them.
  static constexpr std::size_t kIntervals = 31;

  void remember(const GazeSample& sample);
  void learnInterval(double timeSeconds);
  void forgetOldest();

  DeviceReader& reader_;
  Display display_;  ///< whole
  double hostStart_;
  WindowPlacement placement_;
  ClockJudge judge_;
  ClockFit clock_;
  PointOfInterestTracker tracker_;
  SampleListener listener_;
  std::vector<DeviceSample> samples_;
  std::vector<Recent> recent_;  ///< ring
  std::size_t oldest_ = 0;
  std::size_t count_ = 0;
  std::size_t valid_ = 0;  ///< of the recent ones
  std::array<double, kIntervals> intervals_{};
  std::size_t intervalCount_ = 0;
  double lastSample_ = 0.0;
  bool wasConnected_ = false;
};

}  // namespace macula::gaze
