// Insertion of fragments by the text of the shaders, compiled as C++ in some variants.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "explorer.h"

namespace macula::model {

/// A fragment: nearer ones have the smaller depth, then the lower id. Its colour is the bit of its
/// id.
struct Inserted {
  std::uint32_t depth;
  std::uint32_t id;
};

/// The slots of one pixel, and who inserts into them.
struct Pixel {
  std::uint32_t slots;  ///< with that of a tail
  std::vector<std::vector<Inserted>> threads;
};

/// The insertion as one variant of the shaders compiles it.
struct Variant {
  const char* name;
  bool tail;
  bool dynamicTail;
  void (*insert)(const Pixel& pixel, const Inserted& fragment);
};

/// As capture.frag does it: with every storage of the tail, by locks and by the rasteriser's
/// interlock.
[[nodiscard]] const std::vector<Variant>& soundVariants();
/// Each with one thing wrong that the model must find: the test before the lock looks at the
/// farthest key; a lock that does not acquire, one that does not release; no lock.
[[nodiscard]] const std::vector<Variant>& faultyVariants();

/// Follows every order of a pixel's insertions. The outcome is compared with a sort: the nearest
/// fragments in their slots, the others in the tail or nowhere, the normal of the front one.
[[nodiscard]] Explorer::Result explore(const Variant& variant, const Pixel& pixel);

}  // namespace macula::model
