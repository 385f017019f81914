// The glTF material at a fragment of the scene. TEXTURED: the run has textures bound.
#include "lib/scene.glsl"
#include "lib/surface.glsl"

layout(location = 0) in vec4 inUv;
layout(location = 1) in vec4 inColor;
layout(location = 2) flat in uvec3 inIds;
layout(location = 3) in vec3 inPosition;
layout(location = 4) in vec3 inNormal;
layout(location = 5) in vec4 inTangent;
layout(location = 6) flat in float inMirror;

#ifdef TEXTURED
layout(binding = TEX_BASE_COLOR) uniform sampler2D baseColorTexture;
layout(binding = TEX_METALLIC_ROUGHNESS) uniform sampler2D metallicRoughnessTexture;
layout(binding = TEX_NORMAL) uniform sampler2D normalTexture;
layout(binding = TEX_OCCLUSION) uniform sampler2D occlusionTexture;
layout(binding = TEX_EMISSIVE) uniform sampler2D emissiveTexture;

vec2 uvOf(MaterialData m, uint slot) { return (m.flags.y & (1u << slot)) != 0u ? inUv.zw : inUv.xy; }
#endif

/// Id of the triangle that does not depend on the order of draws.
uint fragmentId() { return inIds.y + inIds.z * uint(gl_PrimitiveID); }

vec4 baseColorAt(MaterialData m) {
  vec4 color = m.baseColor * inColor;
#ifdef TEXTURED
  if ((m.flags.x & MATERIAL_HAS_BASE_COLOR_TEXTURE) != 0u) {
    color *= texture(baseColorTexture, uvOf(m, TEX_BASE_COLOR));
  }
#endif
  return color;
}

vec3 normalAt(MaterialData m) {
  // A transform that flattens has no normal; any unit vector keeps NaN out of the image.
  vec3 n = dot(inNormal, inNormal) > 0.0 ? normalize(inNormal) : vec3(0.0, 1.0, 0.0);
#ifdef TEXTURED
  if ((m.flags.x & MATERIAL_HAS_NORMAL_TEXTURE) != 0u && dot(inTangent.xyz, inTangent.xyz) > 0.0) {
    vec3 t = normalize(inTangent.xyz - n * dot(n, inTangent.xyz));
    vec3 b = cross(n, t) * inTangent.w * inMirror;
    vec3 s = texture(normalTexture, uvOf(m, TEX_NORMAL)).xyz * 2.0 - 1.0;
    s.xy *= m.emissive.w;
    n = normalize(t * s.x + b * s.y + n * s.z);
  }
#endif
  bool front = gl_FrontFacing == (inMirror > 0.0);
#ifdef FLIPS_FRONT_FACE
  front = gl_FrontFacing;  // the run's front face is already mirrored
#endif
  return front ? n : -n;
}

SurfacePoint surfaceAt(MaterialData m) {
  SurfacePoint s;
  vec4 color = baseColorAt(m);
  s.baseColor = color.rgb;
  s.alpha = color.a;
  s.position = inPosition;
  s.normal = normalAt(m);
  s.metallic = m.surface.x;
  s.roughness = m.surface.y;
  s.occlusion = 1.0;
  s.emissive = m.emissive.rgb;
  s.unlit = (m.flags.x & MATERIAL_UNLIT) != 0u;
#ifdef TEXTURED
  if ((m.flags.x & MATERIAL_HAS_METALLIC_ROUGHNESS_TEXTURE) != 0u) {
    vec2 gb = texture(metallicRoughnessTexture, uvOf(m, TEX_METALLIC_ROUGHNESS)).gb;
    s.roughness *= gb.x;
    s.metallic *= gb.y;
  }
  if ((m.flags.x & MATERIAL_HAS_OCCLUSION_TEXTURE) != 0u) {
    float o = texture(occlusionTexture, uvOf(m, TEX_OCCLUSION)).r;
    s.occlusion = 1.0 + m.surface.z * (o - 1.0);
  }
  if ((m.flags.x & MATERIAL_HAS_EMISSIVE_TEXTURE) != 0u) {
    s.emissive *= texture(emissiveTexture, uvOf(m, TEX_EMISSIVE)).rgb;
  }
#endif
  return s;
}
