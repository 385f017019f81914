// Marble: stripes bent by gradient noise (Perlin 1985, "An Image Synthesizer"; gradients and fade
// curve of Perlin 2002, "Improving Noise").
#include "lib/hash.glsl"

/// Octaves of a sum: the finest is 1/64 of the first.
const int kOctaves = 7;
/// Weight of an octave over that of the one before: polished stone is smooth.
const float kGain = 0.38;
/// How far noise moves the place at which the next noise is taken, in the first octave's cells.
const float kWarp = 0.45;
/// How far it bends the stripes, in stripes.
const float kBend = 1.1;

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

/// Octaves of twice the frequency each, about -1..1.
float fractalNoise(vec3 p) {
  float sum = 0.0;
  float weight = 1.0;
  for (int octave = 0; octave < kOctaves; ++octave) {
    sum += weight * gradientNoise(p);
    p = 2.0 * p + 17.3;  // octaves must not share their lattice's zeros
    weight *= kGain;
  }
  return sum;
}

vec3 fractalField(vec3 p) {
  return vec3(fractalNoise(p), fractalNoise(p + vec3(5.2, 1.3, 7.9)),
              fractalNoise(p + vec3(1.7, 9.2, 3.4)));
}

/// Share of the veins' colour, 0..1: stripes in a place that noise has moved twice over (domain
/// warping, Quilez 2002). @param p world position times veins a metre
float veinsAt(vec3 p) {
  vec3 moved = p + kWarp * fractalField(p + kWarp * fractalField(p));
  float along = dot(p, vec3(1.0, 0.6, 0.3)) + kBend * fractalNoise(moved);
  float stripe = abs(sin(kPi * along));
  return 1.0 - stripe * (2.0 - stripe);
}
