#include "engine/gaze/hid/profile.h"

#include <array>
#include <charconv>
#include <limits>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/settings/registry.h"
#include "engine/settings/toml_file.h"

namespace macula::gaze::hid {
namespace {

/// A key that must be given and was not.
constexpr int kMissing = -1;

constexpr int kMostBits = 64;
constexpr int kMostBytes = static_cast<int>(kMaxReportBytes);
constexpr int kLastBit = kMostBytes * 8 - 1;
constexpr double kWidestScreen = 5e6;  ///< five metres in micrometres, the smallest unit

enum class PlaceUnit : std::uint8_t { Share, Micrometre, Millimetre, Pixel };
const std::vector<std::string> kPlaceUnits{"0..1", "um", "mm", "px"};

enum class TimeUnit : std::uint8_t { Second, Millisecond, Microsecond, Nanosecond };
const std::vector<std::string> kTimeUnits{"s", "ms", "us", "ns"};
constexpr std::array kSecondsPerTimeUnit{1.0, 1e-3, 1e-6, 1e-9};

/// A number of the report as the file describes it.
struct Number {
  int bit = kMissing;
  int bits = kMissing;
  bool isSigned = false;
  double scale = 1.0;
  double offset = 0.0;

  [[nodiscard]] bool given() const { return bit != kMissing || bits != kMissing; }
};

struct File {
  std::string name;
  int vendor = kMissing;
  int product = kMissing;
  int reportId = 0;
  int reportBytes = kMissing;
  PlaceUnit unit = PlaceUnit::Share;
  double screenWidth = 0.0;
  double screenHeight = 0.0;
  Number x;
  Number y;
  Number time;
  TimeUnit timeUnit = TimeUnit::Microsecond;
  Number valid;
  std::int64_t validMin = 1;
  std::int64_t validMax = std::numeric_limits<std::int64_t>::max();
  std::string start;
};

class Reader {
 public:
  Reader(std::string_view text, std::string_view name)
      : name_(name), table_(settings::parseToml(text, name)) {
    registerKeys();
    settings::applyTable(registry_, table_, name);
  }

  TrackerProfile read() {
    require("name", !file_.name.empty());
    require("vendor", file_.vendor != kMissing);
    require("product", file_.product != kMissing);
    require("report.bytes", file_.reportBytes != kMissing);
    require("x.bit", file_.x.bit != kMissing);
    require("y.bit", file_.y.bit != kMissing);

    TrackerProfile profile;
    profile.name = file_.name;
    profile.vendorId = static_cast<std::uint16_t>(file_.vendor);
    profile.productId = static_cast<std::uint16_t>(file_.product);
    TrackerLayout& layout = profile.layout;
    layout.numbered = file_.reportId != 0;
    GazeReportLayout& gaze = layout.gaze;
    gaze.reportId = static_cast<std::uint8_t>(file_.reportId);
    gaze.bytes = static_cast<std::size_t>(file_.reportBytes);
    layout.inputs.push_back({gaze.reportId, gaze.bytes});
    readPlace(profile);
    if (file_.time.given()) {
      const auto unit = static_cast<std::size_t>(file_.timeUnit);
      gaze.timestamp = scalar("time", file_.time, kSecondsPerTimeUnit[unit]);
    }
    if (file_.valid.given()) {
      gaze.validity = scalar("valid", file_.valid, 1.0);
      if (file_.validMax < file_.validMin) {
        failInput("{}: valid.max: is less than valid.min, so that no sample would be valid",
                  place("valid.max"));
      }
      gaze.validity->range = Bounds{file_.validMin, file_.validMax};
    }
    layout.startReport = startReport();
    return profile;
  }

