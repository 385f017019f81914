// A scene as plain data, before it is uploaded to the GPU.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace macula::scene {

/// "No such element" in an index into one of the scene's vectors.
inline constexpr std::int32_t kNone = -1;

/// 8-bit RGBA pixels, rows from the top.
struct Image {
  std::string name;
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  ///< 4 * width * height values
};

/// glTF 2.0 sampler, section 5.26; the numbers are those of OpenGL.
struct Sampler {
  enum class Wrap : std::uint8_t { Repeat, MirroredRepeat, ClampToEdge };
  Wrap wrapS = Wrap::Repeat;
  Wrap wrapT = Wrap::Repeat;
  bool nearest = false;  ///< magnification without interpolation
  bool mipmaps = true;   ///< minification through a mip chain
};

/// A use of an image by a material.
struct TextureRef {
  std::int32_t image = kNone;  ///< index into Scene::images
  Sampler sampler;
  int uvSet = 0;  ///< 0 or 1
};

enum class AlphaMode : std::uint8_t { Opaque, Mask, Blend };

/// Marble veins, computed for each pixel from the place in the world: turbulence of gradient noise
/// (Perlin 1985) mixes the base colour with the veins' colour.
struct Veins {
  glm::vec3 color{0.0F};  ///< linear RGB
  float scale = 0.0F;     ///< veins a metre, >= 0; 0: none

  [[nodiscard]] bool any() const { return scale > 0.0F; }
};

/// glTF metallic-roughness material with the extensions that Macula draws.
struct Material {
  std::string name;
  glm::vec4 baseColor{1.0F};  ///< linear RGB, alpha
  float metallic = 1.0F;      ///< 0..1
  float roughness = 1.0F;     ///< perceptual, 0..1
  glm::vec3 emissive{0.0F};   ///< linear, times KHR_materials_emissive_strength
  float normalScale = 1.0F;
  float occlusionStrength = 1.0F;  ///< 0..1
  AlphaMode alphaMode = AlphaMode::Opaque;
  float alphaCutoff = 0.5F;  ///< for AlphaMode::Mask
  bool doubleSided = false;
  bool unlit = false;  ///< KHR_materials_unlit

  /// KHR_materials_transmission, 0..1. Drawn as thin tinted transparency: see isTransparent().
  float transmission = 0.0F;
  /// KHR_materials_volume: colour of light after attenuationDistance, over a path of `thickness`.
  glm::vec3 attenuationColor{1.0F};
  float attenuationDistance = 0.0F;  ///< metres; 0 means infinite, as the extension's default
  float thickness = 0.0F;            ///< metres

  Veins veins;  ///< of an opaque surface; none by default

  TextureRef baseColorTexture;          ///< sRGB, alpha linear
  TextureRef metallicRoughnessTexture;  ///< G roughness, B metallic
  TextureRef normalTexture;             ///< tangent space
  TextureRef occlusionTexture;          ///< R
  TextureRef emissiveTexture;           ///< sRGB

  /// Whether its fragments go through the transparency passes.
  [[nodiscard]] bool isTransparent() const {
    return alphaMode == AlphaMode::Blend || transmission > 0.0F;
  }
};

/// One vertex beside its position. 60 bytes, uploaded as it is.
struct VertexAttributes {
  glm::vec3 normal{0.0F, 0.0F, 1.0F};
  glm::vec4 tangent{1.0F, 0.0F, 0.0F, 1.0F};  ///< xyz tangent, w sign of the bitangent
  glm::vec2 uv0{0.0F};
  glm::vec2 uv1{0.0F};
  glm::vec4 color{1.0F};  ///< linear, multiplies the base colour
};

/// Indexed triangles with one material.
struct Primitive {
  std::vector<glm::vec3> positions;
  std::vector<VertexAttributes> attributes;  ///< as many as positions
  std::vector<std::uint32_t> indices;        ///< three a triangle, each below positions.size()
  std::int32_t material = kNone;             ///< kNone: the glTF default material
};

/// A primitive placed in the world.
struct Instance {
  std::uint32_t primitive = 0;
  glm::mat4 transform{1.0F};  ///< object to world; may mirror
};

/// Taps a side of the shadow filter: usual, and the most that a scene can ask for.
inline constexpr int kUsualShadowTaps = 3;
inline constexpr int kMostShadowTaps = 15;
/// Most occlusion samples of a pixel: more change less than a display's step.
inline constexpr int kMostOcclusionSamples = 256;
/// Most materials with veins of a scene: their colours are in a uniform buffer.
inline constexpr int kMostVeins = 8;
/// Most lights of a frame; a scene may have more: see light_choice.h.
inline constexpr int kMostLights = 32;

