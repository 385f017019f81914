// The method table: every way to draw transparency is a row of it.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace macula::passes {

/// How a pixel gets its slots.
enum class Allocation : std::uint8_t {
  None,
  ExactCount,     ///< as many as it has fragments
  ImportanceMap,  ///< its share of the budget by importance
};

/// What happens to a fragment.
enum class Insertion : std::uint8_t {
  Blended,   ///< fixed-function blending in draw order
  Appended,  ///< stored in any order, sorted when resolved
  Sorted,    ///< inserted among the k nearest, under synchronisation
};

struct Method {
  std::string_view id;
  Allocation allocation;
  Insertion insertion;
  bool exact;  ///< every fragment reaches the image in its place
  std::string_view summary;
  std::string_view source;

  [[nodiscard]] bool counts() const { return allocation != Allocation::None; }
  [[nodiscard]] bool stores() const { return insertion != Insertion::Blended; }
  [[nodiscard]] bool hasBudget() const { return allocation == Allocation::ImportanceMap; }
  /// Whether the front-most normal is kept for the next frame's Fresnel factor.
  [[nodiscard]] bool keepsFrontNormal() const { return allocation == Allocation::ImportanceMap; }
};

[[nodiscard]] std::span<const Method> methods();
/// @throws InputError naming the nearest known method
[[nodiscard]] const Method& methodById(std::string_view id);

}  // namespace macula::passes
