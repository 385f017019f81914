// Stored fragments: 16 bytes (key, premultiplied RGBA16F) or, PACKED, 8 bytes (24 bits of depth and
// 8 of alpha, then premultiplied RGB with a shared exponent).
// STORE_ACCESS: memory qualifiers of the arrays. STORE_READONLY: nothing is stored. KEYS_ONLY: only keys
// are used; a block that a shader declares must be bound, even if unused.
#include "lib/oit.glsl"

layout(std430, binding = SSBO_FRAGMENT_KEYS) STORE_ACCESS buffer Keys { uvec2 keys[]; };
#ifndef KEYS_ONLY
#ifndef PACKED
layout(std430, binding = SSBO_FRAGMENT_COLORS) STORE_ACCESS buffer Colors { uvec2 colors[]; };
#endif

struct Fragment {
  uvec2 key;
#ifndef PACKED
  uvec2 color;
#endif
};

#ifdef PACKED
/// Shared-exponent RGB of 9 bits each (EXT_texture_shared_exponent).
uint packRgb9e5(vec3 color) {
  vec3 c = clamp(color, vec3(0.0), vec3(65408.0));
  float largest = max(c.r, max(c.g, c.b));
  float exponent = max(-16.0, floor(log2(max(largest, 1e-9)))) + 16.0;
  float scale = exp2(24.0 - exponent);
  if (floor(largest * scale + 0.5) >= 512.0) {
    exponent += 1.0;
    scale *= 0.5;
  }
  uvec3 m = uvec3(floor(c * scale + 0.5));
  return m.r | (m.g << 9) | (m.b << 18) | (uint(exponent) << 27);
}

vec3 unpackRgb9e5(uint v) {
  vec3 m = vec3(v & 511u, (v >> 9) & 511u, (v >> 18) & 511u);
  return m * exp2(float(v >> 27) - 24.0);
}

/// Depth as stored, nearest first, in 24 bits: the lowest 6 of the 30 that hold all floats of 0..1 are
/// dropped. Of the key of a fragment that is not packed yet.
uint depthRank(uvec2 key) { return (key.x - ~0x3F800000u) >> 6; }
/// The same of a stored fragment.
uint storedRank(Fragment f) { return f.key.x >> 8; }

Fragment makeFragment(uvec2 key, vec4 premultiplied) {
  uint alpha = uint(clamp(premultiplied.a, 0.0, 1.0) * 255.0 + 0.5);
  return Fragment(uvec2((depthRank(key) << 8) | alpha, packRgb9e5(premultiplied.rgb)));
}

vec4 colorOf(Fragment f) { return vec4(unpackRgb9e5(f.key.y), float(f.key.x & 255u) / 255.0); }
Fragment loadFragment(uint slot) { return Fragment(keys[slot]); }
#ifndef STORE_READONLY
void storeFragment(uint slot, Fragment f) { keys[slot] = f.key; }
void storeTail(uint slot, vec4 sum) {
  uvec4 words = floatBitsToUint(sum);
  keys[slot] = words.xy;
  keys[slot + 1u] = words.zw;
}
#endif
vec4 loadTail(uint slot) { return uintBitsToFloat(uvec4(keys[slot], keys[slot + 1u])); }
#else
/// Depth, nearest first: floats of 0..1 take 30 bits.
uint depthRank(uvec2 key) { return key.x - ~0x3F800000u; }
/// The same of a stored fragment.
uint storedRank(Fragment f) { return depthRank(f.key); }

Fragment makeFragment(uvec2 key, vec4 premultiplied) {
  vec4 c = min(premultiplied, vec4(kMaxHalf));
  return Fragment(key, uvec2(packHalf2x16(c.rg), packHalf2x16(c.ba)));
}

vec4 colorOf(Fragment f) { return vec4(unpackHalf2x16(f.color.x), unpackHalf2x16(f.color.y)); }
Fragment loadFragment(uint slot) { return Fragment(keys[slot], colors[slot]); }
#ifndef STORE_READONLY
void storeFragment(uint slot, Fragment f) {
  keys[slot] = f.key;
  colors[slot] = f.color;
}
void storeTail(uint slot, vec4 sum) {
  uvec4 words = floatBitsToUint(sum);
  keys[slot] = words.xy;
  colors[slot] = words.zw;
}
#endif
vec4 loadTail(uint slot) { return uintBitsToFloat(uvec4(keys[slot], colors[slot])); }
#endif
#endif