enum class LightType : std::uint8_t { Directional, Point, Spot };

/// KHR_lights_punctual, already in world space.
struct Light {
  LightType type = LightType::Directional;
  std::string name = {};                   ///< for messages; may be empty
  glm::vec3 color{1.0F};                   ///< linear RGB
  float intensity = 1.0F;                  ///< lux (directional) or candela (point, spot)
  glm::vec3 position{0.0F};                ///< point and spot
  glm::vec3 direction{0.0F, 0.0F, -1.0F};  ///< the way the light travels, unit length
  float range = 0.0F;                      ///< metres; 0 means infinite
  float innerConeAngle = 0.0F;             ///< radians
  float outerConeAngle = 0.7853982F;       ///< radians
  bool castsShadow = false;                ///< at most one directional light of a scene
  /// Width of the shadow's filter in texels: so many taps a side of percentage-closer filtering.
  /// Odd, 1 to kMostShadowTaps.
  int shadowTaps = kUsualShadowTaps;
};

/// Ambient occlusion found on the screen, for the ambient part of the light.
struct AmbientOcclusion {
  float radius = 0.0F;  ///< metres around a point in which surfaces darken it, >= 0
  int samples = 0;      ///< 0: none, at most kMostOcclusionSamples

  [[nodiscard]] bool any() const { return samples > 0 && radius > 0.0F; }
};

/// A perspective camera in world space. Looks along -z of its frame, as glTF says.
struct Camera {
  std::string name;
  glm::vec3 position{0.0F};
  glm::vec3 target{0.0F, 0.0F, -1.0F};  ///< any point ahead on the view axis
  glm::vec3 up{0.0F, 1.0F, 0.0F};
  float verticalFov = 0.7853982F;  ///< radians
  float nearPlane = 0.05F;         ///< metres, > 0
  float farPlane = 100.0F;         ///< metres, > nearPlane
};

/// Axis-aligned box in world space; empty while min > max.
struct Bounds {
  glm::vec3 min{1e30F};
  glm::vec3 max{-1e30F};
  void add(const glm::vec3& p) {
    min = glm::min(min, p);
    max = glm::max(max, p);
  }
  [[nodiscard]] bool empty() const { return min.x > max.x; }
  /// @param i 0 to 7
  [[nodiscard]] glm::vec3 corner(unsigned i) const {
    return {(i & 1U) != 0 ? max.x : min.x, (i & 2U) != 0 ? max.y : min.y,
            (i & 4U) != 0 ? max.z : min.z};
  }
  [[nodiscard]] glm::vec3 center() const { return empty() ? glm::vec3(0.0F) : 0.5F * (min + max); }
  [[nodiscard]] float radius() const { return empty() ? 1.0F : 0.5F * glm::length(max - min); }
};

/// Everything a file or a recipe describes.
struct Scene {
  std::string name;
  std::vector<Image> images;
  std::vector<Material> materials;
  std::vector<Primitive> primitives;
  std::vector<Instance> instances;
  std::vector<Light> lights;
  std::vector<Camera> cameras;
  /// Constant ambient radiance where no environment is given, linear RGB.
  glm::vec3 ambient{0.0F};
  AmbientOcclusion occlusion;

  std::vector<std::string> unsupportedExtensions;  ///< optional ones the file uses
  std::vector<std::string> warnings;               ///< one line each

  /// The material of a primitive; the glTF default one for kNone.
  [[nodiscard]] const Material& materialOf(const Primitive& primitive) const;
};

/// Box around a primitive's vertices, in its own space.
[[nodiscard]] Bounds boundsOf(const Primitive& primitive);
/// World-space box around all instances.
[[nodiscard]] Bounds boundsOf(const Scene& scene);
/// The same around those with transparent materials.
[[nodiscard]] Bounds transparentBoundsOf(const Scene& scene);
/// Least and greatest distance from the camera to a box: x <= y, from the near plane on.
[[nodiscard]] glm::vec2 distancesTo(const Bounds& bounds, const Camera& camera);

/// Gives a scene without lights a key light that casts shadows, and ambient light, so that lit
/// materials can be seen; chooses the directional light that casts shadows where none is marked.
/// Does nothing to the lights of a scene whose materials are all unlit.
void addDefaultLights(Scene& scene);

}  // namespace macula::scene
