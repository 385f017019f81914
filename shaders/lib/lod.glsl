// Where the samples of the resized image lie, and what one of them holds. A cell is what one sample
// stands for: one texel of the resized image L, or a square of them where shading is foveated.
#include "shared/lod_totals.h"

/// Full-rate pixel whose G-buffer texel lies at the middle of a cell, per axis.
/// @param pitch full-rate pixels a cell
ivec2 samplePixel(ivec2 cell, float pitch) {
  ivec2 last = ivec2(frame.size.xy) - 1;
  return min(ivec2(floor((vec2(cell) + 0.5) * pitch)), last);
}

/// Cells of 2^level texels a side that cover L.
ivec2 cellsOf(int level) { return (frame.lodSize.xy + (1 << level) - 1) >> level; }

/// Level of a tile next to the one of which `around` was read, or of itself: two bits each.
/// @param offset -1 to 1 tiles
int levelAround(uint around, ivec2 offset) {
  return int(around >> uint(2 * (offset.y * 3 + offset.x + 4))) & 3;
}

/// What one texel of L holds: rgb; 1 / distance along the view; normal.
uvec4 packSample(vec3 value, float inverseDistance, vec3 normal) {
  return uvec4(packHalf2x16(value.rg), packHalf2x16(vec2(value.b, 0.0)),
               floatBitsToUint(inverseDistance), packSnorm4x8(vec4(normal, 0.0)));
}
vec3 sampleValue(uvec4 texel) {
  return vec3(unpackHalf2x16(texel.x), unpackHalf2x16(texel.y).x);
}

/// What light on a surface is multiplied by, roughly: colour of diffuse and metallic reflection, and
/// the reflectance of dielectrics, so that it is never 0.
vec3 surfaceColor(vec3 baseColor) { return baseColor + 0.04; }
