// Materials and lights as the GPU reads them.
#ifndef MACULA_SHARED_SCENE_DATA_H
#define MACULA_SHARED_SCENE_DATA_H
#include "shared/cpp_glsl.h"

// The greatest alpha of a transparent fragment that adds nothing: neither counted nor stored. 2^-25
// is what half floats, in which fragments are stored, round to 0, and what floats, in which they
// are put over one another, take away from 1 without a change. With 8-byte fragments, too: their 8
// bits of alpha round more to 0, but the light of those fragments is stored.
#define LEAST_ALPHA 2.98023223876953125e-8

#define LIGHT_DIRECTIONAL 0u
#define LIGHT_POINT 1u
#define LIGHT_SPOT 2u

// A bound on the cost of lighting, and on the size of its uniform buffer (3 KiB of 16 at least).
#define MAX_LIGHTS 32
// Spherical harmonics up to l = 2 (Ramamoorthi and Hanrahan 2001).
#define SH_COEFFICIENTS 9
// Materials with procedural veins: a bound on the uniform buffer.
#define MAX_VEINS 8

MACULA_SHARED_BEGIN

struct MaterialData {
  vec4 baseColor;
  vec4 emissive;      // rgb; w: normal scale
  vec4 surface;       // metallic, roughness, occlusion strength, alpha cutoff
  vec4 transmission;  // rgb: attenuation over the thickness; w: transmission factor
};

struct LightData {
  vec4 position;   // xyz world; w: LIGHT_* as float
  vec4 direction;  // xyz the way the light travels; w: range, 0 infinite
  vec4 color;      // rgb times intensity; w: 1 where it casts the shadow
  vec4 cone;       // spot: x scale, y offset of the angular attenuation
};

struct LightBlock {
  vec4 ambient;           // constant ambient radiance; w: count of lights
  vec4 environment;       // x: mip levels, y: intensity
  mat4 shadowMatrix;      // world to shadow map, 0..1 in x, y and z
  vec4 shadow;            // x: width of the map in world units; y: square of the least distance
                          // to a light
  vec4 occlusion;         // x: radius in world units, y: samples
  vec4 veins[MAX_VEINS];  // linear rgb; w: veins a metre
  vec4 irradiance[SH_COEFFICIENTS];
  LightData lights[MAX_LIGHTS];
};

MACULA_SHARED_END
#endif
