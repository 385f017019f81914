// Composites the peeled layer behind those before it, and empties its ids. FINISH: composites all of them over the opaque
// image.
#include "shared/dispatch.h"
layout(local_size_x = FULLSCREEN_GROUP, local_size_y = FULLSCREEN_GROUP) in;

#include "lib/frame.glsl"
#include "lib/oit.glsl"

// Layers so far: colour, transmittance.
#ifdef FINISH
layout(rgba32f, binding = IMG_2) readonly uniform image2D sum;
layout(rgba16f, binding = IMG_3) uniform image2D hdrColor;
#else
layout(rgba32f, binding = IMG_2) uniform image2D sum;
layout(binding = TEX_INPUT1) uniform sampler2D layerDepth;
layout(binding = TEX_INPUT2) uniform sampler2D layerColor;
layout(rg32ui, binding = IMG_0) writeonly uniform uimage2D lastKey;
layout(r32ui, binding = IMG_1) uniform uimage2D ids;
#endif

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (p.x >= int(frame.size.x) || p.y >= int(frame.size.y)) return;
  vec4 s = imageLoad(sum, p);
#ifdef FINISH
  if (s == vec4(0.0, 0.0, 0.0, 1.0)) return;
  // Over the image, whose alpha is 1, or at a reduced rate over nothing.
  vec4 behind = imageLoad(hdrColor, p);
  vec3 color = min(s.rgb + s.a * behind.rgb, vec3(kMaxHalf));
  imageStore(hdrColor, p, vec4(color, 1.0 - s.a * (1.0 - behind.a)));
#else
  uint id = imageLoad(ids, p).r;
  if (id == NO_KEY) return;
  imageStore(ids, p, uvec4(NO_KEY));  // for the next layer
  vec4 layer = texelFetch(layerColor, p, 0);
  imageStore(sum, p, vec4(s.rgb + s.a * layer.rgb, s.a * (1.0 - layer.a)));
  imageStore(lastKey, p, uvec4(fragmentKey(texelFetch(layerDepth, p, 0).r, id), 0u, 0u));
#endif
}
