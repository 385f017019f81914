// Resized transparency over the full-rate image: each pixel takes the mean of the 2x2 texels around it,
// weighted by distance and by how well the opaque surface behind the texel continues that behind the
// pixel (joint bilateral upsampling, Kopf et al. 2007, Eq. 3, with the G-buffer as its guide). A texel
// holds what lies before its own opaque surface: over another one it would be a halo.
#include "shared/dispatch.h"
layout(local_size_x = FULLSCREEN_GROUP, local_size_y = FULLSCREEN_GROUP) in;

#include "lib/frame.glsl"
#include "lib/lod.glsl"
#include "lib/surface.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D resizedColor;  // premultiplied
layout(binding = TEX_INPUT1) uniform sampler2D resizedDepth;
layout(binding = TEX_INPUT2) uniform sampler2D depthTexture;
layout(binding = TEX_INPUT3) uniform sampler2D normalTexture;
layout(rgba16f, binding = IMG_0) uniform image2D hdrColor;
layout(location = 0) uniform vec2 pitch;    // pixels a texel
layout(location = 1) uniform ivec2 texels;  // of the resized image

/// How well a texel's opaque depth fits the pixel's tangent plane, 0..1.
float fitOf(TangentPlane plane, ivec2 p, ivec2 texel, bool surface) {
  float depth = texelFetch(resizedDepth, texel, 0).r;
  if ((depth > 0.0) != surface) return 0.0;
  if (!surface) return 1.0;
  vec2 offset = vec2(pixelAt(texel, pitch, ivec2(frame.size.xy)) - p);
  float miss = 1.0 + planeMiss(plane, offset, inverseDistanceOf(depth));
  return 1.0 / (miss * miss);
}

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (p.x >= int(frame.size.x) || p.y >= int(frame.size.y)) return;
  // Geometry was drawn at the texels' middles, wherever these lie between pixels.
  vec2 place = (vec2(p) + 0.5) / pitch - 0.5;
  ivec2 low = ivec2(floor(place));
  vec2 between = place - vec2(low);
  ivec2 at[4];
  vec4 colors[4];
  bool any = false;
  for (int i = 0; i < 4; ++i) {
    at[i] = clamp(low + ivec2(i & 1, i >> 1), ivec2(0), texels - 1);
    colors[i] = texelFetch(resizedColor, at[i], 0);
    any = any || colors[i] != vec4(0.0);
  }
  if (!any) return;
  float depth = texelFetch(depthTexture, p, 0).r;
  bool surface = depth > 0.0;
  TangentPlane plane;
  if (surface) {
    vec3 normal = decodeOctahedral(texelFetch(normalTexture, p, 0).rg);
    plane = tangentPlaneAt(p, inverseDistanceOf(depth), normal);
  }
  vec4 weights = tentOf(between);
  vec4 fit;
  for (int i = 0; i < 4; ++i) fit[i] = fitOf(plane, p, at[i], surface);
  vec4 reached = mix(vec4(0.0), fit, greaterThan(weights, vec4(0.0)));
  float best = max(max(reached.x, reached.y), max(reached.z, reached.w));
  weights = best >= kLeastFit ? weights * fit : vec4(greaterThanEqual(reached, vec4(best)));
  vec4 color = vec4(0.0);
  for (int i = 0; i < 4; ++i) color += weights[i] * colors[i];
  color /= dot(weights, vec4(1.0));
  imageStore(hdrColor, p, vec4(color.rgb + (1.0 - color.a) * imageLoad(hdrColor, p).rgb, 1.0));
}
