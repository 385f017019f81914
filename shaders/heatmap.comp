// A quantity as colours over the darkened image.
layout(local_size_x = 8, local_size_y = 8) in;

#include "shared/bindings.h"

#ifdef SOURCE_INTEGER
layout(binding = TEX_INPUT0) uniform usampler2D source;
#else
layout(binding = TEX_INPUT0) uniform sampler2D source;
#endif
layout(rgba8, binding = IMG_0) uniform image2D displayColor;
layout(location = 0) uniform float range;
layout(location = 1) uniform int samplesPerAxis;

/// Five points of the viridis map (van der Walt and Smith 2015), which grows evenly in lightness.
vec3 viridis(float t) {
  const vec3 c[5] = vec3[](vec3(0.267, 0.005, 0.329), vec3(0.230, 0.322, 0.546),
                           vec3(0.128, 0.567, 0.551), vec3(0.369, 0.789, 0.383),
                           vec3(0.993, 0.906, 0.144));
  float x = clamp(t, 0.0, 1.0) * 4.0;
  int i = min(int(x), 3);
  return mix(c[i], c[i + 1], x - float(i));
}

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, imageSize(displayColor)))) return;
  float value = float(texelFetch(source, p * samplesPerAxis, 0).SOURCE_CHANNEL);
  vec3 image = imageLoad(displayColor, p).rgb;
  // Where there is nothing to show, the image stays to be recognised, without its colours.
  float grey = dot(image, vec3(0.2126, 0.7152, 0.0722));
  vec3 color = value > 0.0 ? viridis(value / range) : vec3(0.35 * grey);
  imageStore(displayColor, p, vec4(color, 1.0));
}
