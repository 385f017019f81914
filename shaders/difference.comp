// How far two pictures are apart: the largest absolute difference of red, green and blue on display
// values, amplified and in the colours of the heat maps (thesis 3.3 shows its methods so).
#include "shared/dispatch.h"
layout(local_size_x = FULLSCREEN_GROUP, local_size_y = FULLSCREEN_GROUP) in;

#include "lib/viridis.glsl"
#include "shared/bindings.h"

layout(binding = TEX_INPUT0) uniform sampler2D first;
layout(binding = TEX_INPUT1) uniform sampler2D second;
layout(rgba8, binding = IMG_0) writeonly uniform image2D map;
layout(location = 0) uniform float scale;  // a difference of 1 / scale is the hottest colour

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, imageSize(map)))) return;
  vec3 a = texelFetch(first, p, 0).rgb;
  vec3 d = abs(a - texelFetch(second, p, 0).rgb);
  float value = max(d.r, max(d.g, d.b));
  // Where they are equal, the picture stays to be recognised, without its colours.
  float grey = dot(a, vec3(0.2126, 0.7152, 0.0722));
  imageStore(map, p, vec4(value > 0.0 ? viridis(value * scale) : vec3(0.35 * grey), 1.0));
}
