// Approximate colour of a transparent layer, for predictions: without shadows, highlights, reflections
// and normal maps, but with how colours differ. LIT: the run's materials are lit.

/// @param base colour and alpha before the alpha mode
/// @param light radiance that a white diffuse surface reflects; unused where not LIT
/// @return radiance and coverage, premultiplied
vec4 predictedLayer(MaterialData m, vec4 base, vec3 light) {
#ifdef LIT
  float transmission = m.transmission.w;
  vec3 tint = base.rgb * m.transmission.rgb;
  float least = min(tint.r, min(tint.g, tint.b));
  vec3 color = base.rgb * (1.0 - m.surface.x) * light * (1.0 - transmission) + m.emissive.rgb +
               transmission * (tint - least) * light;
  return vec4(color, 1.0 - transmission * least) * alphaOf(m, base.a);
#else
  return vec4(base.rgb, 1.0) * alphaOf(m, base.a);
#endif
}
