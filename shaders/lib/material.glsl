// The glTF material at a fragment of the scene. TEXTURED: the run has textures bound. LIT with
// VERTEX_LIGHT: light comes from the vertices, and there is no normal. UV_ONLY: only the base colour is
// used. POSITION_ONLY: nothing is, or, WITH_IDS, ids. HOLED: alpha can make a hole of a fragment; a pass
// calls isThere() before anything else.
#include "lib/scene.glsl"
#include "lib/surface.glsl"

#if !defined(POSITION_ONLY) || defined(WITH_IDS)
layout(location = 2) flat in uvec3 inIds;

/// Id of the triangle that does not depend on the order of draws.
uint fragmentId() { return inIds.y + inIds.z * uint(gl_PrimitiveID); }
#endif

#ifndef POSITION_ONLY
layout(location = 0) in vec4 inUv;
layout(location = 1) in vec4 inColor;
#ifndef UV_ONLY
#if defined(LIT) && defined(VERTEX_LIGHT)
layout(location = 3) in vec3 inFrontLight;
layout(location = 4) in vec3 inBackLight;
#else
layout(location = 3) in vec3 inPosition;
layout(location = 4) in vec3 inNormal;
layout(location = 5) in vec4 inTangent;
#endif
layout(location = 6) flat in float inMirror;
#endif

#ifdef TEXTURED
layout(binding = TEX_BASE_COLOR) uniform sampler2D baseColorTexture;
layout(binding = TEX_METALLIC_ROUGHNESS) uniform sampler2D metallicRoughnessTexture;
layout(binding = TEX_NORMAL) uniform sampler2D normalTexture;
layout(binding = TEX_OCCLUSION) uniform sampler2D occlusionTexture;
layout(binding = TEX_EMISSIVE) uniform sampler2D emissiveTexture;

bool usesSecondUv(MaterialData m, uint slot) { return (m.flags.y & (1u << slot)) != 0u; }

#ifdef HOLED
#define EXPLICIT_GRADIENTS
#endif
#ifdef EXPLICIT_GRADIENTS
// A pass that leaves early calls prepareGradients() first: after the first return the neighbours'
// coordinates, and with them implicit gradients, are undefined (GLSL 4.50, section 8.13.1).
vec4 uvDx, uvDy;
void prepareGradients() {
  uvDx = dFdx(inUv);
  uvDy = dFdy(inUv);
}
vec4 sampleSlot(sampler2D map, MaterialData m, uint slot) {
  return usesSecondUv(m, slot) ? textureGrad(map, inUv.zw, uvDx.zw, uvDy.zw)
                               : textureGrad(map, inUv.xy, uvDx.xy, uvDy.xy);
}
#else
vec4 sampleSlot(sampler2D map, MaterialData m, uint slot) {
  return texture(map, usesSecondUv(m, slot) ? inUv.zw : inUv.xy);
}
#endif
#endif

vec4 findBaseColor(MaterialData m) {
  precise vec4 color = m.baseColor * inColor;
#ifdef TEXTURED
  if ((m.flags.x & MATERIAL_HAS_BASE_COLOR_TEXTURE) != 0u) {
    color *= sampleSlot(baseColorTexture, m, TEX_BASE_COLOR);
  }
#endif
  return color;
}

#ifdef HOLED
vec4 foundBaseColor;

/// Whether a fragment contributes to the image. All passes call this one function, and it samples
/// textures with explicit gradients in all of them, so that they agree.
bool isThere() {
#ifdef TEXTURED
  prepareGradients();
#endif
  MaterialData m = materials[inIds.x];
  foundBaseColor = findBaseColor(m);
  return alphaOf(m, foundBaseColor.a) > LEAST_ALPHA;
}

vec4 baseColorAt(MaterialData m) { return foundBaseColor; }
#else
vec4 baseColorAt(MaterialData m) { return findBaseColor(m); }
#endif

#ifndef UV_ONLY
/// 1 where the front of the surface is visible, else -1. Single-sided runs show front faces only; for
/// the others a mirroring transform swaps the sides.
float facing(MaterialData m) {
  bool front = (m.flags.x & MATERIAL_DOUBLE_SIDED) == 0u || gl_FrontFacing == (inMirror > 0.0);
  return front ? 1.0 : -1.0;
}

#if !defined(LIT) || !defined(VERTEX_LIGHT)
/// The normal of the geometry, without a normal map, towards the side that is seen.
vec3 geometricNormalAt(MaterialData m) {
  // A transform that flattens has no normal; any unit vector keeps NaN out of the image.
  vec3 n = dot(inNormal, inNormal) > 0.0 ? normalize(inNormal) : vec3(0.0, 1.0, 0.0);
  return n * facing(m);
}

vec3 normalAt(MaterialData m, vec3 geometricNormal) {
#ifdef TEXTURED
  if ((m.flags.x & MATERIAL_HAS_NORMAL_TEXTURE) != 0u && dot(inTangent.xyz, inTangent.xyz) > 0.0) {
    vec3 n = geometricNormal * facing(m);
    vec3 t = normalize(inTangent.xyz - n * dot(n, inTangent.xyz));
    vec3 b = cross(n, t) * inTangent.w * inMirror;
    vec3 s = sampleSlot(normalTexture, m, TEX_NORMAL).xyz * 2.0 - 1.0;
    s.xy *= m.emissive.w;
    return normalize(t * s.x + b * s.y + n * s.z) * facing(m);
  }
#endif
  return geometricNormal;
}

SurfacePoint surfaceAt(MaterialData m) {
  SurfacePoint s;
  vec4 color = baseColorAt(m);
  s.baseColor = color.rgb;
  s.alpha = alphaOf(m, color.a);
  s.position = inPosition;
  s.geometricNormal = geometricNormalAt(m);
  s.normal = normalAt(m, s.geometricNormal);
  s.metallic = m.surface.x;
  s.roughness = m.surface.y;
  s.occlusion = 1.0;
  s.emissive = m.emissive.rgb;
  s.unlit = (m.flags.x & MATERIAL_UNLIT) != 0u;
#ifdef TEXTURED
  if ((m.flags.x & MATERIAL_HAS_METALLIC_ROUGHNESS_TEXTURE) != 0u) {
    vec2 gb = sampleSlot(metallicRoughnessTexture, m, TEX_METALLIC_ROUGHNESS).gb;
    s.roughness *= gb.x;
    s.metallic *= gb.y;
  }
  if ((m.flags.x & MATERIAL_HAS_OCCLUSION_TEXTURE) != 0u) {
    float o = sampleSlot(occlusionTexture, m, TEX_OCCLUSION).r;
    s.occlusion = 1.0 + m.surface.z * (o - 1.0);
  }
  if ((m.flags.x & MATERIAL_HAS_EMISSIVE_TEXTURE) != 0u) {
    s.emissive *= sampleSlot(emissiveTexture, m, TEX_EMISSIVE).rgb;
  }
#endif
  return s;
}
#endif
#endif
#endif
