// The method table: every way to draw transparency is one row, made of facts by name. Passes,
// checks and reports ask for the facts; which method it is they do not ask.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace macula::passes {

struct OitPlan;
struct PlanInputs;

/// Names of passes that only some methods run; empty ones are none.
using PassNames = std::array<std::string_view, 2>;

/// How a pixel gets its slots.
struct Allocation {
  /// Fills in slots, layers and budget of a plan whose method, options and pool of the last frames
  /// are set. Null: nothing is stored. See slots.h.
  void (*planSlots)(OitPlan& plan, const PlanInputs& in) = nullptr;
  bool constant = false;    ///< the same number everywhere, addressed without a table
  bool counts = false;      ///< by the number of the pixel's fragments, which a count pass finds
  bool budget = false;      ///< `--k-ave` and `--oit-memory` say how much is stored
  bool shared = false;      ///< pixels share one budget; implies counts and budget
  bool importance = false;  ///< its share follows importance; implies shared
  bool learned = false;     ///< the importance is a network's; implies importance
  bool grows = false;       ///< the pool grows to what the frames need
  bool adjusts = false;     ///< a quality control may have a frame use fewer slots than the pool
                            ///< has, in less time; implies budget
  PassNames passes = {};
  const char* define = nullptr;  ///< of oit/allocate.comp, where that is how slots are allocated
};

/// What happens to a fragment.
struct Insertion {
  const char* define = nullptr;  ///< of the capture and the resolve; null: nothing is stored
  bool captured = false;         ///< oit.capture stores the fragments, not a pass of its own
  bool fills = false;            ///< slots in use are counted per pixel; implies captured
  bool links = false;            ///< a pixel's slots form a linked list; implies captured
  bool sorts = false;            ///< kept nearest first, under per-pixel ordering; implies fills
  bool sortedAtResolve = false;  ///< in slots in any order; implies fills
  bool keysFirst = false;        ///< oit.capture finds sorted keys and adds colours to them
  PassNames passes = {};
  std::string_view noTail = {};  ///< why there cannot be a tail, and the fix; empty: there can

  // What is reported
  bool counted = true;    ///< the numbers of fragments
  bool provesAll = true;  ///< no fragment that was counted as stored can be missing
  /// Fragments of a pixel that the resolve sorts within 65,535 iterations of a loop, where the
  /// device ends loops there; 0: any number.
  std::uint32_t deepestBounded = 0;
};

struct Method {
  std::string_view id;
  Allocation allocation;
  Insertion insertion;
  bool exact = false;  ///< every fragment reaches the image in its place, memory permitting
  bool racy = false;   ///< without per-pixel ordering on purpose
  std::string_view summary;
  std::string_view source;

  /// Whether a resolve pass composites stored fragments.
  [[nodiscard]] constexpr bool stores() const { return insertion.define != nullptr; }
  /// Whether oit.capture stores them. Implies stores().
  [[nodiscard]] constexpr bool captures() const { return insertion.captured; }
  /// Whether a count pass precedes the capture.
  [[nodiscard]] constexpr bool counts() const { return allocation.counts; }
  /// Whether each pixel's slots stand in a table; else their place follows from the pixel.
  [[nodiscard]] constexpr bool hasRanges() const { return counts(); }
  /// Whether it keeps the k nearest or first fragments of a pixel under a budget.
  [[nodiscard]] constexpr bool hasBudget() const { return allocation.budget; }
  /// Whether fewer slots take less time, so that a quality control may lower what a frame uses.
  [[nodiscard]] constexpr bool costFollowsBudget() const { return allocation.adjusts; }
  /// Whether the pool grows to what the frames need.
  [[nodiscard]] constexpr bool grows() const { return allocation.grows; }
  [[nodiscard]] constexpr bool fills() const { return insertion.fills; }
  [[nodiscard]] constexpr bool sorts() const { return insertion.sorts; }
  /// Whether each pixel has a word that counts its slots in use or holds the head of its list.
  [[nodiscard]] constexpr bool hasFill() const { return fills() || insertion.links; }
  [[nodiscard]] constexpr bool sharesBudget() const { return allocation.shared; }
  [[nodiscard]] constexpr bool followsImportance() const { return allocation.importance; }
  /// A network says how important pixels are. Implies followsImportance().
  [[nodiscard]] constexpr bool learnsImportance() const { return allocation.learned; }
  [[nodiscard]] constexpr bool isRacy() const { return racy; }
  /// Whether the row names this pass as its own.
  [[nodiscard]] bool runs(std::string_view pass) const;
};

[[nodiscard]] std::span<const Method> methods();
/// @throws InputError naming the nearest known method
[[nodiscard]] const Method& methodById(std::string_view id);

}  // namespace macula::passes
