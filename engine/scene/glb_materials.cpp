#include "engine/scene/glb_materials.h"

#include <algorithm>

#include "engine/scene/glb_buffer.h"

namespace macula::scene {
namespace {

int wrapOf(Sampler::Wrap wrap) {
  switch (wrap) {
    case Sampler::Wrap::ClampToEdge:
      return TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
    case Sampler::Wrap::MirroredRepeat:
      return TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT;
    default:
      return TINYGLTF_TEXTURE_WRAP_REPEAT;
  }
}

}  // namespace

tinygltf::Value toValue(float number) {
  return tinygltf::Value(static_cast<double>(number));
}

tinygltf::Value toValue(const glm::vec3& v) {
  return tinygltf::Value(tinygltf::Value::Array{toValue(v.x), toValue(v.y), toValue(v.z)});
}

int GlbMaterials::samplerIndex(const Sampler& sampler) {
  tinygltf::Sampler entry;
  entry.magFilter =
      sampler.nearest ? TINYGLTF_TEXTURE_FILTER_NEAREST : TINYGLTF_TEXTURE_FILTER_LINEAR;
  entry.minFilter = entry.magFilter;
  if (sampler.mipmaps) {
    entry.minFilter = sampler.nearest ? TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST
                                      : TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
  }
  entry.wrapS = wrapOf(sampler.wrapS);
  entry.wrapT = wrapOf(sampler.wrapT);
  const auto found = std::find(model_.samplers.begin(), model_.samplers.end(), entry);
  const auto index = static_cast<int>(found - model_.samplers.begin());
  if (found == model_.samplers.end()) model_.samplers.push_back(entry);
  return index;
}

template <typename Info>
void GlbMaterials::setTexture(const TextureRef& ref, Info& info) {
  if (ref.image == kNone) return;
  const int sampler = samplerIndex(ref.sampler);
  const auto [entry, isNew] =
      textureOf_.try_emplace({ref.image, sampler}, static_cast<int>(model_.textures.size()));
  if (isNew) {
    tinygltf::Texture& texture = model_.textures.emplace_back();
    texture.sampler = sampler;
    texture.source = ref.image;
  }
  info.index = entry->second;
  info.texCoord = ref.uvSet;
}

void GlbMaterials::addExtensions(const Material& source, tinygltf::Material& out) {
  using tinygltf::Value;
  const auto use = [&](const char* name, Value::Object members) {
    out.extensions[name] = Value(std::move(members));
    extensions_.insert(name);
  };
  if (source.unlit) use("KHR_materials_unlit", {});
  if (source.transmission > 0.0F) {
    use("KHR_materials_transmission", {{"transmissionFactor", toValue(source.transmission)}});
  }
  if (source.thickness > 0.0F || source.attenuationDistance > 0.0F) {
    Value::Object volume{{"thicknessFactor", toValue(source.thickness)},
                         {"attenuationColor", toValue(source.attenuationColor)}};
    if (source.attenuationDistance > 0.0F) {
      volume["attenuationDistance"] = toValue(source.attenuationDistance);
    }
    use("KHR_materials_volume", std::move(volume));
  }
  // emissiveFactor itself must stay within 0..1.
  const glm::vec3& e = source.emissive;
  const float strength = std::max({e.r, e.g, e.b, 1.0F});
  if (strength > 1.0F) {
    use("KHR_materials_emissive_strength", {{"emissiveStrength", toValue(strength)}});
  }
  const glm::vec3 factor = e / strength;
  out.emissiveFactor = {factor.r, factor.g, factor.b};
  if (source.veins.any()) {
    out.extras = Value(Value::Object{
        {"macula_veins", Value(Value::Object{{"color", toValue(source.veins.color)},
                                             {"scale", toValue(source.veins.scale)}})}});
  }
}

void GlbMaterials::add(const Material& source) {
  tinygltf::Material& out = model_.materials.emplace_back();
  out.name = validName(source.name);
  tinygltf::PbrMetallicRoughness& pbr = out.pbrMetallicRoughness;
  const glm::vec4& c = source.baseColor;
  pbr.baseColorFactor = {c.r, c.g, c.b, c.a};
  pbr.metallicFactor = source.metallic;
  pbr.roughnessFactor = source.roughness;
  setTexture(source.baseColorTexture, pbr.baseColorTexture);
  setTexture(source.metallicRoughnessTexture, pbr.metallicRoughnessTexture);
  setTexture(source.normalTexture, out.normalTexture);
  out.normalTexture.scale = source.normalScale;
  setTexture(source.occlusionTexture, out.occlusionTexture);
  out.occlusionTexture.strength = source.occlusionStrength;
  setTexture(source.emissiveTexture, out.emissiveTexture);
  if (source.alphaMode == AlphaMode::Blend) out.alphaMode = "BLEND";
  if (source.alphaMode == AlphaMode::Mask) {
    out.alphaMode = "MASK";
    out.alphaCutoff = source.alphaCutoff;
  }
  out.doubleSided = source.doubleSided;
  addExtensions(source, out);
}

}  // namespace macula::scene
