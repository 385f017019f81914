// Marble: sine stripes bent by turbulence of gradient noise (Perlin 1985, "An Image Synthesizer";
// gradients and fade curve of Perlin 2002, "Improving Noise").
#include "lib/hash.glsl"

/// Octaves of the turbulence: the finest is 1/32 of a vein.
const int kOctaves = 6;
/// How far turbulence bends the stripes, in stripes.
const float kBend = 1.6;

float gradientAt(ivec3 corner, vec3 offset) {
  uint h = hashPcg(uint(corner.x) + hashPcg(uint(corner.y) + hashPcg(uint(corner.z)))) >> 28;
  float u = h < 8u ? offset.x : offset.y;
  float v = h < 4u ? offset.y : (h == 12u || h == 14u ? offset.x : offset.z);
  return ((h & 1u) == 0u ? u : -u) + ((h & 2u) == 0u ? v : -v);
}

/// -1..1
float gradientNoise(vec3 p) {
  vec3 cell = floor(p);
  vec3 f = p - cell;
  ivec3 c = ivec3(cell);
  vec3 t = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  float sum[2];
  for (int z = 0; z < 2; ++z) {
    float low = mix(gradientAt(c + ivec3(0, 0, z), f - vec3(0, 0, z)),
                    gradientAt(c + ivec3(1, 0, z), f - vec3(1, 0, z)), t.x);
    float high = mix(gradientAt(c + ivec3(0, 1, z), f - vec3(0, 1, z)),
                     gradientAt(c + ivec3(1, 1, z), f - vec3(1, 1, z)), t.x);
    sum[z] = mix(low, high, t.y);
  }
  return mix(sum[0], sum[1], t.z);
}

/// Share of the veins' colour, 0..1. @param p world position times veins a metre
float veinsAt(vec3 p) {
  float turbulence = 0.0;
  float weight = 1.0;
  for (int octave = 0; octave < kOctaves; ++octave) {
    turbulence += weight * abs(gradientNoise(p));
    p *= 2.0;
    weight *= 0.5;
  }
  float first = exp2(-float(kOctaves));  // back to the scale of the first octave
  float stripe = abs(sin(kPi * ((p.x + 0.6 * p.y + 0.3 * p.z) * first + kBend * turbulence)));
  return 1.0 - stripe * (2.0 - stripe);
}
