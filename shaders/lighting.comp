// Light of the opaque surfaces, and the background where there are none.
// LIT: at least one material of the scene is lit. SHADOWS, ENVIRONMENT: see lib/lighting.glsl.
// VEINS, OCCLUSION: the scene has them. NOTHING_OPAQUE: it has no opaque surface, and so there is no
// G-buffer.
// Which pixel a thread shades: its own; AT_GRID: that of a texel of the reduced-rate image; AT_TILES: that
// of a sample of a tile in a list; AT_HOLES: one of a list.
// SKIP_SHADOW, SKIP_OCCLUSION, SKIP_NOISE: parts of the shading that are not computed here.
// DEMODULATE: samples hold the light on a surface, without its base colour and what it emits.
// PARTS_OUT: the others come out instead of radiance. PARTS_IN: these come from a texture.
#include "shared/dispatch.h"
#include "shared/lod_totals.h"
#if defined(AT_TILES) || defined(AT_HOLES)
layout(local_size_x = LIST_GROUP) in;
#else
layout(local_size_x = FULLSCREEN_GROUP, local_size_y = FULLSCREEN_GROUP) in;
#endif

#include "lib/frame.glsl"
#include "lib/lighting.glsl"
#include "lib/lod.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D depthTexture;
layout(binding = TEX_INPUT1) uniform sampler2D normalTexture;
layout(binding = TEX_INPUT2) uniform sampler2D baseColorTexture;
layout(binding = TEX_INPUT3) uniform sampler2D surfaceTexture;
layout(binding = TEX_INPUT4) uniform sampler2D emissiveTexture;
#ifdef PARTS_IN
layout(binding = TEX_INPUT5) uniform sampler2D partsTexture;
#endif
#if defined(AT_GRID) || defined(AT_TILES)
layout(rgba32ui, binding = IMG_0) writeonly uniform uimage2D lodSamples;
#elif defined(PARTS_OUT)
layout(rgba8, binding = IMG_0) writeonly uniform image2D target;
#else
layout(rgba16f, binding = IMG_0) writeonly uniform image2D target;
#endif
#if defined(AT_TILES) || defined(AT_HOLES)
layout(std430, binding = SSBO_LOD_TOTALS) readonly buffer Totals { LodTotals totals; };
#endif
#ifdef AT_TILES
layout(std430, binding = SSBO_LOD_TILES) readonly buffer Tiles { uint tiles[]; };
layout(location = 0) uniform int rateLevel;  // samples are 2^rateLevel texels apart
#endif
#ifdef AT_HOLES
layout(std430, binding = SSBO_LOD_HOLES) readonly buffer Holes { uint holes[]; };
#endif

#ifdef VEINS
#include "lib/veins.glsl"
#endif
#ifdef OCCLUSION
#include "lib/occlusion.glsl"
#endif

/// What can be shaded at a lower rate than the rest.
struct Parts {
  float shadow;     // share of the shadow-casting light that arrives
  float occlusion;  // share of the ambient light that arrives
  float noise;      // share of the veins' colour
};

Parts computeParts(SurfacePoint s, uint veins) {
  Parts parts = Parts(1.0, 1.0, 0.0);
#if defined(SHADOWS) && !defined(SKIP_SHADOW)
  parts.shadow = shadowAt(s);
#endif
#if defined(OCCLUSION) && !defined(SKIP_OCCLUSION)
  parts.occlusion =
      ambientOcclusion(s.position, s.normal, lights.occlusion.x, int(lights.occlusion.y));
#endif
#if defined(VEINS) && !defined(SKIP_NOISE)
  if (veins > 0u) parts.noise = veinsAt(s.position * lights.veins[veins - 1u].w);
#endif
  return parts;
}

vec3 worldAt(vec2 uv, float depth) {
  vec4 p = frame.inverseViewProjection * vec4(uv * 2.0 - 1.0, depth, 1.0);
  return p.xyz / p.w;
}

vec3 backgroundAt(vec2 uv) {
#ifdef ENVIRONMENT
  // Half way between the planes: on the far plane the inverse of reversed depth is ill-conditioned.
  return environmentRadiance(normalize(worldAt(uv, 0.5) - frame.eye.xyz), 0.0);
#else
  return frame.background.rgb;
#endif
}

void store(ivec2 texel, ivec2 pixel, vec3 value, float depth, vec3 normal) {
#if defined(AT_GRID) || defined(AT_TILES)
  imageStore(lodSamples, texel, packSample(value, inverseDistanceOf(depth), normal));
#else
  imageStore(target, pixel, vec4(min(value, vec3(kMaxHalf)), 1.0));
#endif
}

#ifdef DEMODULATE
void store(ivec2 texel, SurfaceLight light, float depth, vec3 normal) {
  imageStore(lodSamples, texel, packLight(light, inverseDistanceOf(depth), normal));
}
#endif

#if defined(AT_TILES)
/// Samples on the grids of the tiles in the list.
uint entries() {
  uint side = uint(LOD_TILE) >> uint(rateLevel);
  return totals.dispatches[rateLevel].w * side * side;
}

