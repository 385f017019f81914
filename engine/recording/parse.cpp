#include "engine/recording/parse.h"

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <vector>

#include "engine/core/error.h"
#include "engine/recording/json_fields.h"
#include "engine/recording/text.h"

namespace macula::recording {
namespace {

/// A frame takes some 600 bytes, with every setting changed about 2,500.
constexpr std::size_t kLongestLine = 1U << 20U;

std::string parseSha256(Fields& fields, const std::string& key, bool mayBeNull) {
  const std::string hex = mayBeNull ? fields.textOrNull(key) : fields.text(key);
  constexpr std::size_t kDigits = 64;
  const bool good =
      hex.size() == kDigits && hex.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (!good && !(mayBeNull && hex.empty())) fields.fail(key, "is no SHA-256 of 64 hex digits");
  return hex;
}

SceneSource parseScene(Fields fields) {
  SceneSource scene;
  scene.name = fields.text("name");
  if (scene.name.empty()) fields.fail("name", "is empty");
  scene.file = fields.textOrNull("file");
  scene.sha256 = parseSha256(fields, "sha256", true);
  if (scene.file.empty() != scene.sha256.empty()) fields.fail("sha256", "and 'file' go together");
  fields.refuseOthers();
  return scene;
}

Settings parseSettings(Fields fields) {
  Settings settings;
  for (const std::string& key : fields.keys()) settings.emplace_back(key, fields.setting(key));
  return settings;
}

scene::Camera parseCamera(Fields fields) {
  scene::Camera camera;
  camera.position = fields.vector("position");
  camera.target = fields.vector("target");
  camera.up = fields.vector("up");
  camera.verticalFov = fields.single("vfov");
  camera.nearPlane = fields.single("near");
  camera.farPlane = fields.single("far");
  if (!(camera.verticalFov > 0.0F && camera.verticalFov < glm::pi<float>())) {
    fields.fail("vfov", "is no angle between 0 and pi");
  }
  if (!(camera.nearPlane > 0.0F)) fields.fail("near", "is not > 0");
  if (!(camera.farPlane > camera.nearPlane && camera.farPlane < HUGE_VALF)) {
    fields.fail("far", "is not beyond 'near'");
  }
  fields.refuseOthers();
  return camera;
}

gaze::PointOfInterest parseGaze(Fields fields) {
  constexpr std::array kStates{gaze::GazeState::Ok,   gaze::GazeState::Held,
                               gaze::GazeState::Lost, gaze::GazeState::Easing,
                               gaze::GazeState::None, gaze::GazeState::Ended};
  std::vector<std::string_view> names;
  for (const gaze::GazeState state : kStates) names.push_back(gaze::stateName(state));
  gaze::PointOfInterest gaze;
  gaze.position.x = fields.singleIn("x", 0.0F, 1.0F);
  gaze.position.y = fields.singleIn("y", 0.0F, 1.0F);
  gaze.raw.x = fields.single("raw_x");
  gaze.raw.y = fields.single("raw_y");
  gaze.state = kStates.at(fields.choice("state", names));
  gaze.ageSeconds = fields.single("age_s");
  if (!(gaze.ageSeconds >= 0.0F)) fields.fail("age_s", "is no time since then");
  gaze.radius = fields.singleIn("radius", 0.0F, std::numeric_limits<float>::max());
  gaze.saccade = fields.flag("saccade");
  fields.refuseOthers();
  return gaze;
}

}  // namespace

Session parseSession(std::string_view text, const std::string& file) {
  const Place place{.file = file};
  const nlohmann::json json = parseObject(text, place);
  Fields fields(json, "", place);
  Session session;
  const std::uint64_t schema = fields.whole("schema");
  session.commit = fields.text("commit");
  if (schema != kSchema) {
    failInput(
        "{}: schema {} is not known, only {}; replay it with the program that recorded it, {}",
        file, schema, kSchema, oneLine(session.commit));
  }
  session.started = fields.text("started");
  session.scene = parseScene(fields.object("scene"));
  session.environmentSha256 = parseSha256(fields, "environment_sha256", true);
  Fields gl = fields.object("gl");
  session.renderer = gl.text("renderer");
  session.version = gl.text("version");
  gl.refuseOthers();
  Fields scale = fields.object("content_scale");
  session.contentScale = {scale.single("x"), scale.single("y")};
  scale.refuseOthers();
  session.settings = parseSettings(fields.object("settings"));
  Fields options = fields.object("options");
  for (const std::string& key : options.keys()) {
    session.options.emplace_back(key, options.text(key));
  }
  fields.refuseOthers();
  return session;
}

Frame parseFrame(std::string_view text, const std::string& file, std::size_t line) {
  const Place place{.file = file, .line = line};
  const nlohmann::json json = parseObject(text, place);
  Fields fields(json, "", place);
  Frame frame;
  frame.index = fields.whole("index");
  frame.timeSeconds = fields.finite("time_s");
  frame.size.x = static_cast<int>(fields.whole("width", kMostPixels));
  frame.size.y = static_cast<int>(fields.whole("height", kMostPixels));
  if (frame.size.x == 0 || frame.size.y == 0) fields.fail("width", "or 'height' is 0");
  frame.reset = static_cast<Reset>(
      fields.choice("reset", {resetName(Reset::None), resetName(Reset::History),
                              resetName(Reset::Scene), resetName(Reset::Restart)}));
  frame.cut = fields.flag("cut");
  if (fields.has("scene")) frame.scene = parseScene(fields.object("scene"));
  if (fields.has("settings")) frame.settings = parseSettings(fields.object("settings"));
  frame.camera = parseCamera(fields.object("camera"));
  frame.gaze = parseGaze(fields.object("gaze"));
  frame.r = fields.finite("r");
  if (frame.r < 1.0) fields.fail("r", "is below 1");
  if (fields.has("levers")) {
    Fields levers = fields.object("levers");
    for (const std::string& key : levers.keys()) {
      frame.levers.emplace_back(key, levers.number(key));
    }
  }
  if (fields.has("unrecorded")) frame.unrecorded = fields.whole("unrecorded");
  if (fields.has("image_sha256")) frame.imageSha256 = parseSha256(fields, "image_sha256", false);
  fields.refuseOthers();
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
