#include "engine/scene/glb_writer.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/scene/glb_buffer.h"

namespace macula::scene {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67;      // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004E4942;
constexpr std::uint32_t kContainerVersion = 2;
constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;

// The numbers are written as they lie in memory, and the format is little-endian.
static_assert(std::endian::native == std::endian::little);

GlbJson toJson(const glm::vec3& v) {
  return {v.x, v.y, v.z};
}

GlbJson toJson(const glm::mat4& m) {
  GlbJson values = GlbJson::array();
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) values.push_back(m[c][r]);
  }
  return values;
}

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
  GlbJson textureInfo(const TextureRef& ref);
  int samplerIndex(const Sampler& sampler);
  GlbJson material(const Material& source);
  void addPbr(const Material& source, GlbJson& out);
  void addMaterialExtensions(const Material& source, GlbJson& out);
  void addMeshesAndInstances();
  void addLights();
  void addCameras();
  void addNode(GlbJson node, const glm::mat4& transform) {
    if (transform != glm::mat4(1.0F)) node["matrix"] = toJson(transform);
    roots_.push_back(nodes_.size());
    nodes_.push_back(std::move(node));
  }
  [[nodiscard]] GlbJson document();

  const Scene& scene_;
  GlbBuffer buffer_;
  GlbJson nodes_ = GlbJson::array();
  GlbJson roots_ = GlbJson::array();
  GlbJson meshes_ = GlbJson::array();
  GlbJson materials_ = GlbJson::array();
  GlbJson samplers_ = GlbJson::array();
  GlbJson textures_ = GlbJson::array();
  GlbJson images_ = GlbJson::array();
  GlbJson lights_ = GlbJson::array();
  GlbJson cameras_ = GlbJson::array();
  std::map<std::pair<int, int>, std::size_t> textureOf_;  ///< (image, sampler) to texture
  std::set<std::string> extensions_;
};

int GlbWriter::samplerIndex(const Sampler& sampler) {
  const auto wrap = [](Sampler::Wrap w) {
    switch (w) {
      case Sampler::Wrap::ClampToEdge:
        return 33071;
      case Sampler::Wrap::MirroredRepeat:
        return 33648;
      default:
        return 10497;
    }
  };
  // GL_NEAREST, GL_LINEAR, GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_LINEAR
  const int magnify = sampler.nearest ? 9728 : 9729;
  const int minify = sampler.mipmaps ? (sampler.nearest ? 9984 : 9987) : magnify;
  const GlbJson entry{{"magFilter", magnify},
                      {"minFilter", minify},
                      {"wrapS", wrap(sampler.wrapS)},
                      {"wrapT", wrap(sampler.wrapT)}};
  const auto found = std::find(samplers_.begin(), samplers_.end(), entry);
  const auto index = static_cast<int>(found - samplers_.begin());
  if (found == samplers_.end()) samplers_.push_back(entry);
  return index;
}

GlbJson GlbWriter::textureInfo(const TextureRef& ref) {
  const int sampler = samplerIndex(ref.sampler);
  const auto [entry, isNew] = textureOf_.try_emplace({ref.image, sampler}, textures_.size());
  if (isNew) textures_.push_back({{"sampler", sampler}, {"source", ref.image}});
  GlbJson info{{"index", entry->second}};
  if (ref.uvSet != 0) info["texCoord"] = ref.uvSet;
  return info;
}

void GlbWriter::addPbr(const Material& source, GlbJson& out) {
  GlbJson pbr = GlbJson::object();
  const glm::vec4& c = source.baseColor;
  if (c != glm::vec4(1.0F)) pbr["baseColorFactor"] = {c.r, c.g, c.b, c.a};
  if (source.baseColorTexture.image != kNone) {
    pbr["baseColorTexture"] = textureInfo(source.baseColorTexture);
  }
  pbr["metallicFactor"] = source.metallic;
  pbr["roughnessFactor"] = source.roughness;
  if (source.metallicRoughnessTexture.image != kNone) {
    pbr["metallicRoughnessTexture"] = textureInfo(source.metallicRoughnessTexture);
  }
  out["pbrMetallicRoughness"] = std::move(pbr);
}

