// What the transparency passes share: keys, packing, ranges.
#include "shared/bindings.h"
#include "shared/oit_constants.h"
#include "shared/oit_totals.h"

/// Sorts ascending from the eye: reversed depth is a positive float, whose bits order like the
/// value, so the complement puts the nearest first. Ties go to the lower id.
uvec2 fragmentKey(float reversedDepth, uint id) { return uvec2(~floatBitsToUint(reversedDepth), id); }

bool isNearer(uvec2 a, uvec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

uvec2 packColor(vec4 premultiplied) {
  return uvec2(packHalf2x16(premultiplied.rg), packHalf2x16(premultiplied.ba));
}

vec4 unpackColor(uvec2 color) { return vec4(unpackHalf2x16(color.x), unpackHalf2x16(color.y)); }
