// A point of a surface, as both the G-buffer and the transparent fragments describe it.
#ifndef MACULA_SURFACE_GLSL
#define MACULA_SURFACE_GLSL

struct SurfacePoint {
  vec3 position;   // world
  vec3 normal;     // world, unit length, towards the side that is seen
  vec3 baseColor;  // linear
  float alpha;
  float metallic;
  float roughness;  // perceptual
  float occlusion;
  vec3 emissive;
  bool unlit;
};

/// Octahedral encoding of a unit vector, -1..1 (Cigolle et al. 2014, "A Survey of Efficient
/// Representations for Independent Unit Vectors").
vec2 encodeOctahedral(vec3 n) {
  vec2 p = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
  vec2 folded = (1.0 - abs(p.yx)) * vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
  return n.z < 0.0 ? folded : p;
}

vec3 decodeOctahedral(vec2 e) {
  vec3 n = vec3(e, 1.0 - abs(e.x) - abs(e.y));
  float t = max(-n.z, 0.0);
  n.x += n.x >= 0.0 ? -t : t;
  n.y += n.y >= 0.0 ? -t : t;
  return normalize(n);
}

#endif
