#include "engine/scene/gltf_materials.h"

#include <algorithm>
#include <cmath>

#include "engine/scene/gltf_extras.h"

namespace macula::scene::gltf {
namespace {

Sampler::Wrap wrapOf(int mode) {
  switch (mode) {
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
      return Sampler::Wrap::ClampToEdge;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
      return Sampler::Wrap::MirroredRepeat;
    default:
      return Sampler::Wrap::Repeat;
  }
}

Sampler samplerOf(const tinygltf::Sampler& source) {
  Sampler sampler;
  sampler.wrapS = wrapOf(source.wrapS);
  sampler.wrapT = wrapOf(source.wrapT);
  sampler.nearest = source.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
  // Without a filter the choice is ours: mip chains, as Sampler's default.
  sampler.mipmaps = source.minFilter != TINYGLTF_TEXTURE_FILTER_NEAREST &&
                    source.minFilter != TINYGLTF_TEXTURE_FILTER_LINEAR;
  return sampler;
}

float limited(double value, float least, float most) {
  return static_cast<float>(
      std::clamp(value, static_cast<double>(least), static_cast<double>(most)));
}

constexpr float kMostRadiance = 65504.0F;  // the largest number of the half-float targets

const tinygltf::Value* extensionOf(const tinygltf::Material& material, const char* name) {
  const auto found = material.extensions.find(name);
  return found == material.extensions.end() ? nullptr : &found->second;
}

double numberOf(const tinygltf::Value& object, const char* key, double otherwise) {
  if (!object.Has(key)) return otherwise;
  const tinygltf::Value& value = object.Get(std::string(key));
  return value.IsNumber() ? value.GetNumberAsDouble() : otherwise;
}

class MaterialReader {
 public:
  MaterialReader(Document& document, const GltfLimits& limits, Scene& scene)
      : document_(document), decoder_(document, limits), scene_(scene) {
    // White, one pixel: stands for images that nothing reads or that cannot be decoded.
    for (const ImageSource& source : document.images) {
      scene.images.push_back({source.name, 1, 1, {255, 255, 255, 255}});
    }
    states_.resize(document.images.size(), State::Unread);
  }

  Material read(std::size_t index);

 private:
  enum class State : std::uint8_t { Unread, Decoded, Failed };

  // Info is one of tinygltf's three kinds of texture reference.
  template <typename Info>
  TextureRef texture(const Info& info);
  std::int32_t imageOf(int texture);
  void readTransmission(const tinygltf::Material& source, Material& material);
  void readVeins(const tinygltf::Material& source, Material& material);

