// A point of a surface, as both the G-buffer and the transparent fragments describe it.
#ifndef MACULA_SURFACE_GLSL
#define MACULA_SURFACE_GLSL

struct SurfacePoint {
  vec3 position;   // world
  vec3 normal;     // world, unit length, towards the side that is seen
  vec3 geometricNormal;  // the same without a normal map
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

/// What the G-buffer stores of a surface besides its material parameters.
struct SurfaceKind {
  bool unlit;
  uint veins;            // number of its veins plus one, 0 for none
  vec3 geometricNormal;  // undefined where not mapped
  bool mapped;           // a normal map turned the normal away from it
};

/// Four bits: more than MAX_VEINS.
const uint kUnlitKind = 15u;
/// Six bits an axis. The geometric normal moves shadow lookups off the surface by about two texels of
/// the map; an error of 2 degrees changes that by less than a tenth of a texel.
const float kNormalSteps = 31.0;
/// Encodes no direction: the normal itself is the geometric one.
const uint kNotMapped = 63u;

/// Two bytes as 0..1.
vec2 packKind(SurfaceKind s) {
  vec2 place = encodeOctahedral(s.geometricNormal) * kNormalSteps + (kNormalSteps + 0.5);
  uvec2 code = s.mapped ? uvec2(place) : uvec2(kNotMapped);
  uint kind = s.unlit ? kUnlitKind : s.veins;
  return vec2(code << 2 | uvec2(kind & 3u, kind >> 2)) / 255.0;
}

SurfaceKind unpackKind(vec2 bytes) {
  uvec2 b = uvec2(bytes * 255.0 + 0.5);
  uint kind = (b.x & 3u) | (b.y & 3u) << 2;
  uvec2 code = b >> 2;
  SurfaceKind s;
  s.unlit = kind == kUnlitKind;
  s.veins = s.unlit ? 0u : kind;
  s.mapped = code.x != kNotMapped;
  s.geometricNormal = decodeOctahedral((vec2(code) - kNormalSteps) / kNormalSteps);
  return s;
}

#endif
