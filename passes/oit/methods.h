// The method table: every way to draw transparency is a row of it.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace macula::passes {

/// How a pixel gets its slots.
enum class Allocation : std::uint8_t {
  None,
  Constant,       ///< the same number everywhere, addressed without a table
  Pool,           ///< one shared pool, a slot at a time
  ExactCount,     ///< as many as it has fragments
  OneK,           ///< at most k, one k for the image from the histogram of counts
  ImportanceMap,  ///< its share of the budget by importance
};

/// What happens to a fragment.
enum class Insertion : std::uint8_t {
  Blended,        ///< fixed-function blending in draw order
  Weighted,       ///< summed with a weight that falls off with depth
  Peeled,         ///< the nearest that has not been drawn yet, one layer a pass
  Appended,       ///< stored in any order, sorted when resolved
  Linked,         ///< the same, in a linked list
  Sorted,         ///< inserted among the k nearest, under synchronisation
  AtomicMin,      ///< keys sorted by atomic minima first, colours to their keys then
  StencilRouted,  ///< one multisample slot each, chosen by the stencil test
};

struct Method {
  std::string_view id;
  Allocation allocation;
  Insertion insertion;
  bool exact;  ///< every fragment reaches the image in its place, memory permitting
  std::string_view summary;
  std::string_view source;

  /// Whether a count pass precedes the capture.
  [[nodiscard]] bool counts() const {
    return allocation == Allocation::ExactCount || allocation == Allocation::OneK ||
           allocation == Allocation::ImportanceMap;
  }
  /// Whether a capture pass stores fragments that a resolve pass composites.
  [[nodiscard]] bool stores() const { return allocation != Allocation::None; }
  /// Whether each pixel's slots stand in a table; else their place follows from the pixel.
  [[nodiscard]] bool hasRanges() const { return counts(); }
  [[nodiscard]] bool isKBuffer() const {
    return insertion == Insertion::Sorted || insertion == Insertion::AtomicMin ||
           insertion == Insertion::StencilRouted;
  }
  /// Whether `--k-ave` and `--oit-memory` say how much is stored.
  [[nodiscard]] bool hasBudget() const { return isKBuffer(); }
  /// Whether a pixel's share of the budget follows a map of importance.
  [[nodiscard]] bool followsImportance() const { return allocation == Allocation::ImportanceMap; }
  /// Whether a smaller budget takes less time. The slots of stencil routing are samples of the
  /// target, and those that are not used lie idle.
  [[nodiscard]] bool costFollowsBudget() const {
    return hasBudget() && insertion != Insertion::StencilRouted;
  }
  /// Whether the pool grows to what the frames need.
  [[nodiscard]] bool grows() const {
    return allocation == Allocation::ExactCount || allocation == Allocation::Pool;
  }
  /// Whether slots in use are counted per pixel.
  [[nodiscard]] bool fills() const {
    return insertion == Insertion::Appended || insertion == Insertion::Sorted;
  }
  /// A network says how important pixels are.
  [[nodiscard]] bool learnsImportance() const;
  /// Inserts without turns on purpose.
  [[nodiscard]] bool isRacy() const;
};

[[nodiscard]] std::span<const Method> methods();
/// @throws InputError naming the nearest known method
[[nodiscard]] const Method& methodById(std::string_view id);

}  // namespace macula::passes
