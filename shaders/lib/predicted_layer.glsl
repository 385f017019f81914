// Approximate colour of a transparent layer, for predictions: without shadows, highlights, reflections
// and normal maps, but with how colours differ. LIT: the run's material is lit. TRANSMISSION: it transmits.
#include "lib/run_material.glsl"

/// @param base colour and alpha before the alpha mode
/// @param light radiance that a white diffuse surface reflects; unused where not LIT
/// @return radiance and coverage, premultiplied
vec4 predictedLayer(vec4 base, vec3 light) {
#ifdef LIT
  vec3 color = base.rgb * (1.0 - material.surface.x) * light;
  float alpha = 1.0;
#ifdef TRANSMISSION
  float transmission = material.transmission.w;
  vec3 tint = base.rgb * material.transmission.rgb;
  float least = min(tint.r, min(tint.g, tint.b));
  color = color * (1.0 - transmission) + transmission * (tint - least) * light;
  alpha = 1.0 - transmission * least;
#endif
  return vec4(color + material.emissive.rgb, alpha) * alphaOf(base.a);
#else
  return vec4(base.rgb, 1.0) * alphaOf(base.a);
#endif
}
