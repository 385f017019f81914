// A quantity as colours over the darkened image. SOURCE_INTEGER: slots of a pixel. SOURCE_RATE: the
// shading rate of tiles, with the image's light and dark in it.
#include "shared/dispatch.h"
layout(local_size_x = FULLSCREEN_GROUP, local_size_y = FULLSCREEN_GROUP) in;

#include "lib/viridis.glsl"
#include "shared/bindings.h"
#ifdef SOURCE_RATE
#include "lib/frame.glsl"
#include "lib/lod.glsl"
#endif
#include "shared/oit_constants.h"

#if defined(SOURCE_INTEGER) || defined(SOURCE_RATE)
layout(binding = TEX_INPUT0) uniform usampler2D source;
#else
layout(binding = TEX_INPUT0) uniform sampler2D source;
#endif
layout(rgba8, binding = IMG_0) readonly uniform image2D displayColor;
layout(rgba8, binding = IMG_1) writeonly uniform image2D heatmapColor;
layout(location = 0) uniform float range;
layout(location = 1) uniform int samplesPerAxis;
#ifdef SOURCE_INTEGER
layout(location = 2) uniform uint tailSlots;  // of a pixel that has a tail
#endif

#ifdef SOURCE_RATE
layout(location = 3) uniform float texelsOfPixel;  // of the reduced-rate image
#else
layout(location = 4) uniform vec2 texelsOfSample;  // at which transparency is drawn; 1 at full rate
#endif

#ifndef SOURCE_RATE
ivec2 texelOf(ivec2 p) { return ivec2((vec2(p * samplesPerAxis) + 0.5) * texelsOfSample); }
#endif

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, imageSize(displayColor)))) return;
#ifdef SOURCE_INTEGER
  uint slots = texelFetch(source, texelOf(p), 0).SOURCE_CHANNEL;
  float value = float((slots & ~RANGE_TAIL) + ((slots & RANGE_TAIL) != 0u ? tailSlots : 0u));
#elif defined(SOURCE_RATE)
  ivec2 tile = ivec2((vec2(p) + 0.5) * texelsOfPixel) >> LOD_TILE_SHIFT;
  float value = float(levelAround(texelFetch(source, tile, 0).r, ivec2(0)));
#else
  float value = texelFetch(source, texelOf(p), 0).SOURCE_CHANNEL;
#endif
  vec3 image = imageLoad(displayColor, p).rgb;
  // Where there is nothing to show, the image stays to be recognised, without its colours.
  float grey = dot(image, vec3(0.2126, 0.7152, 0.0722));
  vec3 color = value > 0.0 ? viridis(value / range) : vec3(0.35 * grey);
#ifdef SOURCE_RATE
  // Every pixel has a rate: without the image's light and dark nothing would be recognised.
  color = viridis(value / range) * (0.45 + 0.55 * sqrt(grey));
#endif
  imageStore(heatmapColor, p, vec4(color, 1.0));
}
