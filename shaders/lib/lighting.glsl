// Light that leaves a surface point towards the eye: the same functions for opaque and transparent
// surfaces. SHADOWS: a shadow map is bound. ENVIRONMENT: a panorama is bound.
// DEMODULATE: the part that is proportional to the base colour is also returned separately.
#include "lib/brdf.glsl"
#include "lib/surface.glsl"
#include "shared/bindings.h"
#include "shared/scene_data.h"

layout(std140, binding = UBO_LIGHTS) uniform LightUniforms { LightBlock lights; };
#ifdef SHADOWS
layout(binding = TEX_SHADOW_MAP) uniform sampler2DShadow shadowMap;
#endif
#ifdef ENVIRONMENT
layout(binding = TEX_ENVIRONMENT) uniform sampler2D environmentMap;
#endif

#ifdef SHADOWS
#ifndef SHADOW_TAPS
#define SHADOW_TAPS 3
#endif

/// Percentage-closer filtering (Reeves et al. 1987) over SHADOW_TAPS x SHADOW_TAPS bilinear
/// comparisons.
/// @param normal the geometric one: moved along that of a normal map, the receiver might still shadow
/// itself
float shadowFactor(vec3 position, vec3 normal, vec3 toLight) {
  float texel = 1.0 / float(textureSize(shadowMap, 0).x);
  // Moving the receiver along its normal by some texels of the map hides self-shadowing; more at
  // grazing light, where one texel covers more of the surface.
  float grazing = sqrt(max(0.0, 1.0 - dot(normal, toLight) * dot(normal, toLight)));
  const int kReach = SHADOW_TAPS / 2;
  float width = max(float(kReach), 1.0);
  vec3 p = position + normal * (lights.shadow.x * texel * width * (0.75 + 1.5 * grazing));
  vec3 uvz = (lights.shadowMatrix * vec4(p, 1.0)).xyz;
  float sum = 0.0;
  for (int y = -kReach; y <= kReach; ++y) {
    for (int x = -kReach; x <= kReach; ++x) {
      sum += texture(shadowMap, uvz + vec3(vec2(x, y) * texel, 0.0));
    }
  }
  return sum / float(SHADOW_TAPS * SHADOW_TAPS);
}
#endif

/// Share of the shadow-casting light that arrives; 1 where the surface faces away from it, normal
/// map or not.
float shadowAt(SurfacePoint s) {
#ifdef SHADOWS
  int count = int(lights.ambient.w);
  for (int i = 0; i < count; ++i) {
    if (lights.lights[i].color.w == 0.0) continue;
    vec3 l = -lights.lights[i].direction.xyz;
    bool faces = max(dot(s.normal, l), dot(s.geometricNormal, l)) > 0.0;
    return faces ? shadowFactor(s.position, s.geometricNormal, l) : 1.0;
  }
#endif
  return 1.0;
}

#ifdef ENVIRONMENT
vec2 panoramaUv(vec3 d) {
  return vec2(atan(d.x, -d.z) / (2.0 * kPi) + 0.5, acos(clamp(d.y, -1.0, 1.0)) / kPi);
}

vec3 environmentRadiance(vec3 direction, float roughness) {
  return textureLod(environmentMap, panoramaUv(direction), roughness * (lights.environment.x - 1.0)).rgb;
}
#endif

/// Irradiance over pi from all directions: spherical harmonics or the constant ambient term.
vec3 ambientRadiance(vec3 n) {
#ifdef ENVIRONMENT
  vec3 sum = lights.irradiance[0].rgb * 0.282095;
  sum += lights.irradiance[1].rgb * (0.488603 * n.y);
  sum += lights.irradiance[2].rgb * (0.488603 * n.z);
  sum += lights.irradiance[3].rgb * (0.488603 * n.x);
  sum += lights.irradiance[4].rgb * (1.092548 * n.x * n.y);
  sum += lights.irradiance[5].rgb * (1.092548 * n.y * n.z);
  sum += lights.irradiance[6].rgb * (0.315392 * (3.0 * n.z * n.z - 1.0));
  sum += lights.irradiance[7].rgb * (1.092548 * n.x * n.z);
  sum += lights.irradiance[8].rgb * (0.546274 * (n.x * n.x - n.y * n.y));
  return max(sum, vec3(0.0));
#else
  return lights.ambient.rgb;
#endif
}

