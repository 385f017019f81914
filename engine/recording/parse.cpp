#include "engine/recording/parse.h"

#include <array>
#include <glm/gtc/constants.hpp>
#include <nlohmann/json.hpp>
#include <vector>

#include "engine/core/error.h"
#include "engine/recording/text.h"
#include "engine/settings/typed_reader.h"

namespace macula::recording {
namespace {

using settings::Range;
using settings::TypedReader;

/// A frame takes some 600 bytes, with every setting changed about 2,500.
constexpr std::size_t kLongestLine = 1U << 20U;

/// What to do about a text that is damaged.
constexpr const char* kAdvice = "restore the file as it was recorded";

std::string parseSha256(TypedReader& reader, const std::string& key) {
  const std::string hex = reader.textOrNull(key);
  constexpr std::size_t kDigits = 64;
  const bool good =
      hex.size() == kDigits && hex.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (!good && !hex.empty()) reader.fail(key, "is no SHA-256 of 64 hex digits");
  return hex;
}

SceneSource parseScene(TypedReader reader) {
  SceneSource scene;
  scene.name = reader.get<std::string>("name");
  scene.file = reader.textOrNull("file");
  scene.sha256 = parseSha256(reader, "sha256");
  if (scene.file.empty() != scene.sha256.empty()) reader.fail("sha256", "and 'file' go together");
  reader.finish();
  return scene;
}

Settings parseSettings(TypedReader reader) {
  Settings settings;
  for (const std::string& key : reader.keys()) {
    settings.emplace_back(key, reader.get<settings::Value>(key));
  }
  return settings;
}

scene::Camera parseCamera(TypedReader reader) {
  scene::Camera camera;
  camera.position = reader.get<glm::vec3>("position");
  camera.target = reader.get<glm::vec3>("target");
  camera.up = reader.get<glm::vec3>("up");
  constexpr Range kPositive{.min = 0.0, .minExclusive = true};
  camera.verticalFov = reader.get<float>(
      "vfov", {.min = 0.0, .minExclusive = true, .max = glm::pi<float>(), .maxExclusive = true},
      "radians");
  camera.nearPlane = reader.get<float>("near", kPositive, "m");
  camera.farPlane = reader.get<float>("far", kPositive, "m");
  // Rounding to float may have crossed a bound.
  if (!(camera.verticalFov > 0.0F && camera.verticalFov < glm::pi<float>())) {
    reader.fail("vfov", "is no angle between 0 and pi");
  }
  if (!(camera.nearPlane > 0.0F)) reader.fail("near", "is not > 0");
  if (!(camera.farPlane > camera.nearPlane)) reader.fail("far", "is not beyond 'near'");
  reader.finish();
  return camera;
}

gaze::PointOfInterest parseGaze(TypedReader reader) {
  constexpr std::array kStates{gaze::GazeState::Ok,   gaze::GazeState::Held,
                               gaze::GazeState::Lost, gaze::GazeState::Easing,
                               gaze::GazeState::None, gaze::GazeState::Ended};
  std::vector<std::string> names;
  for (const gaze::GazeState state : kStates) names.emplace_back(gaze::stateName(state));
  constexpr Range kShare{.min = 0.0, .max = 1.0};
  gaze::PointOfInterest gaze;
  gaze.position.x = reader.get<float>("x", kShare, "widths");
  gaze.position.y = reader.get<float>("y", kShare, "heights");
  gaze.raw.x = reader.anyFloat("raw_x");
  gaze.raw.y = reader.anyFloat("raw_y");
  gaze.state = kStates.at(reader.getChoice("state", names));
  gaze.ageSeconds = reader.anyFloat("age_s");
  if (!(gaze.ageSeconds >= 0.0F)) reader.fail("age_s", "is no time since then");
  gaze.radius = reader.get<float>("radius", {.min = 0.0});
  gaze.saccade = reader.get<bool>("saccade");
  reader.finish();
  return gaze;
}

}  // namespace

Session parseSession(std::string_view text, const std::string& file) {
  const nlohmann::json json = settings::parseJsonObject(text, file, kAdvice);
  TypedReader reader(settings::DataNode(json), file, kAdvice);
  Session session;
  const auto schema = reader.get<std::int64_t>("schema");
  session.commit = reader.textOrNull("commit");
  if (schema != kSchema) {
    failInput(
        "{}: schema {} is not known, only {}; replay it with the program that recorded it, {}",
        file, schema, kSchema, oneLine(session.commit));
  }
  session.started = reader.textOrNull("started");
  session.scene = parseScene(reader.getTable("scene"));
  session.environmentSha256 = parseSha256(reader, "environment_sha256");
  TypedReader gl = reader.getTable("gl");
  session.renderer = gl.textOrNull("renderer");
  session.version = gl.textOrNull("version");
  gl.finish();
  TypedReader scale = reader.getTable("content_scale");
  session.contentScale = {scale.get<float>("x"), scale.get<float>("y")};
  scale.finish();
  session.settings = parseSettings(reader.getTable("settings"));
  TypedReader options = reader.getTable("options");
  for (const std::string& key : options.keys()) {
    session.options.emplace_back(key, options.textOrNull(key));
  }
  reader.finish();
  return session;
}

Frame parseFrame(std::string_view text, const std::string& file, std::size_t line) {
  const std::string place = fmt::format("{}: line {}", file, line);
  const nlohmann::json json = settings::parseJsonObject(text, place, kAdvice);
  TypedReader reader(settings::DataNode(json), place, kAdvice);
  Frame frame;
  constexpr Range kCount{.min = 0.0};
  constexpr Range kPixels{.min = 1.0, .max = kMostPixels};
  frame.index = static_cast<std::uint64_t>(reader.get<std::int64_t>("index", kCount));
  frame.timeSeconds = reader.get<double>("time_s", {}, "s");
  frame.size.x = reader.get<int>("width", kPixels, "pixels");
  frame.size.y = reader.get<int>("height", kPixels, "pixels");
  std::vector<std::string> resets;
  for (const Reset reset : {Reset::None, Reset::History, Reset::Scene, Reset::Restart}) {
    resets.emplace_back(resetName(reset));
  }
  frame.reset = static_cast<Reset>(reader.getChoice("reset", resets));
  frame.cut = reader.get<bool>("cut");
  if (reader.has("scene")) frame.scene = parseScene(reader.getTable("scene"));
  frame.settings = parseSettings(reader.table("settings"));
  frame.camera = parseCamera(reader.getTable("camera"));
  frame.gaze = parseGaze(reader.getTable("gaze"));
  frame.r = reader.get<double>("r", {.min = 1.0});
  TypedReader controls = reader.table("levers");
  for (const std::string& key : controls.keys()) {
    frame.controls.emplace_back(key, controls.anyNumber(key));
  }
  if (const auto unrecorded = reader.find<std::int64_t>("unrecorded", kCount, "frames")) {
    frame.unrecorded = static_cast<std::uint64_t>(*unrecorded);
  }
  if (reader.has("image_sha256")) {
    frame.imageSha256 = parseSha256(reader, "image_sha256");
    if (frame.imageSha256.empty()) reader.fail("image_sha256", "is empty; leave it out");
  }
  reader.finish();
  return frame;
}

Recording parseFrames(std::istream& in, const std::string& file) {
  Recording recording;
  std::string line;
  while (std::getline(in, line)) {
    if (in.eof()) {  // the line has no end
      ++recording.truncatedLines;
      break;
    }
    const std::size_t number = recording.frames.size() + 1;
    if (line.size() > kLongestLine) {
      failInput("{}: line {}: {} bytes are no frame; restore the file as it was recorded", file,
                number, line.size());
    }
    Frame frame = parseFrame(line, file, number);
    if (frame.index + 1 != number) {
      failInput("{}: line {}: frame {} stands where {} should; restore the file as it was recorded",
                file, number, frame.index, number - 1);
    }
    if (number == 1 && frame.reset != Reset::Restart) {
      failInput(
          "{}: line 1: the first frame's 'reset' is not \"restart\"; a recording begins with "
          "a new renderer",
          file);
    }
    const glm::ivec2 before = number == 1 ? frame.size : recording.frames.back().size;
    if (frame.size != before && frame.reset == Reset::None) {
      failInput("{}: line {}: the size changes without a 'reset'; a new size gives up history",
                file, number);
    }
    recording.frames.push_back(std::move(frame));
  }
  return recording;
}

}  // namespace macula::recording
