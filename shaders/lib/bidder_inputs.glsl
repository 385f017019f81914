// Reads what a pixel bids by. For the passes that search for the price and that share the slots out.
#include "lib/bids.glsl"
#if defined(BID_TRANSMITTANCE) || defined(BID_ERROR)
#include "lib/raster.glsl"
#endif
#ifdef BID_LEARNED
#include "lib/network_output.glsl"
#endif

layout(binding = TEX_INPUT0) uniform sampler2D fragmentCount;
#ifdef BID_IMPORTANCE
layout(r32ui, binding = IMG_2) readonly uniform uimage2D importance;
#endif
#if defined(BID_TRANSMITTANCE) || defined(BID_ERROR)
layout(location = 0) uniform vec2 gazeSettings;  // periphery (d of Eq. 4), weight of the gaze
layout(binding = TEX_INPUT1) uniform sampler2D opaqueColor;
layout(location = 1) uniform vec2 pitch;  // samples of the opaque image a pixel; 1 at full rate
#endif

/// Slots that the pixel of n fragments takes at these prices (log2).
Bids bidAt(ivec2 p, uint n, vec4 prices[BID_VECTORS]) {
#if defined(BID_TRANSMITTANCE) || defined(BID_ERROR)
  float weight = 1.0;
  if (gazeSettings.y > 0.0) {
    float seen = peripheryFactor(vec2(p) + 0.5, ImportanceSettings(0.0, gazeSettings.x, 0.0, 1.0));
    weight = mix(1.0, seen * seen, gazeSettings.y);
  }
  Correction correction = Correction(vec4(1.0), vec4(0.0));
#ifdef BID_LEARNED
  NetworkOutput said = outputAt(p);
  correction = Correction(exp2(said.low), kUnknownOrder * exp2(said.high));
#endif
  ivec2 behind = pixelAt(p, pitch, textureSize(opaqueColor, 0));
  return bid(p, n, prices, texelFetch(opaqueColor, behind, 0).rgb, weight, correction);
#elif defined(BID_IMPORTANCE)
  return bid(n, prices, float(imageLoad(importance, p).r) / float(IMPORTANCE_ONE));
#else
  return bid(n, prices, 1.0);
#endif
}
