// A recording of a walk as plain data: the session, and what each frame was drawn from.
// The files that hold it are described in README.md of this folder.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <utility>
#include <vector>

#include "engine/gaze/point_of_interest.h"
#include "engine/scene/scene.h"
#include "engine/settings/value.h"

namespace macula::recording {

inline constexpr int kSchema = 1;

/// The files of a recording's folder.
inline constexpr const char* kSessionFile = "session.json";
inline constexpr const char* kFramesFile = "frames.jsonl";
inline constexpr const char* kGazeFile = "gaze_raw.csv";

/// Pixels a side that a frame may have; as much as `--size` takes.
inline constexpr int kMostPixels = 16384;

/// Settings by key, as the registry names them.
using Settings = std::vector<std::pair<std::string, settings::Value>>;

/// A scene, and the file that it came from.
struct SceneSource {
  std::string name;    ///< as the user named it: a procedural name or a path
  std::string file;    ///< absolute path; empty for a procedural scene
  std::string sha256;  ///< of the file, 64 hexadecimal digits; empty for a procedural scene
  bool operator==(const SceneSource&) const = default;
};

/// What holds from the first frame on.
struct Session {
  std::string commit;   ///< of the program that recorded
  std::string started;  ///< date and time of day, UTC, ISO 8601
  SceneSource scene;
  std::string environmentSha256;  ///< of the panorama of scene.environment; empty where none is set
  std::string renderer;           ///< GL_RENDERER
  std::string version;            ///< GL_VERSION
  glm::vec2 contentScale{1.0F};   ///< of the window: pixels a screen coordinate, x and y
  Settings settings;              ///< all of them, as they were before the first frame
  std::vector<std::pair<std::string, std::string>> options;  ///< of the command, by name
};

/// What was given up before a frame, from nothing to everything. Each includes those before it.
enum class Reset : std::uint8_t {
  None,
  History,  ///< what the last frame left for the next one: a new size, changed settings
  Scene,    ///< a scene was set: the layers counted so far
  Restart,  ///< everything: the frame is drawn as by a new renderer
};

/// What one frame was drawn from.
struct Frame {
  std::uint64_t index = 0;
  double timeSeconds = 0.0;   ///< since the session's start
  glm::ivec2 size{1};         ///< pixels of the image
  Reset reset = Reset::None;  ///< before the frame
  bool cut = false;           ///< the frame was drawn as one after a camera cut
  SceneSource scene;          ///< set before the frame; an empty name where it stayed the same
  Settings settings;          ///< that changed since the last frame
  scene::Camera camera;       ///< its name is not kept
  gaze::PointOfInterest gaze;
  double r = 1.0;  ///< width of the image / width of the shaded
  std::vector<std::pair<std::string, double>> controls;  ///< that a controller set, beside r
  std::uint64_t unrecorded = 0;  ///< frames that the renderer drew since the last recorded one
  std::string imageSha256;  ///< of the RGB8 pixels, rows from the top; empty where not asked for
};

struct Recording {
  Session session;
  std::vector<Frame> frames;
  std::size_t truncatedLines = 0;  ///< 1 where the last line was cut off; it is no frame
};

}  // namespace macula::recording