  Document& document_;
  ImageDecoder decoder_;
  Scene& scene_;
  std::vector<State> states_;
  std::string place_;
  int veined_ = 0;  ///< materials with veins so far
};

// The scene's image of a texture, decoded on first use; kNone where it cannot be drawn.
std::int32_t MaterialReader::imageOf(int texture) {
  const int image = document_.model.textures[static_cast<std::size_t>(texture)].source;
  if (image == kNone) {
    document_.warn(fmt::format("texture {}", texture), "not drawn: it has no PNG or JPEG image");
    return kNone;
  }
  if (image < 0 || static_cast<std::size_t>(image) >= states_.size()) {
    document_.fail(fmt::format("texture {}", texture),
                   "names image {} of {}; export the file again", image, states_.size());
  }
  const auto i = static_cast<std::size_t>(image);
  if (states_[i] == State::Unread) {
    auto decoded = decoder_.decode(i);
    states_[i] = decoded ? State::Decoded : State::Failed;
    if (decoded) scene_.images[i] = std::move(*decoded);
  }
  return states_[i] == State::Decoded ? image : kNone;
}

template <typename Info>
TextureRef MaterialReader::texture(const Info& info) {
  TextureRef ref;
  if (info.index == kNone) return ref;
  const auto& model = document_.model;
  if (info.index < 0 || static_cast<std::size_t>(info.index) >= model.textures.size()) {
    document_.fail(place_, "names texture {} of {}; export the file again", info.index,
                   model.textures.size());
  }
  const int sampler = model.textures[static_cast<std::size_t>(info.index)].sampler;
  if (sampler != kNone) {
    if (sampler < 0 || static_cast<std::size_t>(sampler) >= model.samplers.size()) {
      document_.fail(fmt::format("texture {}", info.index),
                     "names sampler {} of {}; export the file again", sampler,
                     model.samplers.size());
    }
    ref.sampler = samplerOf(model.samplers[static_cast<std::size_t>(sampler)]);
  }
  ref.uvSet = info.texCoord;
  if (info.texCoord != 0 && info.texCoord != 1) {
    document_.warn(place_, "texture coordinates {} are not read, set 0 is used", info.texCoord);
    ref.uvSet = 0;
  }
  if (info.extensions.contains("KHR_texture_transform")) {
    document_.warn(place_, "KHR_texture_transform is not applied");
    auto& unsupported = scene_.unsupportedExtensions;
    if (std::find(unsupported.begin(), unsupported.end(), "KHR_texture_transform") ==
        unsupported.end()) {
      unsupported.emplace_back("KHR_texture_transform");  // used without being declared
    }
  }
  ref.image = imageOf(info.index);
  return ref;
}

void MaterialReader::readTransmission(const tinygltf::Material& source, Material& material) {
  if (const auto* transmission = extensionOf(source, "KHR_materials_transmission")) {
    material.transmission = limited(numberOf(*transmission, "transmissionFactor", 0.0), 0.0F, 1.0F);
    if (transmission->Has("transmissionTexture")) {
      document_.warn(place_, "its transmission texture is not read, only the factor");
    }
  }
  if (const auto* volume = extensionOf(source, "KHR_materials_volume")) {
    material.thickness = limited(numberOf(*volume, "thicknessFactor", 0.0), 0.0F, kMostRadiance);
    material.attenuationDistance =
        limited(numberOf(*volume, "attenuationDistance", 0.0), 0.0F, kMostRadiance);
    if (volume->Has("attenuationColor")) {
      const tinygltf::Value& color = volume->Get(std::string("attenuationColor"));
      for (int c = 0; c < 3 && color.IsArray() && color.ArrayLen() == 3; ++c) {
        if (!color.Get(c).IsNumber()) continue;
        material.attenuationColor[c] = limited(color.Get(c).GetNumberAsDouble(), 0.0F, 1.0F);
      }
    }
    if (volume->Has("thicknessTexture")) {
      document_.warn(place_, "its thickness texture is not read, only the factor");
    }
  }
}

void MaterialReader::readVeins(const tinygltf::Material& source, Material& material) {
  const Veins veins = veinsOf(source);
  if (!veins.any()) return;
  if (material.isTransparent()) {
    document_.warn(place_, "its veins are not drawn, because it is transparent");
  } else if (veined_ == kMostVeins) {
    document_.warn(place_, "its veins are not drawn, because {} materials before it have some",
                   kMostVeins);
  } else {
    material.veins = veins;
    ++veined_;
  }
}

Material MaterialReader::read(std::size_t index) {
  const tinygltf::Material& source = document_.model.materials[index];
  place_ = source.name.empty() ? fmt::format("material {}", index)
                               : fmt::format("material {} ({})", index, source.name);
  const auto& pbr = source.pbrMetallicRoughness;
  Material material;
  material.name = source.name;
  for (int c = 0; c < 4 && pbr.baseColorFactor.size() == 4; ++c) {
    material.baseColor[c] = limited(pbr.baseColorFactor[static_cast<std::size_t>(c)], 0.0F, 1.0F);
  }
  material.metallic = limited(pbr.metallicFactor, 0.0F, 1.0F);
  material.roughness = limited(pbr.roughnessFactor, 0.0F, 1.0F);
  double strength = 1.0;
  if (const auto* emissive = extensionOf(source, "KHR_materials_emissive_strength")) {
    strength = numberOf(*emissive, "emissiveStrength", 1.0);
  }
  for (int c = 0; c < 3 && source.emissiveFactor.size() == 3; ++c) {
    material.emissive[c] =
        limited(source.emissiveFactor[static_cast<std::size_t>(c)] * strength, 0.0F, kMostRadiance);
  }
  material.normalScale = limited(source.normalTexture.scale, -kMostRadiance, kMostRadiance);
  material.occlusionStrength = limited(source.occlusionTexture.strength, 0.0F, 1.0F);
  if (source.alphaMode == "MASK") {
    material.alphaMode = AlphaMode::Mask;
  } else if (source.alphaMode == "BLEND") {
    material.alphaMode = AlphaMode::Blend;
  } else if (source.alphaMode != "OPAQUE") {
    document_.warn(place_, "unknown alphaMode '{}', drawn opaque", source.alphaMode);
  }
  material.alphaCutoff = limited(source.alphaCutoff, 0.0F, kMostRadiance);
  material.doubleSided = source.doubleSided;
  material.unlit = extensionOf(source, "KHR_materials_unlit") != nullptr;
  readTransmission(source, material);
  readVeins(source, material);
  material.baseColorTexture = texture(pbr.baseColorTexture);
  material.metallicRoughnessTexture = texture(pbr.metallicRoughnessTexture);
  material.normalTexture = texture(source.normalTexture);
  material.occlusionTexture = texture(source.occlusionTexture);
  material.emissiveTexture = texture(source.emissiveTexture);
  return material;
}

}  // namespace

void readMaterials(Document& document, const GltfLimits& limits, Scene& scene) {
  MaterialReader reader(document, limits, scene);
  for (std::size_t i = 0; i < document.model.materials.size(); ++i) {
    scene.materials.push_back(reader.read(i));
  }
}

}  // namespace macula::scene::gltf
