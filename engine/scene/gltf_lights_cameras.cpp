// Lights and cameras of the nodes; declared in gltf_nodes.h.
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "engine/scene/gltf_extras.h"
#include "engine/scene/gltf_nodes.h"

namespace macula::scene::gltf {
namespace {

// Behind the farthest corner, so that rounding cuts nothing off.
constexpr float kFarMargin = 1.01F;
// A far plane must lie behind the near one even where the scene does not.
constexpr float kLeastFarOverNear = 10.0F;

// Direction of an axis of a node, unit length; zero where the node has no extent along it.
glm::vec3 axisOf(const glm::mat4& world, int axis, float sign) {
  const glm::dvec3 v(world[axis]);
  const double length = std::sqrt(glm::dot(v, v));
  return length > 0.0 ? glm::vec3(v / length * static_cast<double>(sign)) : glm::vec3(0.0F);
}

// A number of the file as a float of at least `least`.
float atLeast(double value, float least) {
  const double limited = std::min(value, static_cast<double>(kMaxCoordinate));
  return std::max(static_cast<float>(limited), least);
}

std::int32_t lightIndexOf(const tinygltf::Node& node) {
  const auto found = node.extensions.find("KHR_lights_punctual");
  if (found == node.extensions.end() || !found->second.Has("light")) return kNone;
  const tinygltf::Value& index = found->second.Get("light");
  return index.IsInt() ? index.GetNumberAsInt() : kNone;
}

}  // namespace

void addLights(Document& document, const NodeTree& tree, Scene& scene) {
  for (const std::int32_t node : tree.drawn) {
    const auto i = static_cast<std::size_t>(node);
    const std::int32_t index = lightIndexOf(document.model.nodes[i]);
    if (index == kNone) continue;
    const std::string place = fmt::format("node {}", node);
    if (index < 0 || static_cast<std::size_t>(index) >= document.model.lights.size()) {
      document.fail(place, "names light {} of {}; export the file again", index,
                    document.model.lights.size());
    }
    const tinygltf::Light& source = document.model.lights[static_cast<std::size_t>(index)];
    Light light;
    if (source.type == "point") {
      light.type = LightType::Point;
    } else if (source.type == "spot") {
      light.type = LightType::Spot;
    } else if (source.type != "directional") {
      document.warn(place, "light {} has the unknown type '{}' and is left out", index,
                    source.type);
      continue;
    }
    const std::string& name = document.model.nodes[i].name;
    light.name = name.empty() ? place : name;
    light.position = glm::vec3(tree.world[i][3]);
    light.direction = axisOf(tree.world[i], 2, -1.0F);
    if (light.direction == glm::vec3(0.0F) && light.type != LightType::Point) {
      document.warn(place, "its light has no direction and is left out");
      continue;
    }
    for (int c = 0; c < 3 && source.color.size() == 3; ++c) {
      light.color[c] = atLeast(source.color[static_cast<std::size_t>(c)], 0.0F);
    }
    light.intensity = atLeast(source.intensity, 0.0F);
    light.range = atLeast(source.range, 0.0F);
    // KHR_lights_punctual: 0 <= inner < outer <= pi / 2.
    light.outerConeAngle =
        std::min(atLeast(source.spot.outerConeAngle, 0.0F), glm::half_pi<float>());
    light.innerConeAngle =
        std::min(atLeast(source.spot.innerConeAngle, 0.0F), light.outerConeAngle);
    light.castsShadow = light.type == LightType::Directional && castsShadow(source) &&
                        std::none_of(scene.lights.begin(), scene.lights.end(),
                                     [](const Light& other) { return other.castsShadow; });
    light.shadowTaps = shadowTaps(source);
    scene.lights.push_back(light);
  }
}

void addCameras(Document& document, const NodeTree& tree, Scene& scene) {
  const Bounds bounds = boundsOf(scene);
  for (const std::int32_t node : tree.drawn) {
    const auto i = static_cast<std::size_t>(node);
    const std::int32_t index = document.model.nodes[i].camera;
    if (index == kNone) continue;
    const std::string place = fmt::format("node {}", node);
    if (index < 0 || static_cast<std::size_t>(index) >= document.model.cameras.size()) {
      document.fail(place, "names camera {} of {}; export the file again", index,
                    document.model.cameras.size());
    }
    const tinygltf::Camera& source = document.model.cameras[static_cast<std::size_t>(index)];
    if (source.type != "perspective") {
      document.warn(fmt::format("camera {}", index), "is orthographic and left out");
      continue;
    }
    const glm::vec3 forward = axisOf(tree.world[i], 2, -1.0F);
    const glm::vec3 up = axisOf(tree.world[i], 1, 1.0F);
    const auto fov = static_cast<float>(source.perspective.yfov);
    const auto nearPlane = static_cast<float>(source.perspective.znear);
    if (glm::cross(forward, up) == glm::vec3(0.0F) || !(fov > 0.0F) || !(fov < glm::pi<float>()) ||
        !(nearPlane > 0.0F) || !(nearPlane < kMaxCoordinate)) {
      document.warn(fmt::format("camera {}", index), "has no usable frustum and is left out");
      continue;
    }
    Camera camera;
    camera.name = source.name.empty() ? document.model.nodes[i].name : source.name;
    camera.position = glm::vec3(tree.world[i][3]);
    // Far enough ahead to differ from the position after rounding.
    camera.target = camera.position + forward * std::max(1.0F, glm::length(camera.position));
    // A file of Macula's own says where the camera's target is: an orbit turns around it.
    const float ahead = targetDistance(document.model.nodes[i]);
    if (camera.position + forward * ahead != camera.position) {
      camera.target = camera.position + forward * ahead;
    }
    camera.up = up;
    camera.verticalFov = fov;
    camera.nearPlane = nearPlane;
    camera.farPlane = atLeast(source.perspective.zfar, 0.0F);
    if (!(camera.farPlane > nearPlane)) {
      const float reach = glm::length(bounds.center() - camera.position) + bounds.radius();
      camera.farPlane = std::max(reach * kFarMargin, nearPlane * kLeastFarOverNear);
    }
    scene.cameras.push_back(camera);
  }
}

}  // namespace macula::scene::gltf
