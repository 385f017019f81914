#include "passes/oit/plan.h"

#include <algorithm>
#include <cmath>

#include "engine/core/error.h"
#include "engine/core/plural.h"
#include "shared/oit_constants.h"

namespace macula::passes {
namespace {

/// Products of importance and slots must stay exact in shaders/lib/budget.glsl.
constexpr double kMostSlots = 1U << 29U;

/// Bytes that the budget grants. Vasilakis 2017, Eq. 2: M = k_ave w h fragments; or M bytes.
double grantedBytes(const OitPlan& plan, std::uint64_t samples) {
  constexpr double kMebi = 1024.0 * 1024.0;
  const OitSettings& s = plan.options;
  if (s.memoryMiB > 0.0) return std::floor(s.memoryMiB * kMebi);
  const double slots = std::floor(s.kAve * static_cast<double>(samples));
  return slots * static_cast<double>(plan.fragmentBytes());
}

void planConstant(OitPlan& plan, std::uint64_t samples, double bytes) {
  const double perSample = bytes / static_cast<double>(samples);
  const double tail = plan.denseTail() ? static_cast<double>(kDenseTailBytes) : 0.0;
  const double layers = std::floor((perSample - tail) / static_cast<double>(plan.fragmentBytes()));
  const double least = plan.tailInSlot() ? plan.tailSlots() : 1.0;
  if (layers < least || layers * static_cast<double>(samples) > kMostSlots) {
    failInput(
        "the transparency budget gives each of {} {:.2f} bytes, which {} cannot cut into "
        "equal layers of {} bytes{}; change --k-ave or --oit-memory",
        counted(samples, "sample"), perSample, plan.method->id, plan.fragmentBytes(),
        plan.denseTail()    ? " beside its tail of 16"
        : plan.tailInSlot() ? ", 16 bytes of them for its tail"
                            : "");
  }
  plan.layers = static_cast<std::uint32_t>(layers);
  plan.slots = static_cast<std::uint32_t>(plan.layers * samples);
}

}  // namespace

void planBudget(OitPlan& plan, std::uint64_t samples) {
  const double bytes = grantedBytes(plan, samples);
  const double fragments = std::floor(bytes / static_cast<double>(plan.fragmentBytes()));
  if (fragments < 1.0) {
    failInput(
        "the transparency budget holds no fragment ({} bytes each); raise --k-ave or "
        "--oit-memory",
        plan.fragmentBytes());
  }
  if (fragments > kMostSlots) {
    failInput(
        "the transparency budget of {:.0f} fragments is more than {:.0f}; lower --k-ave or "
        "--oit-memory",
        fragments, kMostSlots);
  }
  plan.budgetBytes = static_cast<std::uint64_t>(bytes);
  plan.slots = static_cast<std::uint32_t>(fragments);
  if (plan.method->allocation == Allocation::Constant) planConstant(plan, samples, bytes);
}

std::uint32_t layersOf(const OitPlan& plan) {
  const auto samples =
      static_cast<std::uint64_t>(plan.size.x) * static_cast<std::uint64_t>(plan.size.y);
  return static_cast<std::uint32_t>(
      std::min<std::uint64_t>(plan.slots / samples, MAX_PIXEL_LAYERS));
}

gl::Defines definesOf(const OitPlan& plan) {
  gl::Defines defines;
  const auto define = [&](const char* name) { defines.emplace_back(name, "1"); };
  switch (plan.method->insertion) {
    case Insertion::Appended:
      define("INSERTION_APPEND");
      break;
    case Insertion::Linked:
      define("INSERTION_LINKED");
      break;
    case Insertion::Sorted:
      define("INSERTION_SORTED");
      break;
    case Insertion::AtomicMin:
      define("INSERTION_ATOMIC");
      break;
    case Insertion::StencilRouted:
      define("INSERTION_ROUTED");
      break;
    case Insertion::Blended:
    case Insertion::Weighted:
    case Insertion::Peeled:
      break;
  }
  if (plan.method->hasRanges()) define("RANGES");
  if (plan.packed()) define("PACKED");
  if (plan.tailInSlot()) define("TAIL_IN_SLOT");
  if (plan.dynamicTail()) define("TAIL_DYNAMIC");
  if (plan.denseTail()) define("TAIL_DENSE");
  return defines;
}

gl::Defines syncDefines(const OitPlan& plan) {
  switch (plan.sync) {
    case SyncMode::Interlock:
      return {{"SYNC_INTERLOCK", "1"}};
    case SyncMode::Ordered:
      return {{"SYNC_ORDERED", "1"}};
    case SyncMode::None:
      return {{"SYNC_NONE", "1"}};
    case SyncMode::Spinlock:
    case SyncMode::Auto:
      return {{"SYNC_SPINLOCK", "1"}};
  }
  return {};
}

}  // namespace macula::passes
