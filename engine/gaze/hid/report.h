// From the bytes of an input report to gaze. Bounds are checked; nothing is cast.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>

#include "engine/gaze/hid/layout.h"
#include "engine/gaze/log.h"

namespace macula::gaze::hid {

/// The raw number, with its sign; 0 where the scalar does not lie within `bytes`.
[[nodiscard]] std::int64_t rawNumber(const Scalar& scalar, std::span<const std::uint8_t> bytes);

/// The value, or nothing where the number is null: out of the stated range, or, in 32 bits, one of
/// the two ends of the signed type, which drivers send for what they do not know. A scalar beyond
/// the bytes is null too.
[[nodiscard]] std::optional<double> readScalar(const Scalar& scalar,
                                               std::span<const std::uint8_t> bytes);

/// Puts a raw number into a report; bits beyond the scalar's or the report's are dropped.
void writeRaw(const Scalar& scalar, std::uint64_t raw, std::span<std::uint8_t> bytes);

/// What one gaze report says.
struct HidGazeReport {
  std::optional<double> deviceSeconds;  ///< as the descriptor means it; see ClockJudge
  glm::dvec2 position = kNoPosition;    ///< 0..1 of the calibrated display from the top left
  std::optional<glm::dvec3> leftEyeMm;  ///< from the display's upper left, as the device says
  std::optional<glm::dvec3> rightEyeMm;
  bool valid = false;  ///< a position is known and the device calls it valid
};

enum class ReportClass : std::uint8_t {
  Gaze,
  Status,   ///< status() has changed
  Other,    ///< the descriptor has it, but there is nothing in it for us
  Garbage,  ///< empty, unknown, too short, or too long by more than zeros
};

/// What a tracker says about itself now and then.
struct TrackerCondition {
  ConfigurationStatus status = ConfigurationStatus::Unknown;
  double samplingHz = 0.0;  ///< 0: not said
};

class ReportDecoder {
 public:
  explicit ReportDecoder(TrackerLayout layout) : layout_(std::move(layout)) {}

  /// Size of the calibrated display. Until it is known, positions are NaN and samples not valid,
  /// except where the device gives shares of the display itself.
  void setScreen(const glm::dvec2& millimetres) { screenMm_ = millimetres; }

  /// @param bytes a report as read, with its id where reports are numbered
  /// @param gaze is overwritten where the report is one of gaze
  [[nodiscard]] ReportClass decode(std::span<const std::uint8_t> bytes, HidGazeReport& gaze);

  [[nodiscard]] const TrackerLayout& layout() const { return layout_; }
  [[nodiscard]] const TrackerCondition& condition() const { return condition_; }

 private:
  [[nodiscard]] HidGazeReport decodeGaze(std::span<const std::uint8_t> bytes) const;
  bool decodeStatus(std::uint8_t reportId, std::span<const std::uint8_t> bytes);

  TrackerLayout layout_;
  std::optional<glm::dvec2> screenMm_;
  TrackerCondition condition_;
};

/// Size of the calibrated display in millimetres from the feature report that holds it; nothing
/// where the report is too short or says zero.
/// @param width, height of a TrackerLayout; both in one report
[[nodiscard]] std::optional<glm::dvec2> screenSize(const TrackerLayout& layout,
                                                   std::span<const std::uint8_t> featureReport);

}  // namespace macula::gaze::hid
