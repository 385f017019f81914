// Full-rate pixels from the samples of the reduced-rate image: the weighted mean of the 2x2 samples
// around each (Yang, Sander & Lawrence 2008, Eq. 1).
// BILINEAR: weights by distance in the image alone. YANG2008: and by Gaussians of the differences in
// normal and depth. Else: and by how well a sample fits the pixel's tangent plane and normal.
// PARTS: what is reconstructed are parts of the shading. FOVEATED: samples are 1 to 8 texels apart,
// tile by tile. DEMODULATE: samples hold the light on surfaces; base colour, emission and what is
// unlit (UNLIT: the scene has such surfaces) are the pixel's own.
// SHADE_HOLES: pixels that no sample fits go to a list; else they take the best one.
#include "shared/dispatch.h"
layout(local_size_x = FULLSCREEN_GROUP, local_size_y = FULLSCREEN_GROUP) in;

#include "lib/frame.glsl"
#include "lib/lod.glsl"
#include "lib/surface.glsl"

layout(binding = TEX_INPUT0) uniform usampler2D lodSamples;
layout(binding = TEX_INPUT1) uniform sampler2D depthTexture;
layout(binding = TEX_INPUT2) uniform sampler2D normalTexture;
#ifdef FOVEATED
layout(binding = TEX_INPUT3) uniform usampler2D shadingRate;
#endif
#ifdef DEMODULATE
layout(binding = TEX_INPUT4) uniform sampler2D baseColorTexture;
layout(binding = TEX_INPUT5) uniform sampler2D emissiveTexture;
#ifdef UNLIT
layout(binding = TEX_INPUT6) uniform sampler2D surfaceTexture;
#endif
#endif
#ifdef PARTS
layout(rgba8, binding = IMG_0) writeonly uniform image2D target;
#else
layout(rgba16f, binding = IMG_0) writeonly uniform image2D target;
#endif
#ifdef SHADE_HOLES
layout(std430, binding = SSBO_LOD_TOTALS) buffer Totals { LodTotals totals; };
layout(std430, binding = SSBO_LOD_HOLES) writeonly buffer Holes { uint holes[]; };
#include "lib/list_dispatch.glsl"
#endif
#ifdef YANG2008
layout(location = 0) uniform vec2 sigma;  // of normals over their z; of depth, share of the pixel's
#endif

/// The samples around a pixel, lower left to upper right, with where the pixel lies between them.
struct Taps {
  uvec4 texels[4];
  ivec2 pixels[4];
  vec2 between;
};

