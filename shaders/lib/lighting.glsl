// Light that leaves a surface point towards the eye: the same functions for opaque and transparent
// surfaces. SHADOWS: a shadow map is bound. ENVIRONMENT: a panorama is bound. EACH_LIGHT(F): F(i, type)
// for every light, written out where the scene has few, so that all their types are constants.
// LIGHT_CONSTANTS: the whole LightBlock, where nothing of it changes; llvmpipe fetches each number of
// a uniform block for each lane.
// SHADOW_LIGHT: the number of the one that casts shadows, where EACH_LIGHT is given.
// DEMODULATE: the part that is proportional to the base colour is also returned separately.
#include "lib/brdf.glsl"
#include "lib/surface.glsl"
#include "shared/bindings.h"
#include "shared/scene_data.h"

#ifdef LIGHT_CONSTANTS
const LightBlock lights = LIGHT_CONSTANTS;
#else
layout(std140, binding = UBO_LIGHTS) uniform LightUniforms { LightBlock lights; };
#endif
#ifdef SHADOWS
layout(binding = TEX_SHADOW_MAP) uniform sampler2DShadow shadowMap;
#endif
#ifdef ENVIRONMENT
layout(binding = TEX_ENVIRONMENT) uniform sampler2D environmentMap;
#endif

#ifndef EACH_LIGHT
#define EACH_LIGHT(F)                                   \
  for (int i = 0; i < int(lights.ambient.w); ++i) {     \
    F(i, uint(lights.lights[i].position.w))             \
  }
#endif

#ifdef SHADOWS
#ifndef SHADOW_TAPS
#define SHADOW_TAPS 3
#endif

/// Percentage-closer filtering (Reeves et al. 1987) over SHADOW_TAPS x SHADOW_TAPS bilinear
/// comparisons, which are one texel apart: each texel is compared once, and those at the rim count by the
/// part that the taps cover.
/// @param normal the geometric one: moved along that of a normal map, the receiver might still shadow
/// itself
float shadowFactor(vec3 position, vec3 normal, vec3 toLight) {
  float size = float(textureSize(shadowMap, 0).x);
  float texel = 1.0 / size;
  // Moving the receiver along its normal by some texels of the map hides self-shadowing; more at
  // grazing light, where one texel covers more of the surface.
  float cosine = dot(normal, toLight);
  float grazing = sqrt(max(0.0, 1.0 - cosine * cosine));
  const int kReach = SHADOW_TAPS / 2;
  float width = max(float(kReach), 1.0);
  vec3 p = position + normal * (lights.shadow.x * texel * width * (0.75 + 1.5 * grazing));
  vec3 uvz = (lights.shadowMatrix * vec4(p, 1.0)).xyz;
  vec2 place = uvz.xy * size - 0.5;
  vec2 whole = floor(place);
  vec2 part = place - whole;
  // The middle of the first four of (SHADOW_TAPS + 1)^2 texels.
  vec2 first = (whole + float(1 - kReach)) * texel;
  float sum = 0.0;
  for (int y = 0; y <= kReach; ++y) {
    for (int x = 0; x <= kReach; ++x) {
      // x, y: left and right of the upper row; z, w: right and left of the lower.
      vec4 lit = textureGather(shadowMap, first + vec2(x, y) * (2.0 * texel), uvz.z);
      vec2 low = vec2(x == 0 ? 1.0 - part.x : 1.0, y == 0 ? 1.0 - part.y : 1.0);
      vec2 high = vec2(x == kReach ? part.x : 1.0, y == kReach ? part.y : 1.0);
      sum += (lit.x * low.x + lit.y * high.x) * high.y + (lit.w * low.x + lit.z * high.x) * low.y;
    }
  }
  return sum / float(SHADOW_TAPS * SHADOW_TAPS);
}

/// Share of a directional light that arrives; 1 where the surface faces away from it, normal map or not.
float shadowOf(LightData light, SurfacePoint s) {
  vec3 l = -light.direction.xyz;
  bool faces = max(dot(s.normal, l), dot(s.geometricNormal, l)) > 0.0;
  return faces ? shadowFactor(s.position, s.geometricNormal, l) : 1.0;
}
#endif

/// Share of the shadow-casting light that arrives.
float shadowAt(SurfacePoint s) {
#if defined(SHADOWS) && defined(SHADOW_LIGHT)
  return shadowOf(lights.lights[SHADOW_LIGHT], s);
#elif defined(SHADOWS)
  int count = int(lights.ambient.w);
  for (int i = 0; i < count; ++i) {
    if (lights.lights[i].color.w != 0.0) return shadowOf(lights.lights[i], s);
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
/// @param type of the light, LIGHT_*
float lightTowards(LightData light, uint type, vec3 position, out vec3 l) {
  l = -light.direction.xyz;
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

vec3 irradianceOf(LightData light, uint type, vec3 position, vec3 normal) {
  vec3 l;
  float attenuation = lightTowards(light, type, position, l);
  return light.color.rgb * (attenuation * max(dot(normal, l), 0.0));
}

/// Irradiance of all lights without shadows.
vec3 irradianceAt(vec3 position, vec3 normal) {
  vec3 sum = vec3(0.0);
#define ADD_IRRADIANCE(i, type) sum += irradianceOf(lights.lights[i], type, position, normal);
  EACH_LIGHT(ADD_IRRADIANCE)
#undef ADD_IRRADIANCE
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

/// What the light of all lamps has in common.
struct Receiver {
  SurfacePoint surface;
  Reflection reflection;
  vec3 toEye;      // unit length
  float nDotV;
  float shadow;    // share of the shadow-casting light that arrives
};

void addLight(inout Radiance sum, LightData light, uint type, bool shadowed, Receiver at) {
  vec3 l;
  float attenuation = lightTowards(light, type, at.surface.position, l);
  float nDotL = dot(at.surface.normal, l);
  if (nDotL <= 0.0 || attenuation <= 0.0) return;
  if (shadowed) attenuation *= at.shadow;
  // Both vectors are of unit length, so that the angles of h = (l + v) / |l + v| follow from theirs:
  // |l + v|^2 = 2 + 2 l.v, which vanishes where the light comes from straight behind.
  float lDotV = dot(l, at.toEye);
  float inverse = inversesqrt(max(2.0 + 2.0 * lDotV, 1e-12));
  float vDotH = max((1.0 + lDotV) * inverse, 0.0);
  float nDotH = max((nDotL + dot(at.surface.normal, at.toEye)) * inverse, 0.0);
  vec3 f = fresnelSchlick(at.reflection.f0, vDotH);
  vec3 incoming = light.color.rgb * (attenuation * nDotL);
  float lobe = specularGgx(at.reflection.alpha, nDotH, nDotL, at.nDotV);
  sum.diffuse += incoming * (1.0 - f) * (at.reflection.diffuse / kPi);
  sum.specular += incoming * f * lobe;
#ifdef DEMODULATE
  float slope = fresnelSlope(vDotH);
  float metallic = at.surface.metallic;
  sum.perColor += incoming * ((1.0 - f) * ((1.0 - metallic) / kPi) + slope * metallic * lobe);
#endif
}

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
  Receiver at = Receiver(s, r, v, nDotV, shadow);
#ifdef SHADOW_LIGHT
#define CASTS(i) (i == SHADOW_LIGHT)
#else
#define CASTS(i) (lights.lights[i].color.w > 0.0)
#endif
#define ADD_LIGHT(i, type) addLight(sum, lights.lights[i], type, CASTS(i), at);
  EACH_LIGHT(ADD_LIGHT)
#undef ADD_LIGHT
#undef CASTS
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
