#include "passes/oit/plan.h"

#include <algorithm>

#include "shared/network.h"
#include "shared/oit_constants.h"

namespace macula::passes {
namespace {

const char* syncDefine(SyncMode mode) {
  switch (mode) {
    case SyncMode::Interlock:
      return "SYNC_INTERLOCK";
    case SyncMode::Ordered:
      return "SYNC_ORDERED";
    case SyncMode::None:
      return "SYNC_NONE";
    case SyncMode::Spinlock:
    case SyncMode::Auto:
      break;
  }
  return "SYNC_SPINLOCK";
}

/// Slots a sample or texel where they are constant: what the pool gives those of this frame.
std::uint32_t layersOf(const OitPlan& plan) {
  const auto samples =
      static_cast<std::uint64_t>(plan.size.x) * static_cast<std::uint64_t>(plan.size.y);
  return static_cast<std::uint32_t>(
      std::min<std::uint64_t>(plan.slots / samples, MAX_PIXEL_LAYERS));
}

}  // namespace

void planMethod(OitPlan& plan, const PlanInputs& in) {
  const Method& method = methodById(in.settings.method);
  if (plan.method != &method) plan.slots = plan.poolSlots = 1;
  plan.method = &method;
  plan.options = in.settings;
  plan.layers = static_cast<std::uint32_t>(in.settings.layers);  // which peeling uses as they are
  plan.sync = method.isRacy() ? SyncMode::None
                              : chooseSync(syncByName(in.settings.sync), in.device, in.ordered);
  plan.budgetBytes.reset();
  if (method.allocation.planSlots != nullptr) method.allocation.planSlots(plan, in);
}

void planNetwork(OitPlan& plan, LoadedNetwork& loaded) {
  plan.network = nullptr;
  if (!plan.usesNetwork()) return;
  if (plan.learnsUtility()) plan.importance.slices = LEARNED_SLICES;
  plan.network = &loaded.get(plan.networkModel(), plan.options.network);
}

void planFrameSlots(OitPlan& plan, float share) {
  const Allocation& allocation = plan.method->allocation;
  if (!allocation.adjusts) return;
  plan.slots =
      std::max(1U, static_cast<std::uint32_t>(static_cast<double>(share) * plan.poolSlots));
  if (!allocation.constant) return;
  // The same slots for the texels there are; one each, or what a tail takes, is the least.
  const std::uint32_t least = static_cast<std::uint32_t>(plan.size.x) *
                              static_cast<std::uint32_t>(plan.size.y) *
                              (plan.tailInSlot() ? plan.tailSlots() : 1U);
  plan.slots = std::min(std::max(plan.slots, least), plan.poolSlots);
  plan.layers = layersOf(plan);
}

gl::Defines definesOf(const OitPlan& plan) {
  gl::Defines defines;
  const auto define = [&](const char* name) { defines.emplace_back(name, "1"); };
  if (plan.method->stores()) define(plan.method->insertion.define);
  if (plan.method->hasRanges()) define("RANGES");
  if (plan.packed()) define("PACKED");
  if (plan.tailInSlot()) define("TAIL_IN_SLOT");
  if (plan.dynamicTail()) define("TAIL_DYNAMIC");
  if (plan.denseTail()) define("TAIL_DENSE");
  return defines;
}

gl::Defines captureDefines(const OitPlan& plan) {
  gl::Defines defines = definesOf(plan);
  if (plan.method->hasFill()) defines.emplace_back(syncDefine(plan.sync), "1");
  if (plan.keepsFrontNormal()) defines.emplace_back("FRONT_NORMAL", "1");
  if (plan.predictsCounts()) defines.emplace_back("COUNT_OUT", "1");
  return defines;
}

std::vector<std::string> captureExtensions(const OitPlan& plan) {
  if (plan.sync != SyncMode::Interlock || !plan.sorted()) return {};
  return {"GL_ARB_fragment_shader_interlock"};
}

}  // namespace macula::passes
