// Where the values of an eye tracker lie in its reports, found by usage and collection.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/gaze/hid/descriptor.h"

namespace macula::gaze::hid {

/// A number in a report and what it means.
struct Scalar {
  std::uint32_t bit = 0;   ///< from the report's first bit, its id byte included
  std::uint32_t bits = 0;  ///< 1..64, little-endian
  bool isSigned = false;
  /// Of the raw number; one outside it is null (6.2.2.5).
  std::optional<Bounds> range = std::nullopt;
  double scale = 1.0;  ///< value = raw * scale + offset
  double offset = 0.0;

  [[nodiscard]] std::size_t endBit() const { return std::size_t{bit} + bits; }
};

using ScalarTriple = std::array<Scalar, 3>;

/// The input report that carries gaze.
struct GazeReportLayout {
  std::uint8_t reportId = 0;
  std::size_t bytes = 0;  ///< with its id
  Scalar x;               ///< millimetres from the calibrated display's left edge, or shares of it
  Scalar y;               ///< the same from its top edge
  bool shares = false;    ///< x and y are 0..1 of the display as they stand
  std::optional<Scalar> validity;   ///< null where the sample is not valid; absent: always valid
  std::optional<Scalar> timestamp;  ///< seconds by the device's clock
  std::optional<ScalarTriple> leftEye;   ///< millimetres
  std::optional<ScalarTriple> rightEye;  ///< millimetres
};

/// A number somewhere in an input or feature report.
struct ReportScalar {
  ReportKind kind = ReportKind::Feature;
  std::uint8_t reportId = 0;
  std::size_t bytes = 0;  ///< of the report, with its id
  Scalar value;
};

/// Length of an input report, to tell garbage from what is merely of no use here.
struct InputReport {
  std::uint8_t reportId = 0;
  std::size_t bytes = 0;
};

struct TrackerLayout {
  bool numbered = false;
  GazeReportLayout gaze;
  std::vector<InputReport> inputs;
  std::optional<ReportScalar> status;        ///< a ConfigurationStatus
  std::optional<ReportScalar> samplingHz;    ///< hertz
  std::optional<ReportScalar> quality;       ///< of the capabilities
  std::optional<ReportScalar> screenWidth;   ///< of the calibrated display, millimetres
  std::optional<ReportScalar> screenHeight;  ///< millimetres
  std::optional<ReportScalar> modeRequest;   ///< feature to be written
  std::uint64_t mode = 0;                    ///< what to write there
  std::vector<std::uint8_t> startReport;     ///< a profile's feature report instead; may be empty
  /// Extent of the range that the descriptor states for x and y, in millimetres, where that is a
  /// size which a display may have: what to divide by when the device does not tell a better one.
  std::optional<glm::dvec2> statedScreenMm;
};

/// Finds the values of an eye tracker: gaze below Gaze Point, eyes below Left and Right Eye, a
/// timestamp in one field or in bytes that follow each other. What is absent beside the gaze, or
/// has a unit that makes no sense, is left out.
/// @param name what to call the device in messages
/// @throws InputError where the device tells no gaze point that could be read
[[nodiscard]] TrackerLayout layoutOf(const Descriptor& descriptor, std::string_view name);

}  // namespace macula::gaze::hid
