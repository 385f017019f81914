// Output of a network for a tile of pixels, up to eight values as half floats, all 0 where nothing
// transparent covers it; and its interpolation between tiles.
// NETWORK_TILE: pixels a side of a tile, for shaders that read it.
#include "lib/frame.glsl"
#include "lib/half.glsl"
#include "shared/bindings.h"

struct NetworkOutput {
  vec4 low;
  vec4 high;
};

uvec4 encodeOutput(NetworkOutput o) {
  return uvec4(packHalf2x16(o.low.xy), packHalf2x16(o.low.zw), packHalf2x16(o.high.xy),
               packHalf2x16(o.high.zw));
}

#ifdef NETWORK_TILE
layout(binding = TEX_INPUT2) uniform usampler2D networkOutput;

NetworkOutput outputOf(ivec2 tile) {
  uvec4 words = texelFetch(networkOutput, tile, 0);
  return NetworkOutput(vec4(unpackHalf2x16(words.x), unpackHalf2x16(words.y)),
                       vec4(unpackHalf2x16(words.z), unpackHalf2x16(words.w)));
}

/// Bilinear between the middles of tiles, without the empty ones. A covered pixel's own tile is never
/// empty and never far.
NetworkOutput outputAt(ivec2 p) {
#if NETWORK_TILE == 1
  return outputOf(p);
#else
  // The last tile of this frame: the texture is as large as full rate needs.
  ivec2 last = (ivec2(frame.size) - 1) / NETWORK_TILE;
  vec2 place = (vec2(p) + 0.5) / float(NETWORK_TILE) - 0.5;
  ivec2 corner = ivec2(floor(place));
  vec2 f = place - vec2(corner);
  NetworkOutput sum = NetworkOutput(vec4(0.0), vec4(0.0));
  float weights = 0.0;
  for (int i = 0; i < 4; ++i) {
    ivec2 offset = ivec2(i & 1, i >> 1);
    vec2 near = mix(1.0 - f, f, vec2(offset));
    NetworkOutput o = outputOf(clamp(corner + offset, ivec2(0), last));
    bool empty = o.low == vec4(0.0) && o.high == vec4(0.0);
    float weight = empty ? 0.0 : near.x * near.y;
    sum.low += weight * o.low;
    sum.high += weight * o.high;
    weights += weight;
  }
  return NetworkOutput(sum.low / max(weights, 1e-6), sum.high / max(weights, 1e-6));
#endif
}
#endif