void GlbWriter::addMaterialExtensions(const Material& source, GlbJson& out) {
  const auto use = [&](const char* name, GlbJson value) {
    out["extensions"][name] = std::move(value);
    extensions_.insert(name);
  };
  if (source.unlit) use("KHR_materials_unlit", GlbJson::object());
  if (source.transmission > 0.0F) {
    use("KHR_materials_transmission", {{"transmissionFactor", source.transmission}});
  }
  if (source.thickness > 0.0F || source.attenuationDistance > 0.0F) {
    GlbJson volume{{"thicknessFactor", source.thickness},
                   {"attenuationColor", toJson(source.attenuationColor)}};
    if (source.attenuationDistance > 0.0F) {
      volume["attenuationDistance"] = source.attenuationDistance;
    }
    use("KHR_materials_volume", std::move(volume));
  }
  // emissiveFactor itself must stay within 0..1.
  const glm::vec3& e = source.emissive;
  const float strength = std::max({e.r, e.g, e.b, 1.0F});
  if (strength > 1.0F) {
    use("KHR_materials_emissive_strength", {{"emissiveStrength", strength}});
  }
  if (e != glm::vec3(0.0F)) out["emissiveFactor"] = toJson(e / strength);
}

GlbJson GlbWriter::material(const Material& source) {
  GlbJson out = GlbJson::object();
  if (!source.name.empty()) out["name"] = source.name;
  addPbr(source, out);
  if (source.normalTexture.image != kNone) {
    out["normalTexture"] = textureInfo(source.normalTexture);
    out["normalTexture"]["scale"] = source.normalScale;
  }
  if (source.occlusionTexture.image != kNone) {
    out["occlusionTexture"] = textureInfo(source.occlusionTexture);
    out["occlusionTexture"]["strength"] = source.occlusionStrength;
  }
  if (source.emissiveTexture.image != kNone) {
    out["emissiveTexture"] = textureInfo(source.emissiveTexture);
  }
  if (source.alphaMode == AlphaMode::Blend) out["alphaMode"] = "BLEND";
  if (source.alphaMode == AlphaMode::Mask) {
    out["alphaMode"] = "MASK";
    out["alphaCutoff"] = source.alphaCutoff;
  }
  if (source.doubleSided) out["doubleSided"] = true;
  addMaterialExtensions(source, out);
  if (source.veins.any()) {
    out["extras"]["macula_veins"] = {{"color", toJson(source.veins.color)},
                                     {"scale", source.veins.scale}};
  }
  return out;
}

void GlbWriter::addMeshesAndInstances() {
  std::map<std::uint32_t, std::size_t> meshOf;
  for (const Instance& instance : scene_.instances) {
    const Primitive& primitive = scene_.primitives[instance.primitive];
    if (primitive.indices.empty()) continue;  // glTF has no empty accessors
    const auto [entry, isNew] = meshOf.try_emplace(instance.primitive, meshes_.size());
    if (isNew) {
      const Material& m = scene_.materialOf(primitive);
      const bool bumps = m.normalTexture.image != kNone;
      const bool textured = bumps || m.baseColorTexture.image != kNone ||
                            m.metallicRoughnessTexture.image != kNone ||
                            m.occlusionTexture.image != kNone || m.emissiveTexture.image != kNone;
      GlbJson primitives = GlbJson::array();
      primitives.push_back(buffer_.addPrimitive(primitive, bumps, textured));
      meshes_.push_back({{"primitives", std::move(primitives)}});
    }
    GlbJson node{{"mesh", entry->second}};
    addNode(std::move(node), instance.transform);
  }
}

void GlbWriter::addLights() {
  for (const Light& light : scene_.lights) {
    GlbJson entry{{"color", toJson(light.color)}, {"intensity", light.intensity}};
    switch (light.type) {
      case LightType::Directional:
        entry["type"] = "directional";
        break;
      case LightType::Point:
        entry["type"] = "point";
        break;
      case LightType::Spot:
        entry["type"] = "spot";
        entry["spot"] = {{"innerConeAngle", light.innerConeAngle},
                         {"outerConeAngle", light.outerConeAngle}};
        break;
    }
    if (light.range > 0.0F) entry["range"] = light.range;
    if (light.castsShadow) entry["extras"]["macula_casts_shadow"] = true;
    if (light.shadowTaps != kUsualShadowTaps) {
      entry["extras"]["macula_shadow_taps"] = light.shadowTaps;
    }
    const glm::vec3 up = std::abs(light.direction.y) < 0.9F ? glm::vec3(0.0F, 1.0F, 0.0F)
                                                            : glm::vec3(1.0F, 0.0F, 0.0F);
    addNode({{"extensions", {{"KHR_lights_punctual", {{"light", lights_.size()}}}}}},
            frameOf(light.position, light.direction, up));
    lights_.push_back(std::move(entry));
    extensions_.insert("KHR_lights_punctual");
  }
}

