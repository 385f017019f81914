#include "engine/gaze/hid/layout.h"

#include <algorithm>
#include <cmath>

#include "engine/core/error.h"

namespace macula::gaze::hid {
namespace {

/// Units of HID 1.11, 6.2.2.7: nibble 0 is the system, nibble 1 the exponent of length, nibble 3
/// that of time. The second is the same in every system.
constexpr std::uint32_t kCentimetre = 0x11;
constexpr std::uint32_t kInch = 0x13;
constexpr std::uint32_t kSecond = 0x1000;
constexpr std::uint32_t kSystemNibble = 0x000F;

// HUTRR74 gives lengths in micrometres and times in microseconds; a field without a unit is taken
// to mean that.
constexpr double kMicrometreInMm = 1e-3;
constexpr double kMicrosecond = 1e-6;

/// No display is larger; a wider range is that of the number's type, not of a display.
constexpr double kWidestDisplayMm = 5000.0;

std::optional<double> millimetresPerUnit(const Field& field) {
  if (field.unit == 0) return kMicrometreInMm;
  const double power = std::pow(10.0, field.unitExponent);
  if (field.unit == kCentimetre) return 10.0 * power;
  if (field.unit == kInch) return 25.4 * power;
  return std::nullopt;
}

std::optional<double> secondsPerUnit(const Field& field) {
  if (field.unit == 0) return kMicrosecond;
  if ((field.unit & ~kSystemNibble) != kSecond) return std::nullopt;
  return std::pow(10.0, field.unitExponent);
}

/// Raw numbers become physical ones by the two ranges (5.10), then `unit` makes them ours.
Scalar scalarOf(const Descriptor& descriptor, const Field& field, double unit) {
  double scale = 1.0;
  double offset = 0.0;
  if (field.logical.stated() && field.physical.stated() && field.physical != field.logical) {
    scale = static_cast<double>(field.physical.max - field.physical.min) /
            static_cast<double>(field.logical.max - field.logical.min);
    offset =
        static_cast<double>(field.physical.min) - static_cast<double>(field.logical.min) * scale;
  }
  return {.bit = field.bitOffset + (descriptor.numbered ? 8U : 0U),
          .bits = field.bitSize,
          .isSigned = field.isSigned(),
          .range = field.logical.stated() ? std::optional(field.logical) : std::nullopt,
          .scale = scale * unit,
          .offset = offset * unit};
}

class Finder {
 public:
  Finder(const Descriptor& descriptor, std::string_view name)
      : descriptor_(descriptor), name_(name) {}

  TrackerLayout find() {
    TrackerLayout layout;
    layout.numbered = descriptor_.numbered;
    for (const ReportSize& report : descriptor_.reports) {
      if (report.kind != ReportKind::Input) continue;
      layout.inputs.push_back(
          {report.reportId, descriptor_.reportBytes(ReportKind::Input, report.reportId)});
    }
    findGaze(layout);
    layout.status = value(kConfigurationStatus, ReportKind::Input);
    layout.samplingHz = value(kSamplingFrequency, ReportKind::Input);
    layout.quality = value(kTrackerQuality, ReportKind::Feature);
    layout.screenWidth = length(kCalibratedScreenWidth);
    layout.screenHeight = length(kCalibratedScreenHeight);
    if (const Field* mode = field(kModeRequest, ReportKind::Feature)) {
      layout.modeRequest = reportScalar(*mode, 1.0);
      // A device that knows fewer bits says so by its range; the gaze is what matters.
      const bool takesEyes =
          mode->bitSize >= 2 &&
          (!mode->logical.stated() || mode->logical.max >= std::int64_t{kModeGaze | kModeEyes});
      layout.mode = takesEyes ? kModeGaze | kModeEyes : kModeGaze;
    }
    return layout;
  }

 private:
  static bool readable(const Field& field) { return field.bitSize <= 64; }

  const Field* field(Usage usage, ReportKind preferred) const {
    const Field* other = nullptr;
    for (const Field& field : descriptor_.fields) {
      if (field.usage != usage || !readable(field)) continue;
      if (field.kind == preferred) return &field;
      if (field.kind != ReportKind::Output && other == nullptr) other = &field;
    }
    return other;
  }

  /// X, Y and Z stand under several parents: the nearest collection that means a place decides.
  const Field* place(Usage usage, Usage parent, std::optional<std::uint8_t> reportId) const {
    for (const Field& field : descriptor_.fields) {
      if (field.kind != ReportKind::Input || field.usage != usage || !readable(field)) continue;
      if (reportId && field.reportId != *reportId) continue;
      if (placeOf(field) == parent) return &field;
    }
    return nullptr;
  }

