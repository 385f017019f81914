#include "engine/scene/camera_path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <utility>

namespace macula::scene {
namespace {

constexpr double kTurn = glm::two_pi<double>();
constexpr float kOrbitElevation = 0.3141593F;  // 18 degrees: sees tops without hiding fronts
constexpr double kOrbitStart = 0.4363323;      // 25 degrees: a three-quarter view
constexpr float kOrbitMargin = 1.06F;          // leaves a narrow border around the object
constexpr int kFramingAngles = 24;             // directions from which the fit is tried
// Scenes with more vertices are framed by an even selection of about this many.
constexpr std::size_t kFramingVertices = 1'000'000;
constexpr float kCutCosine = 0.9396926F;  // of 20 degrees
constexpr float kCutDistance = 0.05F;     // of the scene's radius
// Below, squares of lengths would leave 32-bit floats.
constexpr float kLeastOrbitRadius = 1e-15F;
constexpr float kPointRadius = 1e-3F;  // metres around a scene that is one point
// The near plane never comes nearer than this share of the far one: a finite range of depths.
constexpr float kLeastNearShare = 2e-4F;

/// Sight line of a view from `angle` around and kOrbitElevation up, towards the centre's outside.
glm::vec3 backOf(double angle) {
  const float level = std::cos(kOrbitElevation);
  return {level * static_cast<float>(std::sin(angle)), std::sin(kOrbitElevation),
          level * static_cast<float>(std::cos(angle))};
}

/// Least distance from `center` at which every vertex is inside a square frame from all around.
float framingDistance(const Scene& scene, const glm::vec3& center) {
  std::size_t vertices = 0;
  for (const Instance& i : scene.instances) {
    vertices += scene.primitives[i.primitive].positions.size();
  }
  const std::size_t stride = vertices / kFramingVertices + 1;
  const float tangent = std::tan(0.5F * kOrbitFov);
  struct Axes {
    glm::vec3 right, up, back;
  };
  std::vector<Axes> views;
  for (int i = 0; i < kFramingAngles; ++i) {
    const glm::vec3 back = backOf(kTurn * i / kFramingAngles);
    const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0.0F, 1.0F, 0.0F), back));
    views.push_back({right, glm::cross(back, right), back});
  }
  float distance = 0.0F;
  for (const Instance& instance : scene.instances) {
    const std::vector<glm::vec3>& positions = scene.primitives[instance.primitive].positions;
    for (std::size_t k = 0; k < positions.size(); k += stride) {
      const glm::vec3 p = glm::vec3(instance.transform * glm::vec4(positions[k], 1.0F)) - center;
      for (const Axes& view : views) {
        const float across =
            std::max(std::abs(glm::dot(p, view.right)), std::abs(glm::dot(p, view.up)));
        distance = std::max(distance, across / tangent + glm::dot(p, view.back));
      }
    }
  }
  return distance;
}

Camera orbitAt(const CameraOrbit& orbit, double time) {
  // Whole turns are taken off first, so that late times keep their precision.
  const double angle = orbit.startAngle + kTurn * std::fmod(time, kOrbitSeconds) / kOrbitSeconds;
  Camera camera = orbit.camera;
  camera.target = orbit.center;
  camera.position =
      orbit.center + glm::vec3(orbit.radius * static_cast<float>(std::sin(angle)), orbit.height,
                               orbit.radius * static_cast<float>(std::cos(angle)));
  return camera;
}

/// Velocity of a spline at key i; neighbours beyond a cut or an end do not count.
template <typename Member>
glm::dvec3 velocityAt(const std::vector<CameraKey>& keys, std::size_t i, Member member) {
  const std::size_t before = i > 0 && !keys[i].cut ? i - 1 : i;
  const std::size_t after = i + 1 < keys.size() && !keys[i + 1].cut ? i + 1 : i;
  if (before == after) return glm::dvec3(0.0);
  return (glm::dvec3(keys[after].*member) - glm::dvec3(keys[before].*member)) /
         (keys[after].time - keys[before].time);
}

/// Cubic Hermite segment from key i to key i + 1.
template <typename Member>
glm::vec3 splineAt(const std::vector<CameraKey>& keys, std::size_t i, double time, Member member) {
  const double span = keys[i + 1].time - keys[i].time;
  const double t = (time - keys[i].time) / span;
  const double t2 = t * t;
  const double t3 = t2 * t;
  return glm::vec3((2.0 * t3 - 3.0 * t2 + 1.0) * glm::dvec3(keys[i].*member) +
                   (t3 - 2.0 * t2 + t) * span * velocityAt(keys, i, member) +
                   (3.0 * t2 - 2.0 * t3) * glm::dvec3(keys[i + 1].*member) +
                   (t3 - t2) * span * velocityAt(keys, i + 1, member));
}

Camera cameraOf(const CameraKey& key) {
  Camera camera;
  camera.position = key.position;
  camera.target = key.target;
  camera.verticalFov = key.verticalFov;
  return camera;
}

