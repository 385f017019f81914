#include "passes/device_fit.h"

#include <fmt/format.h>

#include <string>

#include "engine/core/error.h"
#include "engine/scene/gpu_scene.h"
#include "passes/frame_list.h"
#include "passes/lod/plan.h"
#include "passes/oit/plan.h"

namespace macula::passes {
namespace {

/// Whether a method runs with its other options at their defaults.
bool fits(const Method& method, const FitInputs& in) {
  RenderSettings settings = in.settings;
  settings.oit = {.method = std::string(method.id), .kAve = in.settings.oit.kAve};
  const auto samples = static_cast<std::uint64_t>(in.frame.displaySize.x) *
                       static_cast<std::uint64_t>(in.frame.displaySize.y);
  OitPlan plan{.method = &method};
  plan.importance = settings.importance;
  try {
    planMethod(plan, {settings.oit, in.device.capabilities, in.device.ordered, samples});
  } catch (const InputError&) {
    return false;
  }
  if (plan.usesNetwork()) return false;  // whose file may not be there
  LodPlan lod;
  planLod(lod, settings.lod, settings.foveation, in.frame.facts, true);
  plan.resizable = lod.transparency;
  plan.imageSize = plan.size = in.frame.displaySize;
  return !makeFrameList(settings, plan, lod).shortage(in.frame, in.device.capabilities.limits);
}

std::string remedy(const FitInputs& in) {
  std::string names;
  for (const Method& method : methods()) {
    if (fits(method, in)) names += fmt::format("{}{}", names.empty() ? "" : ", ", method.id);
  }
  if (names.empty()) return "no --method runs here; use another GPU or driver";
  return "these run with their default options: --method " + names;
}

}  // namespace

void checkDevice(const frame::FrameList& list, const FitInputs& in) {
  const gl::Limits& limits = in.device.capabilities.limits;
  const auto shortage = list.shortage(in.frame, limits);
  if (shortage) failInput("{}; {}", shortage->describe(), remedy(in));
}

}  // namespace macula::passes
