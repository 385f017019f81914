#include "engine/gaze/hid/report.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace macula::gaze::hid {
namespace {

std::optional<glm::dvec3> readTriple(const std::optional<ScalarTriple>& triple,
                                     std::span<const std::uint8_t> bytes) {
  if (!triple) return std::nullopt;
  const auto x = readScalar((*triple)[0], bytes);
  const auto y = readScalar((*triple)[1], bytes);
  const auto z = readScalar((*triple)[2], bytes);
  if (!x || !y || !z) return std::nullopt;
  return glm::dvec3{*x, *y, *z};
}

bool fits(const Scalar& scalar, std::size_t bytes) {
  return scalar.bits > 0 && scalar.bits <= 64 && scalar.endBit() <= bytes * 8;
}

/// Transports may pad a report to the length of their packets, with zeros.
bool isOnlyPadding(std::span<const std::uint8_t> rest) {
  return std::all_of(rest.begin(), rest.end(), [](std::uint8_t byte) { return byte == 0; });
}

}  // namespace

std::int64_t rawNumber(const Scalar& scalar, std::span<const std::uint8_t> bytes) {
  if (!fits(scalar, bytes.size())) return 0;
  std::uint64_t raw = 0;
  // Up to nine bytes hold 64 bits that do not begin at a byte.
  const std::size_t first = scalar.bit / 8;
  const std::uint32_t shift = scalar.bit % 8;
  const std::size_t last = (scalar.endBit() - 1) / 8;
  for (std::size_t i = first; i <= last; ++i) {
    const std::size_t place = 8 * (i - first);
    const std::uint64_t byte = bytes[i];
    raw |= place >= shift ? (place - shift < 64 ? byte << (place - shift) : 0) : byte >> shift;
  }
  if (scalar.bits == 64) return static_cast<std::int64_t>(raw);
  raw &= (std::uint64_t{1} << scalar.bits) - 1;
  const std::uint64_t sign = std::uint64_t{1} << (scalar.bits - 1);
  if (scalar.isSigned && (raw & sign) != 0) raw |= ~((sign << 1) - 1);
  return static_cast<std::int64_t>(raw);
}

std::optional<double> readScalar(const Scalar& scalar, std::span<const std::uint8_t> bytes) {
  if (!fits(scalar, bytes.size())) return std::nullopt;
  const std::int64_t raw = rawNumber(scalar, bytes);
  if (scalar.range && (raw < scalar.range->min || raw > scalar.range->max)) return std::nullopt;
  using Int32 = std::numeric_limits<std::int32_t>;
  if (scalar.bits == 32 && (raw == Int32::max() || raw == Int32::min())) return std::nullopt;
  const double number = scalar.isSigned || scalar.bits < 64
                            ? static_cast<double>(raw)
                            : static_cast<double>(static_cast<std::uint64_t>(raw));
  const double value = number * scalar.scale + scalar.offset;
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

void writeRaw(const Scalar& scalar, std::uint64_t raw, std::span<std::uint8_t> bytes) {
  if (!fits(scalar, bytes.size())) return;
  for (std::uint32_t i = 0; i < scalar.bits; ++i) {
    const std::size_t bit = std::size_t{scalar.bit} + i;
    const auto mask = static_cast<std::uint8_t>(1U << (bit % 8));
    const bool set = ((raw >> i) & 1U) != 0;
    bytes[bit / 8] =
        static_cast<std::uint8_t>(set ? bytes[bit / 8] | mask : bytes[bit / 8] & ~mask);
  }
}

ReportClass ReportDecoder::decode(std::span<const std::uint8_t> bytes, HidGazeReport& gaze) {
  if (bytes.empty()) return ReportClass::Garbage;
  const std::uint8_t id = layout_.numbered ? bytes.front() : std::uint8_t{0};
  const auto known = std::find_if(layout_.inputs.begin(), layout_.inputs.end(),
                                  [id](const InputReport& input) { return input.reportId == id; });
  if (known == layout_.inputs.end() || bytes.size() < known->bytes ||
      !isOnlyPadding(bytes.subspan(known->bytes))) {
    return ReportClass::Garbage;
  }
  if (id == layout_.gaze.reportId) {
    gaze = decodeGaze(bytes);
    return ReportClass::Gaze;
  }
  return decodeStatus(id, bytes) ? ReportClass::Status : ReportClass::Other;
}

HidGazeReport ReportDecoder::decodeGaze(std::span<const std::uint8_t> bytes) const {
  const GazeReportLayout& layout = layout_.gaze;
  HidGazeReport gaze;
  if (layout.timestamp) gaze.deviceSeconds = readScalar(*layout.timestamp, bytes);
  gaze.leftEyeMm = readTriple(layout.leftEye, bytes);
  gaze.rightEyeMm = readTriple(layout.rightEye, bytes);
  const auto x = readScalar(layout.x, bytes);
  const auto y = readScalar(layout.y, bytes);
  if (x && y && (layout.shares || screenMm_)) {
    gaze.position = glm::dvec2{*x, *y};
    if (!layout.shares) gaze.position /= *screenMm_;
  }
  // Far beyond any display, but still no number that anything downstream could trip over.
  if (!std::isfinite(gaze.position.x) || !std::isfinite(gaze.position.y)) {
    gaze.position = kNoPosition;
  }
  const bool flagged = layout.validity && !readScalar(*layout.validity, bytes);
  gaze.valid = !flagged && std::isfinite(gaze.position.x);
  return gaze;
}

bool ReportDecoder::decodeStatus(std::uint8_t reportId, std::span<const std::uint8_t> bytes) {
  bool any = false;
  const auto isHere = [reportId](const std::optional<ReportScalar>& scalar) {
    return scalar && scalar->kind == ReportKind::Input && scalar->reportId == reportId;
  };
  if (isHere(layout_.status)) {
    const std::int64_t raw = rawNumber(layout_.status->value, bytes);
    const auto last = static_cast<std::int64_t>(ConfigurationStatus::CalibrationNeeded);
    condition_.status = raw >= 0 && raw <= last ? static_cast<ConfigurationStatus>(raw)
                                                : ConfigurationStatus::Unknown;
    any = true;
  }
  if (isHere(layout_.samplingHz)) {
    condition_.samplingHz = readScalar(layout_.samplingHz->value, bytes).value_or(0.0);
    any = true;
  }
  return any;
}

std::optional<glm::dvec2> screenSize(const TrackerLayout& layout,
                                     std::span<const std::uint8_t> featureReport) {
  if (!layout.screenWidth || !layout.screenHeight) return std::nullopt;
  const auto width = readScalar(layout.screenWidth->value, featureReport);
  const auto height = readScalar(layout.screenHeight->value, featureReport);
  if (!width || !height || !(*width > 0.0) || !(*height > 0.0)) return std::nullopt;
  return glm::dvec2{*width, *height};
}

}  // namespace macula::gaze::hid