Camera pathAt(const std::vector<CameraKey>& keys, double time) {
  const auto next = std::upper_bound(keys.begin(), keys.end(), time,
                                     [](double t, const CameraKey& key) { return t < key.time; });
  if (next == keys.begin()) return cameraOf(keys.front());
  const auto i = static_cast<std::size_t>(next - keys.begin()) - 1;
  Camera camera = cameraOf(keys[i]);
  if (next == keys.end() || next->cut) return camera;
  camera.position = splineAt(keys, i, time, &CameraKey::position);
  camera.target = splineAt(keys, i, time, &CameraKey::target);
  // Between keys that look past each other the two splines may meet, where no direction is left.
  if (camera.target == camera.position) camera.target = keys[i].target;
  if (camera.target == camera.position) camera.target.z -= 1.0F;
  const double t = (time - keys[i].time) / (next->time - keys[i].time);
  camera.verticalFov = glm::mix(camera.verticalFov, next->verticalFov, static_cast<float>(t));
  return camera;
}

CameraPath orbitLike(const Camera& named) {
  const glm::vec3 offset = named.position - named.target;
  CameraOrbit orbit;
  orbit.camera = named;
  orbit.center = named.target;
  orbit.radius = glm::length(glm::vec2(offset.x, offset.z));
  orbit.height = offset.y;
  orbit.startAngle = std::atan2(static_cast<double>(offset.x), static_cast<double>(offset.z));
  return CameraPath(orbit);
}

/// The axes right, up and back of a camera as columns.
glm::mat3 axesOf(const Camera& camera) {
  const glm::vec3 back = glm::normalize(camera.position - camera.target);
  const glm::vec3 right = glm::normalize(glm::cross(camera.up, back));
  return {right, glm::cross(back, right), back};
}

}  // namespace

Camera CameraPath::at(double timeSeconds) const {
  if (const auto* fixed = std::get_if<Camera>(&source_)) return *fixed;
  if (const auto* orbit = std::get_if<CameraOrbit>(&source_)) return orbitAt(*orbit, timeSeconds);
  Camera camera = pathAt(std::get<std::vector<CameraKey>>(source_), timeSeconds);
  camera.nearPlane = nearPlane_;
  camera.farPlane = farPlane_;
  return camera;
}

bool CameraPath::cutAt(double previous, double now) const {
  const auto* keys = std::get_if<std::vector<CameraKey>>(&source_);
  if (keys == nullptr) return false;
  if (now < previous) return true;
  return std::any_of(keys->begin(), keys->end(), [&](const CameraKey& key) {
    return key.cut && key.time > previous && key.time <= now;
  });
}

PathPlayer::Moment PathPlayer::moveTo(double timeSeconds) {
  const bool cut = path_.cutAt(time_, timeSeconds);
  time_ = timeSeconds;
  return {path_.at(timeSeconds), cut};
}

double CameraPath::duration() const {
  if (std::holds_alternative<Camera>(source_)) return 0.0;
  if (std::holds_alternative<CameraOrbit>(source_)) return kOrbitSeconds;
  return std::get<std::vector<CameraKey>>(source_).back().time;
}

void CameraPath::fitPlanes(const Bounds& bounds) {
  const auto* keys = std::get_if<std::vector<CameraKey>>(&source_);
  if (keys == nullptr || bounds.empty()) return;
  float farthest = 0.0F;
  for (const CameraKey& key : *keys) {
    farthest = std::max(farthest, glm::distance(key.position, bounds.center()));
  }
  // Twice the radius, because the spline swings out between its keys.
  farPlane_ = farthest + 2.0F * bounds.radius();
  nearPlane_ = std::max(0.004F * bounds.radius(), kLeastNearShare * farPlane_);
}

CameraPath autoOrbit(const Scene& scene) {
  for (const Camera& camera : scene.cameras) {
    if (camera.name == "still") return fixedCamera(camera);
    if (camera.name == "orbit") return orbitLike(camera);
  }
  const Bounds bounds = boundsOf(scene);
  // Everything is in radii, so that scenes of any size fill the frame alike. One of a single point,
  // or of none, still gets a frustum that is not empty.
  const float radius = bounds.radius() > kLeastOrbitRadius ? bounds.radius() : kPointRadius;
  CameraOrbit orbit;
  orbit.center = bounds.center();
  const float distance = kOrbitMargin * std::max(framingDistance(scene, orbit.center), radius);
  orbit.radius = distance * std::cos(kOrbitElevation);
  orbit.height = distance * std::sin(kOrbitElevation);
  orbit.startAngle = kOrbitStart;
  orbit.camera.name = "auto";
  orbit.camera.verticalFov = kOrbitFov;
  orbit.camera.farPlane = 1.01F * (distance + radius);
  orbit.camera.nearPlane =
      std::max(0.9F * (distance - radius), 10.0F * kLeastNearShare * orbit.camera.farPlane);
  return CameraPath(orbit);
}

CameraPath fixedCamera(const Camera& camera) {
  return CameraPath(camera);
}

bool isCameraCut(const Camera& a, const Camera& b, float sceneRadius) {
  if (glm::distance(a.position, b.position) > kCutDistance * sceneRadius) return true;
  // The angle of the rotation between two frames: trace = 1 + 2 cos(angle).
  const glm::mat3 turn = glm::transpose(axesOf(a)) * axesOf(b);
  const float trace = turn[0][0] + turn[1][1] + turn[2][2];
  return 0.5F * (trace - 1.0F) < kCutCosine;
}

}  // namespace macula::scene
