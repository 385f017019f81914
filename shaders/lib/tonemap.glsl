// From linear radiance to display values. TONEMAP: 0 none, 1 neutral, 2 ACES.

vec3 tonemap(vec3 c) {
#if TONEMAP == 1
  // Khronos PBR Neutral Tone Mapper (2024): base colours below 0.8 - F90 stay as they are.
  const float kStart = 0.8 - 0.04;
  const float kDesaturation = 0.15;
  float x = min(c.r, min(c.g, c.b));
  float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
  c -= offset;
  float peak = max(c.r, max(c.g, c.b));
  if (peak < kStart) return c;
  float d = 1.0 - kStart;
  float newPeak = 1.0 - d * d / (peak + d - kStart);
  c *= newPeak / peak;
  float g = 1.0 - 1.0 / (kDesaturation * (peak - newPeak) + 1.0);
  return mix(c, vec3(newPeak), g);
#elif TONEMAP == 2
  // Narkowicz 2015, "ACES Filmic Tone Mapping Curve".
  return clamp((c * (2.51 * c + 0.03)) / (c * (2.43 * c + 0.59) + 0.14), 0.0, 1.0);
#else
  return c;
#endif
}

/// sRGB transfer function (IEC 61966-2-1).
vec3 encodeSrgb(vec3 c) {
  vec3 low = c * 12.92;
  vec3 high = 1.055 * pow(max(c, vec3(1e-8)), vec3(1.0 / 2.4)) - 0.055;
  return mix(high, low, lessThanEqual(c, vec3(0.0031308)));
}
