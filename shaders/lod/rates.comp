// Shading rate of each tile of the reduced-rate image by the distance from the point of interest, and
// lists of the tiles of each rate.
#include "shared/dispatch.h"
layout(local_size_x = FULLSCREEN_GROUP, local_size_y = FULLSCREEN_GROUP) in;

#include "lib/frame.glsl"
#include "lib/lod.glsl"

layout(r32ui, binding = IMG_0) writeonly uniform uimage2D shadingRate;
layout(std430, binding = SSBO_LOD_TILES) writeonly buffer Tiles { uint tiles[]; };
layout(std430, binding = SSBO_LOD_TOTALS) buffer Totals { LodTotals totals; };

/// Full-rate samples that may share one sample of the shading where the eye resolves
/// MAR(e) = slope e + w0 (Guenter et al. 2012, section 3). Mirrored in tests/gl/lod_mirror.cpp.
float allowedPitch(vec2 place) {
  vec2 middle = 0.5 * frame.size;
  // Where the gaze is uncertain, all of a disc is looked at.
  vec2 away = place - frame.gaze;
  float distance = length(away);
  vec2 nearest = frame.gaze + away * (max(distance - frame.gazeSpread, 0.0) / max(distance, 1e-3));
  vec3 toGaze = normalize(vec3(frame.gaze - middle, frame.viewerDistance));
  vec3 toPlace = normalize(vec3(nearest - middle, frame.viewerDistance));
  // Not acos of the dot product, which loses small angles to rounding.
  float eccentricity = degrees(atan(length(cross(toGaze, toPlace)), dot(toGaze, toPlace)));
  float mar = frame.acuitySlope * eccentricity + frame.fovealMar;
  return radians(mar) * frame.viewerDistance / frame.samplesPerMar;
}

#include "lib/list_dispatch.glsl"

int levelOf(ivec2 tile) {
  vec2 low = vec2(tile * LOD_TILE) * frame.pitch;
  vec2 high = low + float(LOD_TILE) * frame.pitch;
  float allowed = allowedPitch(clamp(frame.gaze, low, high));
  int level = 0;
  while (float(2 << level) * frame.pitch <= allowed && float(2 << level) <= frame.coarsestRate) {
    ++level;
  }
  return level;
}

void main() {
  ivec2 tile = ivec2(gl_GlobalInvocationID.xy);
  if (tile.x >= frame.lodTiles.x || tile.y >= frame.lodTiles.y) return;
  uint around = 0u;
  for (int i = 0; i < 9; ++i) {
    ivec2 other = clamp(tile + ivec2(i % 3, i / 3) - 1, ivec2(0), frame.lodTiles - 1);
    around |= uint(levelOf(other)) << uint(2 * i);
  }
  imageStore(shadingRate, tile, uvec4(around));
  int level = levelAround(around, ivec2(0));
  uint number = uint(tile.y * frame.lodTiles.x + tile.x);
  uint entry = atomicAdd(totals.dispatches[level].w, 1u);
  tiles[uint(level * frame.lodTiles.x * frame.lodTiles.y) + entry] = number;
  int side = LOD_TILE >> level;
  uint groups = ((entry + 1u) * uint(side * side) + uint(LIST_GROUP) - 1u) / uint(LIST_GROUP);
  growDispatch(level, groups);
  ivec2 inside = min(frame.lodTexels - tile * LOD_TILE, ivec2(LOD_TILE));
  ivec2 cells = (inside + (1 << level) - 1) >> level;
  atomicAdd(totals.shaded, uint(cells.x * cells.y));
}
