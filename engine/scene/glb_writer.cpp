#include "engine/scene/glb_writer.h"

#include <tiny_gltf.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/scene/glb_buffer.h"
#include "engine/scene/glb_materials.h"

namespace macula::scene {
namespace {

using tinygltf::Value;

/// Axes and position of something that looks along -z.
glm::mat4 frameOf(const glm::vec3& position, const glm::vec3& forward, const glm::vec3& upHint) {
  const glm::vec3 back = -glm::normalize(forward);
  const glm::vec3 right = glm::normalize(glm::cross(upHint, back));
  return {glm::vec4(right, 0.0F), glm::vec4(glm::cross(back, right), 0.0F), glm::vec4(back, 0.0F),
          glm::vec4(position, 1.0F)};
}

class GlbWriter {
 public:
  explicit GlbWriter(const Scene& scene) : scene_(scene) {}

  std::string write();

 private:
  void addMeshesAndInstances();
  void addLights();
  void addCameras();
  void addNode(tinygltf::Node node, const glm::mat4& transform);
  void addScene();

  const Scene& scene_;
  tinygltf::Model model_;
  GlbBuffer buffer_{model_};
  std::set<std::string> extensions_;
  GlbMaterials materials_{model_, extensions_};
  std::vector<int> roots_;
};

void GlbWriter::addNode(tinygltf::Node node, const glm::mat4& transform) {
  if (transform != glm::mat4(1.0F)) {
    for (int c = 0; c < 4; ++c) {
      for (int r = 0; r < 4; ++r) node.matrix.push_back(transform[c][r]);
    }
  }
  roots_.push_back(static_cast<int>(model_.nodes.size()));
  model_.nodes.push_back(std::move(node));
}

void GlbWriter::addMeshesAndInstances() {
  std::map<std::uint32_t, int> meshOf;
  for (const Instance& instance : scene_.instances) {
    const Primitive& primitive = scene_.primitives[instance.primitive];
    if (primitive.indices.empty()) continue;  // glTF has no empty accessors
    const auto [entry, isNew] =
        meshOf.try_emplace(instance.primitive, static_cast<int>(model_.meshes.size()));
    if (isNew) {
      const Material& m = scene_.materialOf(primitive);
      const bool bumps = m.normalTexture.image != kNone;
      const bool textured = bumps || m.baseColorTexture.image != kNone ||
                            m.metallicRoughnessTexture.image != kNone ||
                            m.occlusionTexture.image != kNone || m.emissiveTexture.image != kNone;
      model_.meshes.emplace_back().primitives = {buffer_.addPrimitive(primitive, bumps, textured)};
    }
    tinygltf::Node node;
    node.mesh = entry->second;
    addNode(std::move(node), instance.transform);
  }
}

void GlbWriter::addLights() {
  for (const Light& light : scene_.lights) {
    tinygltf::Light entry;
    entry.color = {light.color.r, light.color.g, light.color.b};
    entry.intensity = light.intensity;
    entry.range = light.range;
    switch (light.type) {
      case LightType::Directional:
        entry.type = "directional";
        break;
      case LightType::Point:
        entry.type = "point";
        break;
      case LightType::Spot:
        entry.type = "spot";
        entry.spot.innerConeAngle = light.innerConeAngle;
        entry.spot.outerConeAngle = light.outerConeAngle;
        break;
    }
    Value::Object extras;
    if (light.castsShadow) extras["macula_casts_shadow"] = Value(true);
    if (light.shadowTaps != kUsualShadowTaps)
      extras["macula_shadow_taps"] = Value(light.shadowTaps);
    if (!extras.empty()) entry.extras = Value(std::move(extras));
    const glm::vec3 up = std::abs(light.direction.y) < 0.9F ? glm::vec3(0.0F, 1.0F, 0.0F)
                                                            : glm::vec3(1.0F, 0.0F, 0.0F);
    constexpr const char* kExtension = "KHR_lights_punctual";
    tinygltf::Node node;
    node.extensions[kExtension] =
        Value(Value::Object{{"light", Value(static_cast<int>(model_.lights.size()))}});
    addNode(std::move(node), frameOf(light.position, light.direction, up));
    model_.lights.push_back(std::move(entry));
    extensions_.insert(kExtension);
  }
}

void GlbWriter::addCameras() {
  for (const Camera& camera : scene_.cameras) {
    const glm::vec3 ahead = camera.target - camera.position;
    tinygltf::Camera entry;
    entry.name = validName(camera.name);
    entry.type = "perspective";
    entry.perspective.yfov = camera.verticalFov;
    entry.perspective.zfar = camera.farPlane;
    entry.perspective.znear = camera.nearPlane;
    tinygltf::Node node;
    node.name = entry.name;
    node.camera = static_cast<int>(model_.cameras.size());
    node.extras = Value(Value::Object{{"macula_target_distance", toValue(glm::length(ahead))}});
    addNode(std::move(node), frameOf(camera.position, ahead, camera.up));
    model_.cameras.push_back(std::move(entry));
  }
}

void GlbWriter::addScene() {
  tinygltf::Scene& scene = model_.scenes.emplace_back();
  // The library writes null for a scene without members.
  scene.name = scene_.name.empty() ? "scene" : validName(scene_.name);
  scene.nodes = roots_;
  Value::Object extras;
  if (scene_.ambient != glm::vec3(0.0F)) extras["macula_ambient"] = toValue(scene_.ambient);
  if (scene_.occlusion.any()) {
    extras["macula_occlusion"] = Value(Value::Object{{"radius", toValue(scene_.occlusion.radius)},
                                                     {"samples", Value(scene_.occlusion.samples)}});
  }
  if (!extras.empty()) scene.extras = Value(std::move(extras));
  model_.defaultScene = 0;
}

std::string GlbWriter::write() {
  for (const Image& image : scene_.images) buffer_.addImage(image);
  for (const Material& source : scene_.materials) materials_.add(source);
  addMeshesAndInstances();
  addLights();
  addCameras();
  addScene();
  model_.asset.version = "2.0";
  model_.asset.generator = "Macula";
  model_.extensionsUsed.assign(extensions_.begin(), extensions_.end());

  std::ostringstream stream;
  constexpr bool kPretty = false;
  constexpr bool kBinary = true;
  tinygltf::TinyGLTF().WriteGltfSceneToStream(&model_, stream, kPretty, kBinary);
  std::string file = std::move(stream).str();
  if (file.size() > std::numeric_limits<std::uint32_t>::max()) {
    failInput("the scene '{}' takes {} bytes, more than a .glb can hold (4 GiB); split it",
              scene_.name, file.size());
  }
  return file;
}

}  // namespace

std::string glbBytes(const Scene& scene) {
  return GlbWriter(scene).write();
}

void writeGlb(const Scene& scene, const std::filesystem::path& file) {
  writeFileAtomically(file, std::string_view(glbBytes(scene)));
}

}  // namespace macula::scene
