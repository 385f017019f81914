// Reduced-rate transparency over the full-rate image: each pixel takes the mean of the 2x2 texels around
// it, weighted by distance and by how well the opaque surface behind the texel continues that behind
// the pixel (joint bilateral upsampling, Kopf et al. 2007, Eq. 3, with the G-buffer as its guide). A
// texel holds what lies before its own opaque surface: over another one it would be a halo.
// NOTHING_OPAQUE: no surface lies behind any pixel, and so there is no G-buffer.
// A thread takes the pixels between the same texels, so that these are fetched once for all.
#include "shared/dispatch.h"
layout(local_size_x = FULLSCREEN_GROUP, local_size_y = FULLSCREEN_GROUP) in;

#include "lib/frame.glsl"
#include "lib/lod.glsl"
#include "lib/surface.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D reducedColor;  // premultiplied
layout(binding = TEX_INPUT1) uniform sampler2D reducedDepth;
layout(binding = TEX_INPUT2) uniform sampler2D depthTexture;
layout(binding = TEX_INPUT3) uniform sampler2D normalTexture;
layout(rgba16f, binding = IMG_0) uniform image2D hdrColor;
layout(location = 0) uniform vec2 pitch;    // pixels a texel
layout(location = 1) uniform ivec2 texels;  // of the reduced-rate image

/// The texels around some pixels, lower left to upper right.
struct Texels {
  vec4 colors[4];
  vec4 depths;
  ivec2 pixels[4];  // whose opaque depths they have
};

/// How well the texels' opaque depths fit a pixel's surface, 0..1.
vec4 fitOf(Texels around, ivec2 p) {
#ifdef NOTHING_OPAQUE
  return vec4(equal(around.depths, vec4(0.0)));
#else
  float depth = texelFetch(depthTexture, p, 0).r;
  // The far plane is the background.
  if (depth == 0.0) return vec4(equal(around.depths, vec4(0.0)));
  vec3 normal = decodeOctahedral(texelFetch(normalTexture, p, 0).rg);
  TangentPlane plane = tangentPlaneAt(p, inverseDistanceOf(depth), normal);
  vec4 fit;
  for (int i = 0; i < 4; ++i) {
    vec2 offset = vec2(around.pixels[i] - p);
    float miss = 1.0 + planeMiss(plane, offset, inverseDistanceOf(around.depths[i]));
    fit[i] = around.depths[i] > 0.0 ? 1.0 / (miss * miss) : 0.0;
  }
  return fit;
#endif
}

/// @param between where the pixel lies between the texels, 0..1
vec4 colorAt(Texels around, ivec2 p, vec2 between) {
  bool fits;
  vec4 weights = fittedWeights(tentOf(between), fitOf(around, p), fits);
  vec4 color = vec4(0.0);
  for (int i = 0; i < 4; ++i) color += weights[i] * around.colors[i];
  return color / dot(weights, vec4(1.0));
}

/// The first pixel whose middle does not lie before that of a texel. Geometry was drawn at the
/// texels' middles, wherever these lie between pixels.
ivec2 firstPixel(ivec2 texel) {
  // Neighbouring threads must agree on it to the last bit.
  precise vec2 first = (vec2(texel) + 0.5) * pitch - 0.5;
  return ivec2(ceil(first));
}

void main() {
  ivec2 low = ivec2(gl_GlobalInvocationID.xy) - 1;  // before the first texel there are pixels, too
  ivec2 size = ivec2(frame.size);
  ivec2 from = max(firstPixel(low), ivec2(0));
  ivec2 to = min(firstPixel(low + 1), size);
  Texels around;
  bool any = false;
  for (int i = 0; i < 4; ++i) {
    ivec2 texel = clamp(low + ivec2(i & 1, i >> 1), ivec2(0), texels - 1);
    around.colors[i] = texelFetch(reducedColor, texel, 0);
    around.depths[i] = texelFetch(reducedDepth, texel, 0).r;
    around.pixels[i] = pixelAt(texel, pitch, size);
    any = any || around.colors[i] != vec4(0.0);
  }
  if (!any) return;
  for (int y = from.y; y < to.y; ++y) {
    for (int x = from.x; x < to.x; ++x) {
      ivec2 p = ivec2(x, y);
      vec4 color = colorAt(around, p, clamp((vec2(p) + 0.5) / pitch - 0.5 - vec2(low), 0.0, 1.0));
      vec3 behind = imageLoad(hdrColor, p).rgb;
      imageStore(hdrColor, p, vec4(color.rgb + (1.0 - color.a) * behind, 1.0));
    }
  }
}