Taps tapsAround(ivec2 p) {
  int level = 0;
#ifdef FOVEATED
  // Samples are 2^level texels apart in a tile of L.
  ivec2 tile = min(ivec2((vec2(p) + 0.5) * frame.inversePitch), frame.lodTexels - 1) >> LOD_TILE_SHIFT;
  uint around = texelFetch(shadingRate, tile, 0).r;
  level = levelAround(around, ivec2(0));
#endif
  float pitch = frame.pitch * float(1 << level);
  ivec2 last = cellsOf(level) - 1;
  // Samples lie at pixels, up to half a pixel off the even grid. The cell whose middle is at most the
  // pixel's has its sample at or before it; the next one has its at or behind it.
  ivec2 low = ivec2(floor((vec2(p) + 0.5) / pitch - 0.5));
  ivec2 high = min(low + 1, last);
  low = clamp(low, ivec2(0), last);
  ivec2 from = samplePixel(low, pitch);
  ivec2 to = samplePixel(high, pitch);
  Taps taps;
  taps.between = clamp(vec2(p - from) / vec2(max(to - from, ivec2(1))), 0.0, 1.0);
  for (int i = 0; i < 4; ++i) {
    ivec2 cell = ivec2((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y);
    ivec2 texel = cell << level;
    taps.pixels[i] = ivec2((i & 1) != 0 ? to.x : from.x, (i & 2) != 0 ? to.y : from.y);
#ifdef FOVEATED
    // In the next tile, where samples may be denser or sparser: the cell around this place.
    ivec2 place = min(texel + (1 << level >> 1), frame.lodTexels - 1);
    int there = levelAround(around, (place >> LOD_TILE_SHIFT) - tile);
    cell = place >> there;
    texel = cell << there;
    taps.pixels[i] = samplePixel(cell, frame.pitch * float(1 << there));
#endif
    taps.texels[i] = texelFetch(lodSamples, texel, 0);
  }
  return taps;
}

/// The far plane is the background.
bool isSurface(uvec4 texel) { return uintBitsToFloat(texel.z) > frame.depthOffset; }

#ifdef YANG2008
/// Normal as seen from the camera, over its z (Toler-Franklin et al. 2007).
vec2 slopeOf(vec3 n) {
  vec3 seen = vec3(dot(n, normalize(frame.right.xyz)), dot(n, normalize(frame.up.xyz)),
                   -dot(n, frame.ahead.xyz));
  // Interpolated normals can turn away from the eye; then the slope is as good as infinite.
  return seen.xy / max(seen.z, 1e-3);
}

vec4 fitOf(Taps taps, ivec2 p, float inverseDistance, vec3 normal, float metallic) {
  vec2 slope = slopeOf(normal);
  vec4 fit;
  for (int i = 0; i < 4; ++i) {
    uvec4 texel = taps.texels[i];
    vec2 across = slopeOf(unpackSnorm4x8(texel.w).xyz) - slope;
    float tapInverse = uintBitsToFloat(texel.z);
    float depth = 1.0 - inverseDistance / max(tapInverse, 1e-12);
    fit[i] = isSurface(texel) ? exp(-0.5 * (dot(across, across) / (sigma.x * sigma.x) +
                                            depth * depth / (sigma.y * sigma.y)))
                              : 0.0;
  }
  return fit;
}
#else
/// By how much the cosine between normals may fall short of 1 likewise.
const float kNormalTolerance = 0.015;
/// And by how much the metallic factors of light may differ.
const float kMetallicTolerance = 0.1;

/// @param metallic of the pixel, where samples hold light
vec4 fitOf(Taps taps, ivec2 p, float inverseDistance, vec3 normal, float metallic) {
  TangentPlane tangent = tangentPlaneAt(p, inverseDistance, normal);
  vec4 fit;
  for (int i = 0; i < 4; ++i) {
    uvec4 texel = taps.texels[i];
    float plane = planeMiss(tangent, vec2(taps.pixels[i] - p), uintBitsToFloat(texel.z));
    vec4 seen = unpackSnorm4x8(texel.w);
    float bend = (1.0 - dot(normal, seen.xyz)) / kNormalTolerance;
    float miss = 1.0 + plane + bend * bend;
    bool knows = isSurface(texel);
#ifdef DEMODULATE
    float unlike = (metallic - seen.w) / kMetallicTolerance;
    miss += unlike * unlike;
    knows = knows && seen.w >= 0.0;
#endif
    fit[i] = knows ? 1.0 / (miss * miss) : 0.0;
  }
  return fit;
}
#endif

/// @returns whether a sample fits; else `value` is what the best one holds
bool reconstruct(ivec2 p, out vec3 value) {
  float depth = texelFetch(depthTexture, p, 0).r;
  vec4 baseColor = vec4(0.0);
#ifdef DEMODULATE
  if (depth > 0.0) baseColor = texelFetch(baseColorTexture, p, 0);
#ifdef UNLIT
  value = baseColor.rgb;
  if (depth > 0.0 && unpackKind(texelFetch(surfaceTexture, p, 0).zw).unlit) return true;
#endif
#endif
  Taps taps = tapsAround(p);
  vec4 weights = tentOf(taps.between);
  bool fits = true;
#ifndef BILINEAR
  vec4 fit;
  if (depth > 0.0) {
    vec3 normal = decodeOctahedral(texelFetch(normalTexture, p, 0).rg);
    fit = fitOf(taps, p, inverseDistanceOf(depth), normal, baseColor.a);
  } else {
    for (int i = 0; i < 4; ++i) fit[i] = isSurface(taps.texels[i]) ? 0.0 : 1.0;
  }
  weights = fittedWeights(weights, fit, fits);
#ifdef PARTS
  fits = fits || depth == 0.0;  // the background has no parts
#endif
#endif
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 4; ++i) {
#ifdef DEMODULATE
    sum += weights[i] * (baseColor.rgb * unpackSharedExponent(taps.texels[i].x) +
                         unpackSharedExponent(taps.texels[i].y));
#else
    sum += weights[i] * sampleValue(taps.texels[i]);
#endif
  }
  value = sum / dot(weights, vec4(1.0));
#ifdef DEMODULATE
  if (depth > 0.0) value += texelFetch(emissiveTexture, p, 0).rgb;
  value = min(value, vec3(kMaxHalf));
#endif
  return fits;
}

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  bool inside = p.x < int(frame.size.x) && p.y < int(frame.size.y);
  if (!inside) return;
  vec3 value;
  bool fits = reconstruct(p, value);
#ifdef SHADE_HOLES
  // Holes are few: an addition each costs less than the barriers of a sum over the group.
  if (!fits) {
    uint place = atomicAdd(totals.dispatches[LOD_RATES].w, 1u);
    growDispatch(LOD_RATES, place / uint(LIST_GROUP) + 1u);
    holes[place] = uint(p.x) | uint(p.y) << 16;
  }
#endif
  imageStore(target, p, vec4(value, 1.0));
}
