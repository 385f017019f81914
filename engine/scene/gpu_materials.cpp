// GpuScene: textures, materials, lights, environment.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <set>

#include "engine/scene/gpu_scene.h"
#include "shared/bindings.h"
#include "shared/scene_data.h"

namespace macula::scene {
namespace {

std::array<const TextureRef*, MATERIAL_TEXTURES> texturesOf(const Material& m) {
  return {&m.baseColorTexture, &m.metallicRoughnessTexture, &m.normalTexture, &m.occlusionTexture,
          &m.emissiveTexture};
}

bool isColor(std::size_t slot) {
  return slot == TEX_BASE_COLOR || slot == TEX_EMISSIVE;
}

gl::Texture upload(const Image& image, bool srgb) {
  const auto side = static_cast<unsigned>(std::max(image.width, image.height));
  gl::Texture texture(image.name.empty() ? "image" : image.name, srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8,
                      image.width, image.height, static_cast<int>(std::bit_width(side)));
  glTextureSubImage2D(texture.id(), 0, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE,
                      image.rgba.data());
  glGenerateTextureMipmap(texture.id());
  return texture;
}

GLint wrapMode(Sampler::Wrap wrap) {
  switch (wrap) {
    case Sampler::Wrap::Repeat:
      return GL_REPEAT;
    case Sampler::Wrap::MirroredRepeat:
      return GL_MIRRORED_REPEAT;
    case Sampler::Wrap::ClampToEdge:
      return GL_CLAMP_TO_EDGE;
  }
  return GL_REPEAT;
}

gl::SamplerId makeSampler(const Sampler& s) {
  GLuint id = 0;
  glCreateSamplers(1, &id);
  const GLint flat = s.nearest ? GL_NEAREST : GL_LINEAR;
  const GLint mipped = s.nearest ? GL_NEAREST_MIPMAP_NEAREST : GL_LINEAR_MIPMAP_LINEAR;
  glSamplerParameteri(id, GL_TEXTURE_WRAP_S, wrapMode(s.wrapS));
  glSamplerParameteri(id, GL_TEXTURE_WRAP_T, wrapMode(s.wrapT));
  glSamplerParameteri(id, GL_TEXTURE_MAG_FILTER, flat);
  glSamplerParameteri(id, GL_TEXTURE_MIN_FILTER, s.mipmaps ? mipped : flat);
  return gl::SamplerId(id);
}

/// Transmittance of a thin wall's volume: Beer's law over the thickness (KHR_materials_volume).
glm::vec3 attenuationOf(const Material& m) {
  if (m.attenuationDistance <= 0.0F || m.thickness <= 0.0F) return glm::vec3(1.0F);
  return glm::pow(m.attenuationColor, glm::vec3(m.thickness / m.attenuationDistance));
}

shader::MaterialData dataOf(const Material& m) {
  shader::MaterialData d{};
  d.baseColor = m.baseColor;
  // KHR_materials_unlit: the base colour alone.
  d.emissive = glm::vec4(m.unlit ? glm::vec3(0.0F) : m.emissive, m.normalScale);
  d.surface = glm::vec4(m.metallic, m.roughness, m.occlusionStrength, m.alphaCutoff);
  d.transmission = glm::vec4(attenuationOf(m), m.transmission);
  return d;
}

}  // namespace

void GpuScene::uploadTextures(const Scene& scene) {
  constexpr std::array<std::uint8_t, 4> kWhite{255, 255, 255, 255};
  white_ = gl::Texture("white", GL_RGBA8, 1, 1);
  glTextureSubImage2D(white_.id(), 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, kWhite.data());
  // One image may serve as colour in one material and as data in another.
  std::map<std::pair<std::int32_t, bool>, GLuint> uploaded;
  materialTextures_.assign(scene.materials.size() + 1, {});
  for (MaterialTextures& set : materialTextures_) set.textures.fill(white_.id());
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    const auto textures = texturesOf(scene.materials[m]);
    for (std::size_t slot = 0; slot < textures.size(); ++slot) {
      const TextureRef& ref = *textures[slot];
      if (ref.image == kNone) continue;
      GLuint& id = uploaded[{ref.image, isColor(slot)}];
      if (id == 0) {
        images_.push_back(upload(scene.images[static_cast<std::size_t>(ref.image)], isColor(slot)));
        id = images_.back().id();
      }
      samplers_.push_back(makeSampler(ref.sampler));
      materialTextures_[m + 1].textures[slot] = id;
      materialTextures_[m + 1].samplers[slot] = samplers_.back().id();
    }
  }
}

void GpuScene::uploadMaterials(const Scene& scene) {
  GLint alignment = 1;
  glGetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
  const auto align = static_cast<std::size_t>(alignment);
  materialStride_ = (sizeof(shader::MaterialData) + align - 1) / align * align;
  std::vector<std::byte> bytes((scene.materials.size() + 1) * materialStride_);
  for (std::size_t i = 0; i <= scene.materials.size(); ++i) {  // 0: the glTF default one
    const shader::MaterialData data = dataOf(i == 0 ? Material{} : scene.materials[i - 1]);
    std::memcpy(&bytes[i * materialStride_], &data, sizeof(data));
  }
  materials_ = gl::Buffer::of<std::byte>("materials", bytes);
}

void GpuScene::uploadLights(const Scene& scene, const Environment* environment) {
  lightBlock_ = lightBlockOf(scene, bounds_, environment);
  shadowViewProjection_ = shadowViewProjectionOf(scene, bounds_);
  if (environment != nullptr) {
    const Panorama& base = environment->levels.front();
    const auto levels = static_cast<int>(environment->levels.size());
    environment_ = gl::Texture("environment", GL_RGBA16F, base.width, base.height, levels);
    glTextureParameteri(environment_.id(), GL_TEXTURE_WRAP_S, GL_REPEAT);
    for (int i = 0; i < levels; ++i) {
      const Panorama& level = environment->levels[static_cast<std::size_t>(i)];
      glTextureSubImage2D(environment_.id(), i, 0, 0, level.width, level.height, GL_RGB, GL_FLOAT,
                          level.pixels.data());
    }
  }
  lights_ = gl::Buffer("lights", sizeof(lightBlock_), &lightBlock_);
  lightChoice_ = LightChoice(scene.lights, bounds_);
  if (!lightChoice_.needed()) return;
  for (const Light& light : scene.lights) allLights_.push_back(dataOf(light));
  chosenLights_.reserve(MAX_LIGHTS);
}

void GpuScene::chooseLights(const Camera& camera, float aspect) const {
  if (!lightChoice_.needed()) return;
  const auto chosen = lightChoice_.choose(camera, aspect);
  if (std::equal(chosen.begin(), chosen.end(), chosenLights_.begin(), chosenLights_.end())) return;
  chosenLights_.assign(chosen.begin(), chosen.end());
  std::array<shader::LightData, MAX_LIGHTS> data{};
  for (std::size_t i = 0; i < chosen.size(); ++i) data[i] = allLights_[chosen[i]];
  lights_.upload(data.data(), sizeof(data), offsetof(shader::LightBlock, lights));
}

}  // namespace macula::scene