 private:
  void registerKeys() {
    registry_.add({.key = "name"}, file_.name);
    registry_.add({.key = "vendor"}, file_.vendor, {.min = kMissing, .max = 0xFFFF});
    registry_.add({.key = "product"}, file_.product, {.min = kMissing, .max = 0xFFFF});
    registry_.add({.key = "report.id"}, file_.reportId, {.min = 0, .max = 0xFF});
    registry_.add({.key = "report.bytes"}, file_.reportBytes, {.min = kMissing, .max = kMostBytes});
    registry_.addChoice({.key = "unit"}, file_.unit, kPlaceUnits);
    const settings::Range screen{.min = 0, .max = kWidestScreen};
    registry_.add({.key = "screen.width"}, file_.screenWidth, screen);
    registry_.add({.key = "screen.height"}, file_.screenHeight, screen);
    registerNumber("x", file_.x);
    registerNumber("y", file_.y);
    registerNumber("time", file_.time);
    registry_.addChoice({.key = "time.unit"}, file_.timeUnit, kTimeUnits);
    registerNumber("valid", file_.valid);
    registry_.add({.key = "valid.min"}, file_.validMin);
    registry_.add({.key = "valid.max"}, file_.validMax);
    registry_.add({.key = "start"}, file_.start);
  }

  void registerNumber(const std::string& key, Number& number) {
    registry_.add({.key = key + ".bit"}, number.bit, {.min = kMissing, .max = kLastBit});
    registry_.add({.key = key + ".bits"}, number.bits, {.min = kMissing, .max = kMostBits});
    registry_.add({.key = key + ".signed"}, number.isSigned);
    registry_.add({.key = key + ".scale"}, number.scale);
    registry_.add({.key = key + ".offset"}, number.offset);
  }

  [[nodiscard]] std::string place(std::string_view key) const {
    const auto node = table_.at_path(key);
    return node ? fmt::format("{}:{}", name_, node.node()->source().begin.line)
                : std::string(name_);
  }

  void require(std::string_view key, bool given) const {
    if (!given) failInput("{}: '{}' is missing; add it", place(key), key);
  }

  [[nodiscard]] Scalar scalar(const std::string& key, const Number& number, double unit) const {
    require(key + ".bit", number.bit != kMissing);
    require(key + ".bits", number.bits > 0);
    const Scalar made{.bit = static_cast<std::uint32_t>(number.bit),
                      .bits = static_cast<std::uint32_t>(number.bits),
                      .isSigned = number.isSigned,
                      .range = std::nullopt,
                      .scale = number.scale * unit,
                      .offset = number.offset * unit};
    if (made.endBit() > static_cast<std::size_t>(file_.reportBytes) * 8) {
      failInput("{}: {}.bit + {}.bits: end at bit {}, but the report has {} bytes",
                place(key + ".bit"), key, key, made.endBit(), file_.reportBytes);
    }
    return made;
  }

  void readPlace(TrackerProfile& profile) const {
    GazeReportLayout& gaze = profile.layout.gaze;
    glm::dvec2 perUnit{file_.unit == PlaceUnit::Micrometre ? 1e-3 : 1.0};
    if (file_.unit != PlaceUnit::Share) {
      require("screen.width", file_.screenWidth > 0.0);
      require("screen.height", file_.screenHeight > 0.0);
      const glm::dvec2 screen{file_.screenWidth, file_.screenHeight};
      // Pixels have no length: they become shares here and now.
      if (file_.unit == PlaceUnit::Pixel) {
        perUnit /= screen;
      } else {
        profile.screenMm = screen * perUnit;
      }
    }
    gaze.shares = !profile.screenMm;
    gaze.x = scalar("x", file_.x, perUnit.x);
    gaze.y = scalar("y", file_.y, perUnit.y);
  }

  /// "14 03" as bytes.
  [[nodiscard]] std::vector<std::uint8_t> startReport() const {
    std::vector<std::uint8_t> bytes;
    const std::string& text = file_.start;
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
        failInput("{}: start: '{}' is not a list of bytes such as \"14 03\"", place("start"), text);
      }
      bytes.push_back(byte);
      at += 2;
    }
    return bytes;
  }

  std::string_view name_;
  toml::table table_;
  File file_;
  settings::Registry registry_;
};

}  // namespace

TrackerProfile parseProfile(std::string_view text, std::string_view name) {
  return Reader(text, name).read();
}

TrackerProfile readProfile(const std::filesystem::path& path) {
  const std::string name = path.string();
  return parseProfile(readTextFile(path), name);
}

}  // namespace macula::gaze::hid
