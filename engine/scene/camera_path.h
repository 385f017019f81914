// Where the camera is at each moment: an orbit, a fixed camera, or a recorded path.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "engine/scene/scene.h"

namespace macula::scene {

/// Vertical field of view of automatic orbits, radians (40 degrees).
inline constexpr float kOrbitFov = 0.6981317F;

/// Time of one automatic turn, seconds.
inline constexpr double kOrbitSeconds = 24.0;

/// One moment of a recorded path.
struct CameraKey {
  double time = 0.0;  ///< seconds, >= 0, increasing along a path
  glm::vec3 position{0.0F};
  glm::vec3 target{0.0F, 0.0F, -1.0F};  ///< apart from the position
  float verticalFov = 0.7853982F;       ///< radians
  bool cut = false;                     ///< the camera jumps to this key instead of moving there
};

/// A circle around a vertical axis, walked counter-clockwise seen from above.
struct CameraOrbit {
  Camera camera;            ///< field of view and planes; its position is ignored
  glm::vec3 center{0.0F};   ///< looked at
  float radius = 1.0F;      ///< metres, level
  float height = 0.0F;      ///< metres above the centre
  double startAngle = 0.0;  ///< radians; 0 is +z, a quarter turn is +x
};

/// A camera as a function of time.
class CameraPath {
 public:
  explicit CameraPath(const Camera& fixed) : source_(fixed) {}
  explicit CameraPath(const CameraOrbit& orbit) : source_(orbit) {}
  /// @param keys at least one, times increasing
  explicit CameraPath(std::vector<CameraKey> keys) : source_(std::move(keys)) {}

  /// The camera at a time in seconds. A recorded path is a Catmull-Rom spline through positions
  /// and targets between two cuts (Catmull & Rom 1974, as cubic Hermite segments whose velocity at
  /// a key is that between its neighbours, which also fits uneven times); it is held before its
  /// first and after its last key. The field of view changes linearly.
  [[nodiscard]] Camera at(double timeSeconds) const;

  /// Whether the path jumps between two moments: a cut lies in (previous, now], or time runs back
  /// along a recorded path.
  [[nodiscard]] bool cutAt(double previous, double now) const;

  /// Seconds until the path is held or repeats: the last key, one turn, 0 for a fixed camera.
  [[nodiscard]] double duration() const;

  /// Chooses near and far planes so that a recorded path sees all of `bounds` from everywhere.
  /// Leaves orbits and fixed cameras as they are; they bring their planes along.
  void fitPlanes(const Bounds& bounds);

 private:
  std::variant<Camera, CameraOrbit, std::vector<CameraKey>> source_;
  float nearPlane_ = Camera{}.nearPlane;  ///< of recorded paths
  float farPlane_ = Camera{}.farPlane;
};

/// A path that is played from its beginning on.
class PathPlayer {
 public:
  struct Moment {
    Camera camera;
    bool cut = false;  ///< the path has jumped since the moment before
  };

  explicit PathPlayer(const CameraPath& path) : path_(path) {}
  /// Plays to a time in seconds. Nothing has jumped at the first moment at time 0.
  [[nodiscard]] Moment moveTo(double timeSeconds);

  [[nodiscard]] const CameraPath& path() const { return path_; }
  [[nodiscard]] double time() const { return time_; }

 private:
  CameraPath path_;
  double time_ = 0.0;
};

/// An orbit that frames the scene: one turn in kOrbitSeconds, from 18 degrees above, beginning at a
/// three-quarter view of the front (+z). The distance is the least at which every vertex stays in
/// a square frame from all around.
///
/// A scene may say itself how it is best seen: where a camera is named "orbit", the path circles
/// around that camera's target at its distance and height, beginning at its position (an interior,
/// for example); where one is named "still", the path stays with that camera.
[[nodiscard]] CameraPath autoOrbit(const Scene& scene);

/// The camera that never moves.
[[nodiscard]] CameraPath fixedCamera(const Camera& camera);

/// Reads a path from a CSV file. Lines that begin with # and empty lines are skipped; the first
/// other line is the header `time_s,x,y,z,target_x,target_y,target_z,vfov_deg,cut`, of which
/// `cut` may be missing. Units: seconds, metres, degrees (0 < vfov_deg < 180); cut is 0 or 1.
/// @throws InputError naming file and line
[[nodiscard]] CameraPath readCameraPath(const std::filesystem::path& file);

/// The same from the text of a file. @param name stands for the file in messages
[[nodiscard]] std::vector<CameraKey> parseCameraPath(std::string_view text,
                                                     const std::string& name);

/// The CSV text of a path. Reading it back gives the same keys; angles to the last bit or two.
[[nodiscard]] std::string cameraPathCsv(const std::vector<CameraKey>& keys);

/// Whether history is worthless from one camera to the next: the view turned by more than 20
/// degrees, or the position moved by more than 5 % of the scene's radius.
/// @param sceneRadius metres, > 0
[[nodiscard]] bool isCameraCut(const Camera& a, const Camera& b, float sceneRadius);

}  // namespace macula::scene