void GlbWriter::addCameras() {
  for (const Camera& camera : scene_.cameras) {
    const glm::vec3 ahead = camera.target - camera.position;
    GlbJson node = GlbJson::object();
    GlbJson entry = GlbJson::object();
    if (!camera.name.empty()) {
      node["name"] = camera.name;
      entry["name"] = camera.name;
    }
    entry["type"] = "perspective";
    entry["perspective"] = {
        {"yfov", camera.verticalFov}, {"zfar", camera.farPlane}, {"znear", camera.nearPlane}};
    node["camera"] = cameras_.size();
    node["extras"] = {{"macula_target_distance", glm::length(ahead)}};
    addNode(std::move(node), frameOf(camera.position, ahead, camera.up));
    cameras_.push_back(std::move(entry));
  }
}

GlbJson GlbWriter::document() {
  GlbJson root;
  root["asset"] = {{"version", "2.0"}, {"generator", "Macula"}};
  if (!extensions_.empty()) root["extensionsUsed"] = extensions_;
  if (!lights_.empty()) root["extensions"]["KHR_lights_punctual"]["lights"] = lights_;
  GlbJson entry = GlbJson::object();
  if (!scene_.name.empty()) entry["name"] = scene_.name;
  if (scene_.ambient != glm::vec3(0.0F)) {
    entry["extras"]["macula_ambient"] = toJson(scene_.ambient);
  }
  if (scene_.occlusion.any()) {
    entry["extras"]["macula_occlusion"] = {{"radius", scene_.occlusion.radius},
                                           {"samples", scene_.occlusion.samples}};
  }
  // glTF forbids empty arrays.
  if (!roots_.empty()) entry["nodes"] = std::move(roots_);
  root["scene"] = 0;
  root["scenes"] = GlbJson::array({std::move(entry)});
  const auto put = [&](const char* name, GlbJson values) {
    if (!values.empty()) root[name] = std::move(values);
  };
  put("nodes", std::move(nodes_));
  put("cameras", std::move(cameras_));
  put("meshes", std::move(meshes_));
  put("materials", std::move(materials_));
  put("textures", std::move(textures_));
  put("samplers", std::move(samplers_));
  put("images", std::move(images_));
  put("accessors", buffer_.accessors());
  put("bufferViews", buffer_.views());
  if (!buffer_.bytes().empty()) {
    root["buffers"] = GlbJson::array({{{"byteLength", buffer_.bytes().size()}}});
  }
  return root;
}

std::string GlbWriter::write() {
  for (const Image& image : scene_.images) images_.push_back(buffer_.addImage(image));
  for (const Material& source : scene_.materials) materials_.push_back(material(source));
  addMeshesAndInstances();
  addLights();
  addCameras();

  // Names come from files and may hold any bytes; what is no UTF-8 is replaced.
  std::string json = document().dump(-1, ' ', false, GlbJson::error_handler_t::replace);
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string& binary = buffer_.bytes();
  const std::size_t paddedBinary = (binary.size() + 3) / 4 * 4;
  std::size_t total = kHeaderBytes + kChunkHeaderBytes + json.size();
  if (!binary.empty()) total += kChunkHeaderBytes + paddedBinary;
  if (total > std::numeric_limits<std::uint32_t>::max()) {
    failInput("the scene '{}' takes {} bytes, more than a .glb can hold (4 GiB); split it",
              scene_.name, total);
  }
  std::string file;
  file.reserve(total);
  const auto word = [&](std::size_t value) {
    const auto bits = static_cast<std::uint32_t>(value);
    file.append(reinterpret_cast<const char*>(&bits), sizeof(bits));
  };
  word(kMagic);
  word(kContainerVersion);
  word(total);
  word(json.size());
  word(kJsonChunk);
  file += json;
  if (!binary.empty()) {
    word(paddedBinary);
    word(kBinaryChunk);
    file += binary;
    file.resize(total, '\0');
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
