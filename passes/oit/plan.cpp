#include "passes/oit/plan.h"

#include <cmath>
#include <limits>

#include "engine/core/error.h"

namespace macula::passes {

void planBudget(OitPlan& plan, const OitSettings& settings, std::uint64_t samples) {
  constexpr double kMebi = 1024.0 * 1024.0;
  // Vasilakis 2017, Eq. 2: M = k_ave w h fragments; or M bytes.
  const double fragments = settings.memoryMiB > 0.0
                               ? std::floor(settings.memoryMiB * kMebi / kFragmentBytes)
                               : std::floor(settings.kAve * static_cast<double>(samples));
  // Products of importance and slots must stay exact in shaders/lib/budget.glsl.
  constexpr double kMostSlots = 1U << 29U;
  if (fragments < 1.0) {
    failInput(
        "the transparency budget holds no fragment ({} bytes each); raise --k-ave or "
        "--oit-memory",
        kFragmentBytes);
  }
  if (fragments > kMostSlots) {
    failInput(
        "the transparency budget of {:.0f} fragments is more than {:.0f}; lower --k-ave or "
        "--oit-memory",
        fragments, kMostSlots);
  }
  plan.slots = static_cast<std::uint32_t>(fragments);
  plan.budgetBytes = settings.memoryMiB > 0.0
                         ? static_cast<std::uint64_t>(settings.memoryMiB * kMebi)
                         : plan.slots * kFragmentBytes;
}

gl::Defines definesOf(const OitPlan& plan) {
  gl::Defines defines;
  defines.emplace_back(plan.method->allocation == Allocation::ExactCount ? "ALLOCATION_EXACT"
                                                                         : "ALLOCATION_IMPORTANCE",
                       "1");
  const bool sorted = plan.method->insertion == Insertion::Sorted;
  defines.emplace_back(sorted ? "INSERTION_SORTED" : "INSERTION_APPEND", "1");
  switch (plan.sync) {
    case SyncMode::Interlock:
      defines.emplace_back("SYNC_INTERLOCK", "1");
      break;
    case SyncMode::Ordered:
      defines.emplace_back("SYNC_ORDERED", "1");
      break;
    case SyncMode::None:
      defines.emplace_back("SYNC_NONE", "1");
      break;
    case SyncMode::Spinlock:
    case SyncMode::Auto:
      defines.emplace_back("SYNC_SPINLOCK", "1");
      break;
  }
  if (plan.method->keepsFrontNormal()) defines.emplace_back("FRONT_NORMAL", "1");
  return defines;
}

}  // namespace macula::passes
