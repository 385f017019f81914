// The twelve features of Tsopouridis 2021, section 4.2. Depths are distances along the view axis in
// units of that of the far plane. Where the thesis has "the RGB color" of fragments, this is their
// premultiplied colour, so that clear layers count for less. Needs the buffer `totals`.
#include "shared/network.h"

layout(binding = TEX_INPUT1) uniform sampler2D depthRange;
layout(binding = TEX_INPUT3) uniform sampler2D colorSums;
layout(binding = TEX_INPUT4) uniform sampler2D nearestColor;

/// View distance of a reversed depth, as a share of the far plane's.
float farShare(float depth) {
  float nearPlane = frame.nearPlane;
  float farPlane = frame.farPlane;
  return nearPlane / (nearPlane + depth * (farPlane - nearPlane));
}

/// The features of pixel p with n fragments.
void findFeatures(ivec2 p, float n, out float x[INPUTS]) {
  vec2 range = texelFetch(depthRange, p, 0).rg;
  vec3 blend = texelFetch(colorSums, p, 0).rgb / n;
  vec3 nearest = vec3(floatBitsToUint(texelFetch(nearestColor, p, 0).rgb) & 0xFFu) / 255.0;
  float total = float(totals.extent.x);
  // The pixel's share of all fragments, times the number of covered pixels. A share alone is some
  // millionths, and depends on the size of the image.
  x[0] = n * float(totals.extent.w) / total;
  x[1] = float(frame.slots) / total;
  x[2] = farShare(range.x);
  x[3] = farShare(-range.y);
  x[4] = farShare(uintBitsToFloat(totals.extent.y));
  x[5] = farShare(uintBitsToFloat(~totals.extent.z));
  for (int i = 0; i < 3; ++i) {
    x[6 + i] = blend[i];
    x[9 + i] = nearest[i];
  }
}
