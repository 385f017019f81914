#include "passes/oit/slots.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/error.h"
#include "engine/core/plural.h"
#include "shared/oit_constants.h"

namespace macula::passes {
namespace {

/// Products of importance and slots must stay exact in shaders/lib/budget.glsl.
constexpr double kMostSlots = 1U << 29U;
constexpr double kMebi = 1024.0 * 1024.0;
/// Bytes of one pixel of the dense tail: sum of tau c, sum of tau.
constexpr double kDenseTailBytes = 16.0;
/// First size of an exact method's pool, in slots a sample; it grows to what the frames need.
constexpr std::uint64_t kFirstSlotsPerSample = 2;
/// A pool grows by this part more than is needed, so that a slow approach does not draw every frame
/// twice.
constexpr std::uint32_t kSparePart = 8;

void setPool(OitPlan& plan, std::uint64_t slots) {
  plan.slots = plan.poolSlots = std::max(1U, static_cast<std::uint32_t>(slots));
}

/// Bytes that the budget grants. Vasilakis 2017, Eq. 2: M = k_ave w h fragments; or M bytes.
double grantedBytes(const OitPlan& plan, std::uint64_t samples) {
  const OitSettings& s = plan.options;
  if (s.memoryMiB > 0.0) return std::floor(s.memoryMiB * kMebi);
  const double slots = std::floor(s.kAve * static_cast<double>(samples));
  return slots * static_cast<double>(plan.fragmentBytes());
}

}  // namespace

void planBudgetPool(OitPlan& plan, const PlanInputs& in) {
  const double bytes = grantedBytes(plan, in.samples);
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
  setPool(plan, static_cast<std::uint64_t>(fragments));
}

void planBudgetLayers(OitPlan& plan, const PlanInputs& in) {
  planBudgetPool(plan, in);
  const auto samples = static_cast<double>(in.samples);
  const double perSample = grantedBytes(plan, in.samples) / samples;
  const double tail = plan.denseTail() ? kDenseTailBytes : 0.0;
  const double layers = std::floor((perSample - tail) / static_cast<double>(plan.fragmentBytes()));
  const double least = plan.tailInSlot() ? plan.tailSlots() : 1.0;
  if (layers < least || layers * samples > kMostSlots) {
    failInput(
        "the transparency budget gives each of {} {:.2f} bytes, which {} cannot cut into "
        "equal layers of {} bytes{}; change --k-ave or --oit-memory",
        counted(in.samples, "sample"), perSample, plan.method->id, plan.fragmentBytes(),
        plan.denseTail()    ? " beside its tail of 16"
        : plan.tailInSlot() ? ", 16 bytes of them for its tail"
                            : "");
  }
  plan.layers = static_cast<std::uint32_t>(layers);
  setPool(plan, plan.layers * in.samples);
}

void planBudgetSamples(OitPlan& plan, const PlanInputs& in) {
  planBudgetLayers(plan, in);
  if (in.device.routableSamples.empty()) {
    failInput(
        "{} keeps a fragment in each sample, and {} has no multisample targets of integers "
        "(GL_MAX_INTEGER_SAMPLES); use kb-fixed",
        plan.method->id, in.device.renderer);
  }
  // Bytes are promised, so only numbers of samples that the GPU really makes are used.
  int best = 0;
  int least = 0;
  for (const int samples : in.device.routableSamples) {
    if (samples <= static_cast<int>(plan.layers)) best = std::max(best, samples);
    if (least == 0 || samples < least) least = samples;
  }
  if (best == 0) {
    failInput(
        "{} keeps a fragment in each sample, and {} has {} a pixel at the least; "
        "the budget gives {}; raise --k-ave or --oit-memory, or use kb-fixed",
        plan.method->id, in.device.renderer, counted(static_cast<std::uint64_t>(least), "sample"),
        plan.layers);
  }
  plan.layers = static_cast<std::uint32_t>(best);
}

void planSettingLayers(OitPlan& plan, const PlanInputs& in) {
  const std::uint64_t slots = plan.layers * in.samples;
  if (slots > std::numeric_limits<std::uint32_t>::max()) {
    failInput(
        "{} for each of {} are more than can be addressed; lower "
        "--oit.layers or --size",
        counted(plan.layers, "slot"), counted(in.samples, "sample"));
  }
  setPool(plan, slots);
}

void planGrowingPool(OitPlan& plan, const PlanInputs& in) {
  if (plan.options.memoryMiB > 0.0) {
    // A cap instead of growth: what does not fit is counted, and the frame is flagged inexact.
    const std::uint64_t each =
        plan.fragmentBytes() + (plan.method->insertion.links ? kLinkBytes : 0);
    plan.budgetBytes = static_cast<std::uint64_t>(plan.options.memoryMiB * kMebi);
    if (*plan.budgetBytes < each) {
      failInput("--oit-memory of {} holds no fragment ({} bytes each); raise it, or 0",
                counted(*plan.budgetBytes, "byte"), each);
    }
    setPool(plan, *plan.budgetBytes / each);
  } else if (const auto first = in.samples * kFirstSlotsPerSample; plan.slots < first) {
    setPool(plan, first);
  }
}

bool needsLargerPool(const OitPlan& plan, std::uint32_t asked) {
  return plan.method->grows() && !plan.budgetBytes && asked > plan.slots;
}

void growPool(OitPlan& plan, std::uint32_t asked) {
  setPool(plan, asked + asked / kSparePart);
}

}  // namespace macula::passes
