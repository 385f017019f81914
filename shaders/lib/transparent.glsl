// Radiance and coverage of a transparent fragment, premultiplied.
// LIT: the run's material is lit. TRANSMISSION: it transmits. VERTEX_LIGHT: a cheap approximation of
// both instead, for predictions, with light from the vertices; without textures and alpha tests (TEXTURED,
// HOLED) the whole layer comes from the vertices.
#include "lib/frame.glsl"
#if defined(VERTEX_LIGHT) && !defined(TEXTURED) && !defined(HOLED)
layout(location = 3) in vec4 inFrontLayer;
layout(location = 4) in vec4 inBackLayer;

vec4 approximateTransparent() { return gl_FrontFacing ? inFrontLayer : inBackLayer; }
#else
#include "lib/material.glsl"
#include "lib/predicted_layer.glsl"
#if defined(LIT) && !defined(VERTEX_LIGHT)
#include "lib/lighting.glsl"
#endif

#if !defined(LIT) || !defined(VERTEX_LIGHT)
/// KHR_materials_transmission as a thin tinted sheet without refraction. The light behind is scaled
/// by one number, the least channel of the tint, because a layer stores one alpha. The light that the
/// other channels transmit in addition is approximated by the ambient radiance, which is exact where the
/// background equals it.
vec4 shadeTransparent() {
#ifdef LIT
  SurfacePoint s = findSurface();
  Radiance r = lightSurface(s, frame.eye.xyz);
#ifdef TRANSMISSION
  float transmission = material.transmission.w;
  vec3 v = normalize(frame.eye.xyz - s.position);
  float fresnel = fresnelSchlick(vec3(kDielectricF0), abs(dot(s.normal, v))).x;
  vec3 tint = s.baseColor * material.transmission.rgb;
  float least = min(tint.r, min(tint.g, tint.b));
  float through = transmission * (1.0 - fresnel);
  vec3 color = r.specular + r.diffuse * (1.0 - transmission) + s.emissive +
               through * (tint - least) * ambientRadiance(-v);
  return vec4(color, 1.0 - through * least) * s.alpha;
#else
  return vec4((r.diffuse + r.specular + s.emissive) * s.alpha, s.alpha);
#endif
#else
  vec4 color = baseColor();
  float alpha = alphaOf(color.a);
  return vec4(color.rgb * alpha, alpha);
#endif
}
#endif

#ifdef VERTEX_LIGHT
vec4 approximateTransparent() {
#ifdef LIT
  return predictedLayer(baseColor(), facing() > 0.0 ? inFrontLight : inBackLight);
#else
  return shadeTransparent();
#endif
}
#endif
#endif
