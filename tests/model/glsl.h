// What the shaders' text for insertion needs of GLSL and of its includer, on the explorer's memory.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "explorer.h"
#include "shared/oit_constants.h"

namespace macula::model {

using glm::ivec2;
using glm::uvec2;
using glm::uvec4;
using glm::vec3;
using glm::vec4;
using uint = std::uint32_t;  // NOLINT

// Places of memory: a word each of the pixel, then of each slot a depth, an id and a colour.
enum PixelPlace : std::size_t { kFill, kLock, kFrontNormal, kLockFailures, kFirstSlot };
inline constexpr std::size_t kSlotPlaces = 3;
inline std::size_t placeOf(uint slot) {
  return kFirstSlot + kSlotPlaces * slot;
}

struct PixelSlots {
  uint first;
  uint capacity;
  bool tail;
};
inline constexpr uint TAIL_SLOTS = 1;  // NOLINT

struct Fragment {
  uvec2 key;
  uint color;
};

inline bool isNearer(uvec2 a, uvec2 b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}
inline uint depthRank(uvec2 key) {
  return key.x;
}
inline uint storedRank(const Fragment& f) {
  return f.key.x;
}
inline uint storedFragments(uint word, PixelSlots slots) {
  return glm::min(word & ~RANGE_TAIL, slots.capacity);
}

inline Fragment loadFragment(uint slot) {
  const std::size_t at = placeOf(slot);
  const uint depth = Explorer::load(at);
  const uint id = Explorer::load(at + 1);
  return {{depth, id}, Explorer::load(at + 2)};
}
inline void storeFragment(uint slot, const Fragment& f) {
  const std::size_t at = placeOf(slot);
  Explorer::store(at, f.key.x);
  Explorer::store(at + 1, f.key.y);
  Explorer::store(at + 2, f.color);
}
// Sums of a tail are sums of bits, so that they tell which fragments are in them.
inline vec4 colorOf(const Fragment& f) {
  return vec4(static_cast<float>(f.color));
}
inline vec4 tailAddend(vec4 color) {
  return color;
}
inline vec4 loadTail(uint slot) {
  return vec4(static_cast<float>(Explorer::load(placeOf(slot) + 2)));
}
inline void storeTail(uint slot, vec4 sum) {
  Explorer::store(placeOf(slot) + 2, static_cast<uint>(sum.x));
}

/// Of the fragment that a thread inserts: its id.
inline std::array<vec3, 8> normalOfThread;

// Images of one texel a pixel, named by their places.
inline constexpr PixelPlace fragmentFill = kFill;        // NOLINT
inline constexpr PixelPlace fragmentLock = kLock;        // NOLINT
inline constexpr PixelPlace frontNormal = kFrontNormal;  // NOLINT
inline uvec4 imageLoad(PixelPlace image, ivec2 /*p*/) {
  return uvec4(Explorer::load(image));
}
inline void imageStore(PixelPlace image, ivec2 /*p*/, uvec4 value) {
  Explorer::store(image, value.x);
}
inline void imageStore(PixelPlace image, ivec2 /*p*/, vec4 value) {
  Explorer::store(image, static_cast<uint>(value.x));
}
inline uint imageAtomicExchange(PixelPlace image, ivec2 /*p*/, uint value) {
  return Explorer::exchangeLock(image, value);
}
inline void memoryBarrier() {
  Explorer::barrier();
}
// The critical section of ARB_fragment_shader_interlock, which orders memory accesses by itself.
inline void beginInvocationInterlockARB() {
  Explorer::exchangeLock(kLock, 1);
  Explorer::barrier();
}
inline void endInvocationInterlockARB() {
  Explorer::barrier();
  Explorer::exchangeLock(kLock, 0);
}
struct Totals {
  PixelPlace lockFailures = kLockFailures;
};
inline constexpr Totals totals;  // NOLINT
inline void atomicAdd(PixelPlace place, uint addend) {
  Explorer::store(place, addend);
}

}  // namespace macula::model
