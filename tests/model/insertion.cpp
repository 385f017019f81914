#include "insertion.h"

#include <fmt/format.h>

#include <algorithm>

#include "glsl.h"

#define VARIANT spinlock
#define SYNC_SPINLOCK
#include "variant.inc"

#define VARIANT spinlock_tail
#define SYNC_SPINLOCK
#define TAIL_IN_SLOT
#include "variant.inc"

#define VARIANT spinlock_dynamic_tail
#define SYNC_SPINLOCK
#define TAIL_IN_SLOT
#define TAIL_DYNAMIC
#include "variant.inc"

#define VARIANT interlock
#define SYNC_INTERLOCK
#include "variant.inc"

#define VARIANT interlock_tail
#define SYNC_INTERLOCK
#define TAIL_IN_SLOT
#include "variant.inc"

#define VARIANT interlock_dynamic_tail
#define SYNC_INTERLOCK
#define TAIL_IN_SLOT
#define TAIL_DYNAMIC
#include "variant.inc"

#define VARIANT unsafe_pretest
#define SYNC_SPINLOCK
#define UNSAFE_PRETEST
#include "variant.inc"

#define VARIANT interlock_unsafe_pretest
#define SYNC_INTERLOCK
#define UNSAFE_PRETEST
#include "variant.inc"

#define VARIANT no_acquire
#define SYNC_SPINLOCK
#define LOCK_ACQUIRE
#include "variant.inc"

#define VARIANT no_release
#define SYNC_SPINLOCK
#define LOCK_RELEASE
#include "variant.inc"

#define VARIANT tail_no_acquire
#define SYNC_SPINLOCK
#define TAIL_IN_SLOT
#define LOCK_ACQUIRE
#include "variant.inc"

#define VARIANT no_lock
#define SYNC_NONE
#include "variant.inc"

namespace macula::model {
namespace {

std::string compare(const char* what, std::uint32_t found, std::uint32_t expected) {
  if (found == expected) return "";
  return fmt::format("{} is {:#x}, not {:#x}; ", what, found, expected);
}

/// What is wrong with a pixel after all insertions.
std::string unlike(const Variant& variant, const Pixel& pixel,
                   const std::vector<std::uint32_t>& memory) {
  std::vector<Inserted> sorted;
  for (const auto& thread : pixel.threads)
    sorted.insert(sorted.end(), thread.begin(), thread.end());
  std::ranges::sort(sorted, [](const Inserted& a, const Inserted& b) {
    return a.depth != b.depth ? a.depth < b.depth : a.id < b.id;
  });
  const bool hasTail = variant.tail && (!variant.dynamicTail || sorted.size() > pixel.slots);
  const std::size_t core = std::min<std::size_t>(sorted.size(), pixel.slots - (hasTail ? 1 : 0));
  std::string faults;
  for (std::size_t i = 0; i < core; ++i) {
    const std::size_t at = placeOf(static_cast<uint>(i));
    faults += compare("a depth", memory[at], sorted[i].depth);
    faults += compare("an id", memory[at + 1], sorted[i].id);
    faults += compare("a colour", memory[at + 2], 1U << sorted[i].id);
  }
  if (hasTail) {
    std::uint32_t sum = 0;
    for (std::size_t i = core; i < sorted.size(); ++i) sum += 1U << sorted[i].id;
    faults += compare("the tail", memory[placeOf(pixel.slots - 1) + 2], sum);
  }
  const PixelSlots slots{0, static_cast<uint>(core), false};
  faults += compare("the fill", storedFragments(memory[kFill], slots), static_cast<uint>(core));
  // Where the tail begins only later, the one slot of a core may hold what will be merged.
  if (core > (variant.dynamicTail ? 1 : 0)) {
    faults += compare("the front normal", memory[kFrontNormal], sorted[0].id);
  }
  faults += compare("locks given up", memory[kLockFailures], 0);
  return faults;
}

}  // namespace

const std::vector<Variant>& soundVariants() {
  static const std::vector<Variant> all{
      {"spinlock", false, false, spinlock::insert},
      {"spinlock, tail", true, false, spinlock_tail::insert},
      {"spinlock, dynamic tail", true, true, spinlock_dynamic_tail::insert},
      {"interlock", false, false, interlock::insert},
      {"interlock, tail", true, false, interlock_tail::insert},
      {"interlock, dynamic tail", true, true, interlock_dynamic_tail::insert},
  };
  return all;
}

const std::vector<Variant>& faultyVariants() {
  static const std::vector<Variant> all{
      {"spinlock, unsafe test before the lock", false, false, unsafe_pretest::insert},
      {"interlock, unsafe test before it", false, false, interlock_unsafe_pretest::insert},
      {"a lock that does not acquire", false, false, no_acquire::insert},
      {"a lock that does not release", false, false, no_release::insert},
      {"a lock that does not acquire, tail", true, false, tail_no_acquire::insert},
      {"no lock", false, false, no_lock::insert},
  };
  return all;
}

Explorer::Result explore(const Variant& variant, const Pixel& pixel) {
  // Slots that no fragment was written to hold what looks like the nearest depth.
  const std::vector<std::uint32_t> memory(kFirstSlot + kSlotPlaces * pixel.slots, 0);
  std::vector<Explorer::Thread> threads;
  for (const std::vector<Inserted>& inserted : pixel.threads) {
    threads.emplace_back([&] {
      for (const Inserted& fragment : inserted) variant.insert(pixel, fragment);
    });
  }
  return Explorer::explore(memory, threads, [&](const std::vector<std::uint32_t>& outcome) {
    return unlike(variant, pixel, outcome);
  });
}

}  // namespace macula::model