  Usage placeOf(const Field& field) const {
    std::int32_t at = field.collection;
    while (at >= 0) {
      const Collection& collection = descriptor_.collections[static_cast<std::size_t>(at)];
      if (collection.usage >= kGazePoint && collection.usage <= kHeadDirection) {
        return collection.usage;
      }
      at = collection.parent;
    }
    return kNoUsage;
  }

  ReportScalar reportScalar(const Field& field, double unit) const {
    return {.kind = field.kind,
            .reportId = field.reportId,
            .bytes = descriptor_.reportBytes(field.kind, field.reportId),
            .value = scalarOf(descriptor_, field, unit)};
  }

  std::optional<ReportScalar> value(Usage usage, ReportKind preferred) const {
    const Field* found = field(usage, preferred);
    if (found == nullptr) return std::nullopt;
    const double power = found->unit == 0 ? 1.0 : std::pow(10.0, found->unitExponent);
    return reportScalar(*found, power);
  }

  std::optional<ReportScalar> length(Usage usage) const {
    const Field* found = field(usage, ReportKind::Feature);
    const auto unit = found == nullptr ? std::nullopt : millimetresPerUnit(*found);
    if (!unit) return std::nullopt;
    return reportScalar(*found, *unit);
  }

  void findGaze(TrackerLayout& layout) const {
    const Field* x = place(kPositionX, kGazePoint, std::nullopt);
    if (x == nullptr) {
      failInput(
          "{}: its report descriptor has no gaze point (usage page 0x12: Position X below "
          "Gaze Point); describe the device by a tracker profile",
          name_);
    }
    const Field* y = place(kPositionY, kGazePoint, x->reportId);
    if (y == nullptr) failInput("{}: its gaze point has an X but no Y in the same report", name_);
    const auto unitX = millimetresPerUnit(*x);
    const auto unitY = millimetresPerUnit(*y);
    if (!unitX || !unitY) {
      failInput(
          "{}: its gaze point has the HID unit {:#x}, which is no length; describe the "
          "device by a tracker profile",
          name_, unitX ? y->unit : x->unit);
    }
    GazeReportLayout& gaze = layout.gaze;
    gaze.reportId = x->reportId;
    gaze.bytes = descriptor_.reportBytes(ReportKind::Input, x->reportId);
    gaze.x = scalarOf(descriptor_, *x, *unitX);
    gaze.y = scalarOf(descriptor_, *y, *unitY);
    gaze.timestamp = timestamp(x->reportId);
    gaze.leftEye = triple(kLeftEye, x->reportId);
    gaze.rightEye = triple(kRightEye, x->reportId);

    const glm::dvec2 extent{static_cast<double>(x->physical.max) * *unitX,
                            static_cast<double>(y->physical.max) * *unitY};
    const bool fromZero = x->physical.min == 0 && y->physical.min == 0;
    if (fromZero && extent.x > 0.0 && extent.y > 0.0 && extent.x <= kWidestDisplayMm &&
        extent.y <= kWidestDisplayMm) {
      layout.statedScreenMm = extent;
    }
  }

  std::optional<ScalarTriple> triple(Usage parent, std::uint8_t reportId) const {
    ScalarTriple scalars;
    constexpr std::array kAxes{kPositionX, kPositionY, kPositionZ};
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
      const Field* found = place(kAxes[i], parent, reportId);
      const auto unit = found == nullptr ? std::nullopt : millimetresPerUnit(*found);
      if (!unit) return std::nullopt;
      scalars[i] = scalarOf(descriptor_, *found, *unit);
    }
    return scalars;
  }

  /// One field of up to 64 bits, or up to eight that follow each other, the lowest first.
  std::optional<Scalar> timestamp(std::uint8_t reportId) const {
    std::vector<const Field*> parts;
    for (const Field& field : descriptor_.fields) {
      if (field.kind == ReportKind::Input && field.reportId == reportId &&
          field.usage == kSensorTimestamp) {
        parts.push_back(&field);
      }
    }
    if (parts.empty()) return std::nullopt;
    std::uint32_t bits = 0;
    for (const Field* part : parts) {
      if (part->bitOffset != parts.front()->bitOffset + bits) return std::nullopt;
      if (part->bitSize > 64 - bits) return std::nullopt;
      bits += part->bitSize;
    }
    const auto unit = secondsPerUnit(*parts.front());
    if (!unit) return std::nullopt;
    // Counters run to the end of their type whatever range is stated, and have no sign.
    return Scalar{.bit = parts.front()->bitOffset + (descriptor_.numbered ? 8U : 0U),
                  .bits = bits,
                  .isSigned = false,
                  .range = std::nullopt,
                  .scale = *unit,
                  .offset = 0.0};
  }

  const Descriptor& descriptor_;
  std::string_view name_;
};

}  // namespace

TrackerLayout layoutOf(const Descriptor& descriptor, std::string_view name) {
  return Finder(descriptor, name).find();
}

}  // namespace macula::gaze::hid