/// Attenuation of a light at a position; `l` becomes the unit vector towards it.
float lightTowards(LightData light, vec3 position, out vec3 l) {
  l = -light.direction.xyz;
  uint type = uint(light.position.w);
  if (type == LIGHT_DIRECTIONAL) return 1.0;
  vec3 d = light.position.xyz - position;
  float d2 = max(dot(d, d), lights.shadow.y);  // for a light on the surface
  l = d * inversesqrt(d2);
  // KHR_lights_punctual, "Range Property".
  float range = light.direction.w;
  float q = range > 0.0 ? d2 / (range * range) : 0.0;
  float attenuation = clamp(1.0 - q * q, 0.0, 1.0) / d2;
  if (type != LIGHT_SPOT) return attenuation;
  float a = clamp(dot(light.direction.xyz, -l) * light.cone.x + light.cone.y, 0.0, 1.0);
  return attenuation * a * a;
}

/// Irradiance of all lights without shadows.
vec3 irradianceAt(vec3 position, vec3 normal) {
  vec3 sum = vec3(0.0);
  int count = int(lights.ambient.w);
  for (int i = 0; i < count; ++i) {
    vec3 l;
    float attenuation = lightTowards(lights.lights[i], position, l);
    sum += lights.lights[i].color.rgb * (attenuation * max(dot(normal, l), 0.0));
  }
  return sum;
}

/// Radiance of a surface point towards the eye, specular separately so that transparency can weight
/// it.
struct Radiance {
  vec3 diffuse;
  vec3 specular;
#ifdef DEMODULATE
  vec3 perColor;  // the part of both that is proportional to the base colour, divided by it
#endif
};

/// @param shadow see shadowAt()
Radiance lightSurface(SurfacePoint s, vec3 eye, float shadow) {
  Reflection r = reflectionOf(s.baseColor, s.metallic, s.roughness);
  vec3 v = normalize(eye - s.position);
  float nDotV = max(dot(s.normal, v), 1e-4);  // normal maps can turn away from the eye
  Radiance sum;
  sum.diffuse = vec3(0.0);
  sum.specular = vec3(0.0);
#ifdef DEMODULATE
  sum.perColor = vec3(0.0);
#endif
  int count = int(lights.ambient.w);
  for (int i = 0; i < count; ++i) {
    LightData light = lights.lights[i];
    vec3 l;
    float attenuation = lightTowards(light, s.position, l);
    float nDotL = dot(s.normal, l);
    if (nDotL <= 0.0 || attenuation <= 0.0) continue;
    if (light.color.w > 0.0) attenuation *= shadow;
    vec3 h = normalize(l + v);
    vec3 f = fresnelSchlick(r.f0, max(dot(v, h), 0.0));
    vec3 incoming = light.color.rgb * (attenuation * nDotL);
    float lobe = specularGgx(r.alpha, max(dot(s.normal, h), 0.0), nDotL, nDotV);
    sum.diffuse += incoming * (1.0 - f) * r.diffuse / kPi;
    sum.specular += incoming * f * lobe;
#ifdef DEMODULATE
    float slope = fresnelSlope(max(dot(v, h), 0.0));
    sum.perColor += incoming * ((1.0 - f) * ((1.0 - s.metallic) / kPi) + slope * s.metallic * lobe);
#endif
  }
  vec2 albedo = environmentBrdf(s.roughness, nDotV);
  vec3 reflected = r.f0 * albedo.x + albedo.y;
#ifdef ENVIRONMENT
  vec3 mirror = environmentRadiance(reflect(-v, s.normal), s.roughness);
#else
  vec3 mirror = lights.ambient.rgb;
#endif
  // The fit exceeds 1 by some percent at grazing angles, where no light is left to enter.
  sum.diffuse += r.diffuse * max(1.0 - reflected, 0.0) * ambientRadiance(s.normal) * s.occlusion;
  sum.specular += reflected * mirror * s.occlusion;
#ifdef DEMODULATE
  sum.perColor += ((1.0 - s.metallic) * (1.0 - reflected) * ambientRadiance(s.normal) +
                   s.metallic * albedo.x * mirror) * s.occlusion;
#endif
  return sum;
}

Radiance lightSurface(SurfacePoint s, vec3 eye) {
  return lightSurface(s, eye, shadowAt(s));
}
