#include "engine/recording/text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/recording/number_text.h"

namespace macula::recording {
namespace {

// Lines of frames are put together here: the JSON library has one type of number, and would write
// the floats of a line as the doubles that they become (0.1F as 0.10000000149011612) and 1 as 1.0.
using Json = nlohmann::ordered_json;

void appendWhole(std::uint64_t number, std::string& text) {
  std::array<char, 24> digits;  // 20 are the most
  text.append(digits.data(),
              std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
}

/// With quotes. Bytes that are not UTF-8 become the replacement character.
void appendText(const std::string& value, std::string& text) {
  text += Json(value).dump(-1, ' ', false, Json::error_handler_t::replace);
}

void appendKey(std::string_view key, std::string& text) {
  text += text.back() == '{' ? "\"" : ",\"";
  text += key;
  text += "\":";
}

/// A key that is not one of this file's own words.
void appendName(const std::string& name, std::string& text) {
  if (text.back() != '{') text += ',';
  appendText(name, text);
  text += ':';
}

void appendVector(const glm::vec3& v, std::string& text) {
  text += '[';
  appendNumber(v.x, text);
  text += ',';
  appendNumber(v.y, text);
  text += ',';
  appendNumber(v.z, text);
  text += ']';
}

template <typename Number>
void appendEntry(std::string_view key, Number number, std::string& text) {
  appendKey(key, text);
  appendNumber(number, text);
}

struct AppendValue {
  std::string& text;
  void operator()(bool flag) const { text += flag ? "true" : "false"; }
  void operator()(std::int64_t number) const { text += std::to_string(number); }
  void operator()(double number) const { appendNumber(number, text); }
  void operator()(const std::string& value) const { appendText(value, text); }
  void operator()(const glm::vec3& colour) const { appendVector(colour, text); }
};

void appendSettings(const Settings& settings, std::string& text) {
  text += '{';
  for (const auto& [key, value] : settings) {
    appendName(key, text);
    std::visit(AppendValue{text}, value);
  }
  text += '}';
}

Json sceneJson(const SceneSource& scene) {
  Json json{{"name", scene.name}, {"file", nullptr}, {"sha256", nullptr}};
  if (!scene.file.empty()) json["file"] = scene.file;
  if (!scene.sha256.empty()) json["sha256"] = scene.sha256;
  return json;
}

std::string dumped(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

// A new field fails here until it is added to appendCamera() or appendGaze(), to
// parse.cpp and into the table of README.md: what is not recorded cannot be replayed.
static_assert(sizeof(scene::Camera) == sizeof(std::string) + 12 * sizeof(float));
static_assert(sizeof(gaze::PointOfInterest) == 8 * sizeof(float));

void appendCamera(const scene::Camera& camera, std::string& text) {
  text += '{';
  appendKey("position", text);
  appendVector(camera.position, text);
  appendKey("target", text);
  appendVector(camera.target, text);
  appendKey("up", text);
  appendVector(camera.up, text);
  appendEntry("vfov", camera.verticalFov, text);
  appendEntry("near", camera.nearPlane, text);
  appendEntry("far", camera.farPlane, text);
  text += '}';
}

void appendGaze(const gaze::PointOfInterest& gaze, std::string& text) {
  text += '{';
  appendEntry("x", gaze.position.x, text);
  appendEntry("y", gaze.position.y, text);
  appendEntry("raw_x", gaze.raw.x, text);
  appendEntry("raw_y", gaze.raw.y, text);
  appendKey("state", text);
  text += '"';
  text += gaze::stateName(gaze.state);
  text += '"';
  appendEntry("age_s", gaze.ageSeconds, text);
  appendEntry("radius", gaze.radius, text);
  appendKey("saccade", text);
  text += gaze.saccade ? "true" : "false";
  text += '}';
}

}  // namespace

std::string_view resetName(Reset reset) {
  constexpr std::array<std::string_view, 4> kNames{"none", "history", "scene", "restart"};
  return kNames.at(static_cast<std::size_t>(reset));
}

std::string sessionText(const Session& session) {
  std::string settings;
  appendSettings(session.settings, settings);
  Json json{{"schema", kSchema},
            {"commit", session.commit},
            {"started", session.started},
            {"scene", sceneJson(session.scene)},
            {"environment_sha256", nullptr},
            {"gl", {{"renderer", session.renderer}, {"version", session.version}}},
            {"content_scale", {{"x", session.contentScale.x}, {"y", session.contentScale.y}}},
            {"settings", Json::parse(settings)},
            {"options", Json::object()}};
  if (!session.environmentSha256.empty()) json["environment_sha256"] = session.environmentSha256;
  for (const auto& [name, value] : session.options) json["options"][name] = value;
  return dumped(json, 2) + "\n";
}

void appendFrameLine(const Frame& frame, std::string& line) {
  line += '{';
  appendKey("index", line);
  appendWhole(frame.index, line);
  appendEntry("time_s", frame.timeSeconds, line);
  appendKey("width", line);
  appendWhole(static_cast<std::uint64_t>(frame.size.x), line);
  appendKey("height", line);
  appendWhole(static_cast<std::uint64_t>(frame.size.y), line);
  appendKey("reset", line);
  line += '"';
  line += resetName(frame.reset);
  line += '"';
  appendKey("cut", line);
  line += frame.cut ? "true" : "false";
  if (!frame.scene.name.empty()) {
    appendKey("scene", line);
    line += dumped(sceneJson(frame.scene), -1);
  }
  if (!frame.settings.empty()) {
    appendKey("settings", line);
    appendSettings(frame.settings, line);
  }
  appendKey("camera", line);
  appendCamera(frame.camera, line);
  appendKey("gaze", line);
  appendGaze(frame.gaze, line);
  appendEntry("r", frame.r, line);
  if (!frame.controls.empty()) {
    appendKey("levers", line);
    line += '{';
    for (const auto& [name, value] : frame.controls) {
      appendName(name, line);
      appendNumber(value, line);
    }
    line += '}';
  }
  if (frame.unrecorded > 0) {
    appendKey("unrecorded", line);
    appendWhole(frame.unrecorded, line);
  }
  if (!frame.imageSha256.empty()) {
    appendKey("image_sha256", line);
    line += '"';
    line += frame.imageSha256;
    line += '"';
  }
  line += "}\n";
}

void appendGazeRow(const gaze::GazeSample& sample, std::string& text) {
  const bool placed = std::isfinite(sample.position.x) && std::isfinite(sample.position.y);
  appendNumber(sample.timeSeconds, text);
  text += ',';
  if (placed) appendNumber(sample.position.x, text);
  text += ',';
  if (placed) appendNumber(sample.position.y, text);
  text += placed && sample.valid ? ",1," : ",0,";
  if (sample.confidence) appendNumber(*sample.confidence, text);
  text += ',';
  if (sample.pupilMillimetres) appendNumber(*sample.pupilMillimetres, text);
  text += '\n';
}

}  // namespace macula::recording
