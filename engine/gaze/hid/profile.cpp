#include "engine/gaze/hid/profile.h"

#include <array>
#include <charconv>
#include <limits>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/settings/toml_file.h"
#include "engine/settings/typed_reader.h"

namespace macula::gaze::hid {
namespace {

using settings::TypedReader;

constexpr double kMostBits = 64;
constexpr double kMostBytes = kMaxReportBytes;
constexpr settings::Range kUsbId{.min = 0, .max = 0xFFFF};
constexpr double kWidestScreen = 5e6;  ///< five metres in micrometres, the smallest unit

enum class PlaceUnit : std::uint8_t { Share, Micrometre, Millimetre, Pixel };
const std::vector<std::string> kPlaceUnits{"0..1", "um", "mm", "px"};

const std::vector<std::string> kTimeUnits{"s", "ms", "us", "ns"};
constexpr std::array kSecondsPerTimeUnit{1.0, 1e-3, 1e-6, 1e-9};
constexpr std::size_t kUsualTimeUnit = 2;  ///< microseconds

/// Reads `bit`, `bits`, `signed`, `scale` and `offset`.
/// @param unit what one of the file's units is here
/// @param reportBytes length of the report that must hold the number
Scalar readScalar(TypedReader& reader, double unit, std::size_t reportBytes) {
  Scalar scalar;
  scalar.bit = static_cast<std::uint32_t>(
      reader.get<int>("bit", {.min = 0, .max = kMostBytes * 8 - 1}, "bits"));
  scalar.bits =
      static_cast<std::uint32_t>(reader.get<int>("bits", {.min = 1, .max = kMostBits}, "bits"));
  reader.take("signed", scalar.isSigned);
  reader.take("scale", scalar.scale);
  reader.take("offset", scalar.offset);
  scalar.scale *= unit;
  scalar.offset *= unit;
  if (scalar.endBit() > reportBytes * 8) {
    reader.fail("bits", fmt::format("and 'bit' end at bit {}, but the report has {} bytes",
                                    scalar.endBit(), reportBytes));
  }
  return scalar;
}

/// Where on the display: x, y, and what they are measured in.
void readPlace(TypedReader& reader, TrackerProfile& profile) {
  PlaceUnit unit = PlaceUnit::Share;
  reader.takeChoice("unit", unit, kPlaceUnits);
  TypedReader screen = reader.table("screen");
  constexpr settings::Range kSide{.min = 0, .minExclusive = true, .max = kWidestScreen};
  glm::dvec2 perUnit{unit == PlaceUnit::Micrometre ? 1e-3 : 1.0};
  if (unit != PlaceUnit::Share) {
    const std::string_view name = kPlaceUnits[static_cast<std::size_t>(unit)];
    const glm::dvec2 size{screen.get<double>("width", kSide, name),
                          screen.get<double>("height", kSide, name)};
    // Pixels have no length: they become shares here and now.
    if (unit == PlaceUnit::Pixel) {
      perUnit /= size;
    } else {
      profile.screenMm = size * perUnit;
    }
    screen.finish();
  }
  GazeReportLayout& gaze = profile.layout.gaze;
  gaze.shares = !profile.screenMm;
  TypedReader x = reader.table("x");
  TypedReader y = reader.table("y");
  gaze.x = readScalar(x, perUnit.x, gaze.bytes);
  gaze.y = readScalar(y, perUnit.y, gaze.bytes);
  x.finish();
  y.finish();
}

void readTime(TypedReader reader, GazeReportLayout& gaze) {
  std::size_t unit = kUsualTimeUnit;
  reader.takeChoice("unit", unit, kTimeUnits);
  gaze.timestamp = readScalar(reader, kSecondsPerTimeUnit.at(unit), gaze.bytes);
  reader.finish();
}

void readValidity(TypedReader reader, GazeReportLayout& gaze) {
  Bounds valid{1, std::numeric_limits<std::int64_t>::max()};
  reader.take("min", valid.min);
  reader.take("max", valid.max);
  if (valid.max < valid.min) {
    reader.fail("max", "is less than 'min', so that no sample would be valid");
  }
  gaze.validity = readScalar(reader, 1.0, gaze.bytes);
  gaze.validity->range = valid;
  reader.finish();
}

/// "14 03" as bytes; empty where there is no such key.
std::vector<std::uint8_t> readStart(TypedReader& reader) {
  std::vector<std::uint8_t> bytes;
  const std::string text = reader.has("start") ? reader.textOrNull("start") : std::string();
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == ' ') {
      ++at;
      continue;
    }
    std::uint8_t byte = 0;
    const char* begin = text.data() + at;
    const char* end = begin + std::min<std::size_t>(2, text.size() - at);
    const auto [stop, error] = std::from_chars(begin, end, byte, 16);
    if (error != std::errc{} || stop != begin + 2 || bytes.size() >= kMaxReportBytes) {
      reader.fail("start", "is no list of bytes such as \"14 03\"");
    }
    bytes.push_back(byte);
    at += 2;
  }
  return bytes;
}

}  // namespace

TrackerProfile parseProfile(std::string_view text, std::string_view name) {
  const toml::table table = settings::parseToml(text, name);
  TypedReader reader{settings::DataNode(table), std::string(name)};
  TrackerProfile profile;
  profile.name = reader.get<std::string>("name");
  profile.vendorId = static_cast<std::uint16_t>(reader.get<int>("vendor", kUsbId));
  profile.productId = static_cast<std::uint16_t>(reader.get<int>("product", kUsbId));
  TrackerLayout& layout = profile.layout;
  GazeReportLayout& gaze = layout.gaze;
  TypedReader report = reader.table("report");
  gaze.reportId =
      static_cast<std::uint8_t>(report.find<int>("id", {.min = 0, .max = 0xFF}).value_or(0));
  gaze.bytes =
      static_cast<std::size_t>(report.get<int>("bytes", {.min = 1, .max = kMostBytes}, "bytes"));
  report.finish();
  layout.numbered = gaze.reportId != 0;
  layout.inputs.push_back({gaze.reportId, gaze.bytes});
  readPlace(reader, profile);
  if (reader.has("time")) readTime(reader.getTable("time"), gaze);
  if (reader.has("valid")) readValidity(reader.getTable("valid"), gaze);
  layout.startReport = readStart(reader);
  reader.finish();
  return profile;
}

TrackerProfile readProfile(const std::filesystem::path& path) {
  const std::string name = path.string();
  return parseProfile(readTextFile(path), name);
}

}  // namespace macula::gaze::hid
