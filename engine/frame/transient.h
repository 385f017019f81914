// Buffers whose contents only matter for some passes of a frame share memory. No GL calls.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace macula::frame {

/// Passes of a frame, by number, during which contents matter.
struct Lifetime {
  std::uint32_t first = 0;
  std::uint32_t last = 0;  ///< included

  [[nodiscard]] bool meets(const Lifetime& o) const { return first <= o.last && o.first <= last; }
};

struct TransientBuffer {
  std::size_t bytes = 0;
  Lifetime life;
};

/// Where transient buffers lie: each in one block, and no two overlap whose lives meet.
struct TransientPlan {
  struct Place {
    std::uint32_t block = 0;
    std::size_t offset = 0;

    bool operator==(const Place&) const = default;
  };
  std::vector<Place> places;            ///< in the order of the buffers
  std::vector<std::size_t> blockBytes;  ///< size of each block

  bool operator==(const TransientPlan&) const = default;
};

/// Places the largest buffers first, each at the lowest offset that is free during its life, and
/// begins a new block where the others would grow beyond the limit.
/// @param alignment of offsets, in bytes, a power of two
/// @param mostBytes of a block; a larger buffer gets a block of its own size
[[nodiscard]] TransientPlan placeTransients(std::span<const TransientBuffer> buffers,
                                            std::size_t alignment, std::size_t mostBytes);

/// Largest sum of bytes that is alive during one pass: no placement needs less.
[[nodiscard]] std::size_t largestSumAlive(std::span<const TransientBuffer> buffers);

}  // namespace macula::frame
