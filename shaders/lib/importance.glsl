// Importance of a pixel (Vasilakis 2017, Eq. 3-6), each factor clamped to 0..1.
#include "lib/frame.glsl"
#include "lib/hash.glsl"

/// Where the eye looks. Read once, before a loop over pixels: Mesa's compilers read constants of the frame
/// again wherever a loop names them, which took a third of the time of importance.
struct Gaze {
  vec2 place;
  float spread;
  float reach;  // pixels at which 2 d of Eq. 4 is 1
};

Gaze gazeOfFrame() { return Gaze(frame.gaze, frame.gazeSpread, 1.1 * length(frame.size)); }

struct ImportanceSettings {
  float rangeBias;   // alpha of Eq. 3
  float periphery;   // d of Eq. 4
  float noise;       // lambda of Eq. 6
  float layerLimit;  // N_limit of Eq. 3
};

/// Eq. 3.
float depthComplexityFactor(float layers, ImportanceSettings s) {
  return clamp(s.rangeBias + (1.0 - s.rangeBias) * min(1.0, layers / s.layerLimit), 0.0, 1.0);
}

/// Eq. 4. Clamped: off centre the paper's form falls below 0 beyond 0.55 of the diagonal. The distance
/// is to the disc in which the gaze may be, whose radius is 0 where the gaze is certain.
float peripheryFactor(vec2 pixelCenter, Gaze gaze, float periphery) {
  float away = max(0.0, distance(pixelCenter, gaze.place) - gaze.spread);
  float x = 2.0 * away / gaze.reach;
  return clamp(1.0 - pow(x, periphery), 0.0, 1.0);
}

/// Eq. 5. normal.w: 1 where the last frame had a transparent surface here.
float fresnelFactor(vec4 normal, vec3 toEye) {
  if (normal.w <= 0.0) return 1.0;
  float x = 1.0 - clamp(dot(normalize(normal.xyz), toEye), 0.0, 1.0);
  float x2 = x * x;
  return 1.0 - 0.5 * x2 * x2 * x;
}

/// The noise of Eq. 6: lambda (xi - 0.5), static over frames unless the seed changes.
float noiseTerm(ivec2 pixel, uint hashedSeed, ImportanceSettings s) {
  uint h = hashPcg(uint(pixel.x) + hashPcg(uint(pixel.y) + hashedSeed));
  return s.noise * (float(h >> 8) / 16777216.0 - 0.5);  // 24 bits: exact in a float
}
