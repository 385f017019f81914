// The farthest opaque depth of a tile, so that every fragment that is visible in one of its pixels is
// counted.
#include "lib/frame.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D opaqueDepth;

void main() {
  int tile = int(frame.sliceTile);
  ivec2 first = ivec2(gl_FragCoord.xy) * tile;
  ivec2 last = min(first + tile, ivec2(frame.size)) - 1;
  float farthest = 1.0;
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) {
      farthest = min(farthest, texelFetch(opaqueDepth, ivec2(x, y), 0).r);
    }
  }
  gl_FragDepth = farthest;
}
