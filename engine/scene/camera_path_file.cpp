// Camera paths as CSV files; declared in camera_path.h.
#include <charconv>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <optional>
#include <span>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/core/plural.h"
#include "engine/scene/camera_path.h"

namespace macula::scene {
namespace {

constexpr std::string_view kHeader = "time_s,x,y,z,target_x,target_y,target_z,vfov_deg,cut";
constexpr std::string_view kCutColumn = "cut";
constexpr std::size_t kFields = 9;
constexpr std::size_t kQuoted = 100;  // bytes of a damaged file that a message repeats at most
constexpr double kDegrees = 180.0 / glm::pi<double>();
// Farther out than any scene; floats beyond it would lose whole metres, or overflow when squared.
constexpr double kFarthest = 1e9;

std::string_view trimmed(std::string_view text) {
  const auto isSpace = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && isSpace(text.front())) text.remove_prefix(1);
  while (!text.empty() && isSpace(text.back())) text.remove_suffix(1);
  return text;
}

std::vector<std::string_view> splitFields(std::string_view line) {
  std::vector<std::string_view> fields;
  for (;;) {
    const std::size_t comma = line.find(',');
    fields.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

/// Where a message points: "file, line 12".
struct Place {
  const std::string& file;
  std::size_t line;
};

double readNumber(const Place& place, std::string_view field, std::string_view column) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc{} || end != field.data() + field.size() || !std::isfinite(value)) {
    if (column == kCutColumn) {
      failInput("{}, line {}: cut is '{}'; write 0 or 1", place.file, place.line,
                field.substr(0, kQuoted));
    }
    failInput("{}, line {}: {} is '{}'; write a number with a decimal point", place.file,
              place.line, column, field.substr(0, kQuoted));
  }
  if (std::abs(value) > kFarthest) {
    failInput("{}, line {}: {} is {}; keep it within {:g}", place.file, place.line, column, field,
              kFarthest);
  }
  return value;
}

/// The names of the columns, of which the last (cut) may be missing.
std::vector<std::string_view> readHeader(const Place& place, std::string_view line) {
  const std::vector<std::string_view> expected = splitFields(kHeader);
  const std::vector<std::string_view> found = splitFields(line);
  bool fits = found.size() == kFields || found.size() + 1 == kFields;
  for (std::size_t i = 0; fits && i < found.size(); ++i) fits = found[i] == expected[i];
  if (!fits) {
    failInput("{}, line {}: the header is '{}'; write {}", place.file, place.line,
              line.substr(0, kQuoted), kHeader);
  }
  return {expected.begin(), expected.begin() + static_cast<std::ptrdiff_t>(found.size())};
}

CameraKey readRow(const Place& place, std::span<const std::string_view> columns,
                  std::string_view line) {
  const std::vector<std::string_view> fields = splitFields(line);
  if (fields.size() != columns.size()) {
    failInput("{}, line {}: {} where the header has {}; write one for each column", place.file,
              place.line, counted(fields.size(), "field"), columns.size());
  }
  double v[kFields] = {};
  for (std::size_t i = 0; i < fields.size(); ++i) v[i] = readNumber(place, fields[i], columns[i]);
  CameraKey key;
  key.time = v[0];
  key.position = glm::dvec3(v[1], v[2], v[3]);
  key.target = glm::dvec3(v[4], v[5], v[6]);
  key.verticalFov = static_cast<float>(v[7] / kDegrees);
  key.cut = v[8] != 0.0;
  if (key.time < 0.0) {
    failInput("{}, line {}: time_s is {}; begin at 0 or later", place.file, place.line, fields[0]);
  }
  if (key.position == key.target) {
    failInput("{}, line {}: the target is the position; move it ahead of the camera", place.file,
              place.line);
  }
  const glm::vec3 ahead = glm::normalize(key.target - key.position);
  if (ahead.x == 0.0F && ahead.z == 0.0F) {
    failInput("{}, line {}: the camera looks straight up or down; tilt it a little", place.file,
              place.line);
  }
  if (!(key.verticalFov > 0.0F) || !(v[7] < 180.0)) {
    failInput("{}, line {}: vfov_deg is {}; choose more than 0 and less than 180", place.file,
              place.line, fields[7]);
  }
  if (v[8] != 0.0 && v[8] != 1.0) {
    failInput("{}, line {}: cut is {}; write 0 or 1", place.file, place.line, fields[8]);
  }
  return key;
}

}  // namespace

std::vector<CameraKey> parseCameraPath(std::string_view text, const std::string& name) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.substr(0, kByteOrderMark.size()) == kByteOrderMark) {
    text.remove_prefix(kByteOrderMark.size());
  }
  std::vector<std::string_view> columns;
  std::vector<CameraKey> keys;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    const std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.empty() || line.front() == '#') continue;
    const Place place{name, number};
    if (columns.empty()) {
      columns = readHeader(place, line);
      continue;
    }
    CameraKey key = readRow(place, columns, line);
    if (!keys.empty() && !(key.time > keys.back().time)) {
      failInput("{}, line {}: time_s is {} after {}; times must increase", name, number, key.time,
                keys.back().time);
    }
    keys.push_back(key);
  }
  if (columns.empty()) failInput("{}: holds no camera path; begin with the line {}", name, kHeader);
  if (keys.empty()) failInput("{}: holds no keys; add at least one row below the header", name);
  return keys;
}

CameraPath readCameraPath(const std::filesystem::path& file) {
  return CameraPath(parseCameraPath(readTextFile(file), file.string()));
}

std::string cameraPathCsv(const std::vector<CameraKey>& keys) {
  std::string text(kHeader);
  text += '\n';
  for (const CameraKey& key : keys) {
    const glm::vec3& p = key.position;
    const glm::vec3& t = key.target;
    // The shortest digits that read back as the same numbers.
    text += fmt::format("{},{},{},{},{},{},{},{},{}\n", key.time, p.x, p.y, p.z, t.x, t.y, t.z,
                        static_cast<double>(key.verticalFov) * kDegrees, key.cut ? 1 : 0);
  }
  return text;
}

}  // namespace macula::scene