/// The pixel of an entry, and the texel of L that it is for. @returns whether there is one
bool findPixel(uint entry, out ivec2 pixel, out ivec2 texel) {
  uint side = uint(LOD_TILE) >> uint(rateLevel);
  uint place = entry % (side * side);
  uint tile = tiles[uint(rateLevel) * uint(frame.lodTiles.x * frame.lodTiles.y) + entry / (side * side)];
  ivec2 corner = ivec2(tile % uint(frame.lodTiles.x), tile / uint(frame.lodTiles.x)) * LOD_TILE;
  texel = corner + (ivec2(place % side, place / side) << rateLevel);
  pixel = samplePixel(texel >> rateLevel, frame.pitch * float(1 << rateLevel));
  return texel.x < frame.lodTexels.x && texel.y < frame.lodTexels.y;
}
#elif defined(AT_HOLES)
uint entries() { return totals.dispatches[LOD_RATES].w; }

bool findPixel(uint entry, out ivec2 pixel, out ivec2 texel) {
  uint hole = holes[entry];
  pixel = ivec2(hole & 0xFFFFu, hole >> 16);
  texel = ivec2(0);
  return true;
}
#endif

/// @param texel of L that it is for, where it is for one
void shadePixel(ivec2 p, ivec2 texel) {
  vec2 uv = (vec2(p) + 0.5) * frame.inverseSize;
#ifdef NOTHING_OPAQUE
  store(texel, p, backgroundAt(uv), 0.0, vec3(0.0));
#else
  float depth = texelFetch(depthTexture, p, 0).r;
  if (depth == 0.0) {
#ifdef PARTS_OUT
    store(texel, p, vec3(1.0, 1.0, 0.0), depth, vec3(0.0));
#elif defined(DEMODULATE)
    store(texel, SurfaceLight(vec3(0.0), backgroundAt(uv), 0.0), depth, vec3(0.0));
#else
    store(texel, p, backgroundAt(uv), depth, vec3(0.0));
#endif
    return;
  }
  vec4 surface = texelFetch(surfaceTexture, p, 0);
  SurfacePoint s;
  s.position = worldAt(uv, depth);
  s.normal = decodeOctahedral(texelFetch(normalTexture, p, 0).rg);
  SurfaceKind kind = unpackKind(surface.zw);
  s.geometricNormal = kind.mapped ? kind.geometricNormal : s.normal;
  s.unlit = kind.unlit;
#ifdef PARTS_OUT
  Parts parts = Parts(1.0, 1.0, 0.0);
  if (!s.unlit) parts = computeParts(s, kind.veins);
  store(texel, p, vec3(parts.shadow, parts.occlusion, parts.noise), depth, s.normal);
#else
  vec4 baseColor = texelFetch(baseColorTexture, p, 0);
#ifdef DEMODULATE
  // Where no other sample is near, an unlit one gives a pixel its plain colour.
  SurfaceLight light = SurfaceLight(vec3(1.0), vec3(0.0), kUnlitSample);
#else
  vec3 radiance = s.unlit ? baseColor.rgb : texelFetch(emissiveTexture, p, 0).rgb;
#endif
#ifdef LIT
  if (!s.unlit) {
    Parts parts = computeParts(s, kind.veins);
#ifdef PARTS_IN
    vec3 given = texelFetch(partsTexture, p, 0).rgb;
#ifdef SKIP_SHADOW
    parts.shadow = given.r;
#endif
#ifdef SKIP_OCCLUSION
    parts.occlusion = given.g;
#endif
#ifdef SKIP_NOISE
    parts.noise = given.b;
#endif
#endif
    s.baseColor = baseColor.rgb;
#ifdef VEINS
    if (kind.veins > 0u) {
      s.baseColor = mix(baseColor.rgb, lights.veins[kind.veins - 1u].rgb, parts.noise);
    }
#endif
    s.alpha = 1.0;
    s.metallic = baseColor.a;
    s.roughness = surface.x;
    s.occlusion = surface.y * parts.occlusion;
    s.emissive = vec3(0.0);
    Radiance sum = lightSurface(s, frame.eye.xyz, parts.shadow);
#ifdef DEMODULATE
    // Of a colour that veins cover in part, the rest is seen.
    light.perColor = sum.perColor * (kind.veins > 0u ? 1.0 - parts.noise : 1.0);
    light.colorless = sum.diffuse + sum.specular - baseColor.rgb * light.perColor;
    light.metallic = s.metallic;
#else
    radiance += sum.diffuse + sum.specular;
#endif
  }
#endif
#ifdef DEMODULATE
  store(texel, light, depth, s.normal);
#else
  store(texel, p, radiance, depth, s.normal);
#endif
#endif
#endif
}

void main() {
#if defined(AT_TILES) || defined(AT_HOLES)
  uint group = gl_WorkGroupID.y * ROW_GROUPS + gl_WorkGroupID.x;
  uint entry = group * uint(LIST_GROUP) + gl_LocalInvocationIndex;
  ivec2 p, texel;
  if (entry < entries() && findPixel(entry, p, texel)) shadePixel(p, texel);
#elif defined(AT_GRID)
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (texel.x >= frame.lodTexels.x || texel.y >= frame.lodTexels.y) return;
  shadePixel(samplePixel(texel, frame.pitch), texel);
#else
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (p.x < int(frame.size.x) && p.y < int(frame.size.y)) shadePixel(p, p);
#endif
}
