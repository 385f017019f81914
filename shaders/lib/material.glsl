// The glTF material at a fragment of the scene, specialised by what its run has. TEXTURED: textures; which:
// BASE_COLOR_MAP, METALLIC_ROUGHNESS_MAP, NORMAL_MAP, OCCLUSION_MAP, EMISSIVE_MAP. SECOND_UV:
// bit TEX_... of those that use it. VERTEX_COLOR: its vertices have colours. DOUBLE_SIDED: back faces are seen.
// LIT with VERTEX_LIGHT: light comes from the vertices, and there is no normal. UV_ONLY: only the base
// colour is used. POSITION_ONLY: nothing is, or, WITH_IDS, ids. HOLED: alpha can make a hole of a
// fragment; a pass calls isThere() before anything else.
#include "lib/surface.glsl"
// Here, because what is included again inside of a condition counts as included.
#include "shared/bindings.h"
#include "shared/scene_data.h"

#if !defined(POSITION_ONLY) || defined(WITH_IDS)
layout(location = 2) flat in uvec2 inIds;

/// Id of the triangle that does not depend on the order of draws.
uint fragmentId() { return inIds.x + inIds.y * uint(gl_PrimitiveID); }
#endif

#ifndef POSITION_ONLY
#include "lib/run_material.glsl"

#ifdef TEXTURED
#ifdef SECOND_UV
layout(location = 0) in vec4 inUv;  // xy: first set, zw: second
#else
layout(location = 0) in vec2 inUv;
#endif
#endif
#ifdef VERTEX_COLOR
layout(location = 1) in vec4 inColor;
#endif
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

#ifdef HOLED
#define EXPLICIT_GRADIENTS
#endif
#ifdef EXPLICIT_GRADIENTS
// A pass that leaves early calls prepareGradients() first: after the first return the neighbours'
// coordinates, and with them implicit gradients, are undefined (GLSL 4.50, section 8.13.1).
#ifdef SECOND_UV
vec4 uvDx, uvDy;
#else
vec2 uvDx, uvDy;
#endif
void prepareGradients() {
  uvDx = dFdx(inUv);
  uvDy = dFdy(inUv);
}
#define SAMPLE(map, PART) textureGrad(map, inUv.PART, uvDx.PART, uvDy.PART)
#else
#define SAMPLE(map, PART) texture(map, inUv.PART)
#endif

/// @param slot number of the texture
vec4 sampleSlot(sampler2D map, int slot) {
#ifdef SECOND_UV
  if ((SECOND_UV & (1 << slot)) != 0) return SAMPLE(map, zw);
#endif
  return SAMPLE(map, xy);
}
#endif

vec4 findBaseColor() {
#ifdef VERTEX_COLOR
  precise vec4 color = inColor;
#else
  precise vec4 color = material.baseColor;
#endif
#ifdef BASE_COLOR_MAP
  color *= sampleSlot(baseColorTexture, TEX_BASE_COLOR);
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
  foundBaseColor = findBaseColor();
  return alphaOf(foundBaseColor.a) > LEAST_ALPHA;
}

vec4 baseColor() { return foundBaseColor; }
#else
vec4 baseColor() { return findBaseColor(); }
#endif

#ifndef UV_ONLY
/// 1 where the front of the surface is visible, else -1. Single-sided runs show front faces only; for
/// the others a mirroring transform swaps the sides.
float facing() {
#ifdef DOUBLE_SIDED
  return gl_FrontFacing == (inMirror > 0.0) ? 1.0 : -1.0;
#else
  return 1.0;
#endif
}

#if !defined(LIT) || !defined(VERTEX_LIGHT)
/// The normal of the geometry, without a normal map, towards the side that is seen.
vec3 geometricNormal() {
  // A transform that flattens has no normal; any unit vector keeps NaN out of the image.
  vec3 n = dot(inNormal, inNormal) > 0.0 ? normalize(inNormal) : vec3(0.0, 1.0, 0.0);
  return n * facing();
}

/// @param geometric normal of the geometry towards the side that is seen
vec3 mappedNormal(vec3 geometric) {
#ifdef NORMAL_MAP
  if (dot(inTangent.xyz, inTangent.xyz) > 0.0) {
    vec3 n = geometric * facing();
    vec3 t = normalize(inTangent.xyz - n * dot(n, inTangent.xyz));
    vec3 b = cross(n, t) * inTangent.w * inMirror;
    vec3 s = sampleSlot(normalTexture, TEX_NORMAL).xyz * 2.0 - 1.0;
    s.xy *= material.emissive.w;
    return normalize(t * s.x + b * s.y + n * s.z) * facing();
  }
#endif
  return geometric;
}

SurfacePoint findSurface() {
  SurfacePoint s;
  vec4 color = baseColor();
  s.baseColor = color.rgb;
  s.alpha = alphaOf(color.a);
  s.position = inPosition;
  s.geometricNormal = geometricNormal();
  s.normal = mappedNormal(s.geometricNormal);
  s.metallic = material.surface.x;
  s.roughness = material.surface.y;
  s.occlusion = 1.0;
  s.emissive = material.emissive.rgb;
#ifdef LIT
  s.unlit = false;
#else
  s.unlit = true;
#endif
#ifdef METALLIC_ROUGHNESS_MAP
  vec2 gb = sampleSlot(metallicRoughnessTexture, TEX_METALLIC_ROUGHNESS).gb;
  s.roughness *= gb.x;
  s.metallic *= gb.y;
#endif
#ifdef OCCLUSION_MAP
  float o = sampleSlot(occlusionTexture, TEX_OCCLUSION).r;
  s.occlusion = 1.0 + material.surface.z * (o - 1.0);
#endif
#ifdef EMISSIVE_MAP
  s.emissive *= sampleSlot(emissiveTexture, TEX_EMISSIVE).rgb;
#endif
  return s;
}
#endif
#endif
#endif
