// Composites the weighted mean colour over the image (McGuire and Bavoil 2013, Eq. 6).
#include "shared/dispatch.h"
layout(local_size_x = FULLSCREEN_GROUP, local_size_y = FULLSCREEN_GROUP) in;

#include "lib/frame.glsl"
#include "lib/half.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D weighted;
layout(binding = TEX_INPUT1) uniform sampler2D coverage;
layout(rgba16f, binding = IMG_0) uniform image2D hdrColor;

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (p.x >= int(frame.size.x) || p.y >= int(frame.size.y)) return;
  vec4 sum = texelFetch(weighted, p, 0);
  if (sum.a <= 0.0) return;
  float transmittance = exp2(-texelFetch(coverage, p, 0).a);
  // Over the image, whose alpha is 1, or at a reduced rate over nothing.
  vec4 behind = imageLoad(hdrColor, p);
  vec3 color = sum.rgb / sum.a * (1.0 - transmittance) + behind.rgb * transmittance;
  imageStore(hdrColor, p, vec4(min(color, vec3(kMaxHalf)), 1.0 - transmittance * (1.0 - behind.a)));
}
