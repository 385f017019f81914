// Samples to pixels, exposure, tone curve, encoding. SSAA: samples per axis of a pixel.
// LINEAR_OUT: also write the image before encoding.
#include "shared/dispatch.h"
layout(local_size_x = FULLSCREEN_GROUP, local_size_y = FULLSCREEN_GROUP) in;

#include "lib/half.glsl"
#include "lib/tonemap.glsl"
#include "shared/bindings.h"

layout(binding = TEX_INPUT0) uniform sampler2D hdrColor;
layout(rgba8, binding = IMG_0) writeonly uniform image2D displayColor;
#ifdef LINEAR_OUT
layout(rgba32f, binding = IMG_1) writeonly uniform image2D linearColor;
#endif
layout(location = 0) uniform float exposure;

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, imageSize(displayColor)))) return;
  vec3 sum = vec3(0.0);
  for (int y = 0; y < SSAA; ++y) {
    for (int x = 0; x < SSAA; ++x) {
      // Blending in half floats may have come to infinity, of which a tone curve makes NaN.
      sum += min(texelFetch(hdrColor, p * SSAA + ivec2(x, y), 0).rgb, vec3(kMaxHalf));
    }
  }
  vec3 c = tonemap(sum * (exposure / float(SSAA * SSAA)));
#ifdef LINEAR_OUT
  imageStore(linearColor, p, vec4(c, 1.0));
#endif
  c = clamp(c, 0.0, 1.0);
#if TONEMAP != 0
  c = encodeSrgb(c);
#endif
  imageStore(displayColor, p, vec4(c, 1.0));
}
