// Where the samples of the reduced-rate image lie, and what one of them holds. A cell is what one sample
// stands for: one texel of the reduced-rate image L, or a square of them where shading is foveated.
#include "lib/half.glsl"
#include "lib/raster.glsl"
#include "shared/lod_totals.h"

/// Full-rate pixel whose G-buffer texel lies at the middle of a cell, per axis.
/// @param pitch full-rate pixels a cell
ivec2 samplePixel(ivec2 cell, float pitch) {
  return pixelAt(cell, vec2(pitch), ivec2(frame.size));
}

/// Cells of 2^level texels a side that cover L.
ivec2 cellsOf(int level) { return (frame.lodTexels + (1 << level) - 1) >> level; }

/// Level of a tile next to the one of which `around` was read, or of itself: two bits each.
/// @param offset -1 to 1 tiles
int levelAround(uint around, ivec2 offset) {
  return int(around >> uint(2 * (offset.y * 3 + offset.x + 4))) & 3;
}

/// What one texel of L holds: rgb; 1 / distance along the view; normal.
uvec4 packSample(vec3 value, float inverseDistance, vec3 normal) {
  value = min(value, vec3(kMaxHalf));
  return uvec4(packHalf2x16(value.rg), packHalf2x16(vec2(value.b, 0.0)),
               floatBitsToUint(inverseDistance), packSnorm4x8(vec4(normal, 0.0)));
}
vec3 sampleValue(uvec4 texel) {
  return vec3(unpackHalf2x16(texel.x), unpackHalf2x16(texel.y).x);
}

/// exp2() may be off by a bit. @param n -126 to 127
float exactPowerOf2(int n) { return uintBitsToFloat(uint(n + 127) << 23); }

/// Three channels >= 0 that share an exponent, 9 bits each (EXT_texture_shared_exponent).
uint packSharedExponent(vec3 c) {
  const float kMost = 65408.0;  // 511 / 512 * 2^16
  c = clamp(c, vec3(0.0), vec3(kMost));
  float most = max(max(c.r, c.g), c.b);
  int exponent = max(int(floatBitsToUint(most) >> 23) - 126, -15);  // most < 2^exponent
  if (most * exactPowerOf2(9 - exponent) >= 511.5) ++exponent;      // would round to 512
  uvec3 mantissa = uvec3(c * exactPowerOf2(9 - exponent) + 0.5);
  return mantissa.r | mantissa.g << 9 | mantissa.b << 18 | uint(exponent + 15) << 27;
}
vec3 unpackSharedExponent(uint bits) {
  uvec3 mantissa = uvec3(bits, bits >> 9, bits >> 18) & 511u;
  return vec3(mantissa) * exactPowerOf2(int(bits >> 27) - 24);
}

/// Light on a surface apart from the surface's colours. No light is known of unlit surfaces.
struct SurfaceLight {
  vec3 perColor;   // times the base colour
  vec3 colorless;  // added to that
  float metallic;  // of the surface: metals and dielectrics reflect the same light differently
};
/// In place of the metallic factor.
const float kUnlitSample = -1.0;

/// As packSample(), of the same size.
uvec4 packLight(SurfaceLight s, float inverseDistance, vec3 normal) {
  return uvec4(packSharedExponent(s.perColor), packSharedExponent(s.colorless),
               floatBitsToUint(inverseDistance), packSnorm4x8(vec4(normal, s.metallic)));
}

/// A fit below this is none: the sample lies on another surface. At it a Gaussian is 2.4 sigma out.
const float kLeastFit = 0.05;

/// Weights of the 2x2 samples around a pixel, lower left to upper right, by distance alone.
/// @param between where the pixel lies between them, 0..1
vec4 tentOf(vec2 between) {
  vec2 rest = 1.0 - between;
  return vec4(rest.x * rest.y, between.x * rest.y, rest.x * between.y, between.x * between.y);
}

/// Weights of the samples around a pixel: the tent's times how well they fit; where none that the
/// tent reaches fits, the best of them alone.
/// @param fits whether one does
vec4 fittedWeights(vec4 tent, vec4 fit, out bool fits) {
  vec4 reached = mix(vec4(0.0), fit, greaterThan(tent, vec4(0.0)));
  float best = max(max(reached.x, reached.y), max(reached.z, reached.w));
  fits = best >= kLeastFit;
  vec4 nearest = best > 0.0 ? vec4(greaterThanEqual(reached, vec4(best))) : tent;
  return fits ? tent * fit : nearest;
}

/// 1 / distance along the view of a reversed depth.
float inverseDistanceOf(float depth) { return depth * frame.depthScale + frame.depthOffset; }

/// Distance from the tangent plane at which a sample fits half as well, in pixels a pixel between
/// the two.
const float kPlaneTolerance = 0.1;
/// The same that is always allowed: rounding of depth and normal.
const float kPlaneSlack = 0.25;

/// The plane that touches a pixel's surface, as the view sees it.
struct TangentPlane {
  float distance;  // of the pixel along the view
  float facing;    // n . ray of the pixel
  vec2 gradient;   // of n . ray, a pixel
  float pixels;    // that span a unit at distance 1
};

TangentPlane tangentPlaneAt(ivec2 p, float inverseDistance, vec3 normal) {
  vec2 step = 2.0 * frame.inverseSize;
  vec2 ndc = (vec2(p) + 0.5) * step - 1.0;
  // n . ray is linear over the screen, and z n . ray is the same all over a plane.
  vec2 gradient = vec2(dot(normal, frame.right.xyz) * step.x, dot(normal, frame.up.xyz) * step.y);
  float facing = dot(normal, frame.ahead.xyz) + dot(normal, frame.right.xyz) * ndc.x +
                 dot(normal, frame.up.xyz) * ndc.y;
  return TangentPlane(1.0 / inverseDistance, facing, gradient,
                      1.0 / (length(frame.up.xyz) * step.y));
}

/// Squared distance of a sample from the plane, 1 where it fits half as well.
/// @param offset full-rate pixels from the pixel to the sample
float planeMiss(TangentPlane plane, vec2 offset, float sampleInverse) {
  // In pixels at the sample's distance.
  float away = plane.pixels * abs(plane.facing + dot(plane.gradient, offset) -
                                  plane.facing * plane.distance * sampleInverse);
  vec2 reach = abs(offset);
  float miss = away / (kPlaneSlack + kPlaneTolerance * max(reach.x, reach.y));
  return miss * miss;
}
