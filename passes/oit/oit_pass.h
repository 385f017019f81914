// What the passes of transparency share: the plan, and that they work where something is
// transparent and the plan wants them.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <initializer_list>
#include <string>

#include "engine/core/plural.h"
#include "engine/frame/pass.h"
#include "engine/frame/pass_context.h"
#include "passes/oit/plan.h"
#include "shared/dispatch.h"
#include "shared/oit_constants.h"

namespace macula::passes {

/// Threads of a group of the full-screen passes.
inline constexpr glm::ivec2 kFullScreenGroup{FULLSCREEN_GROUP};

/// A pass that some methods use and others do not.
class OitPass : public frame::Pass {
 public:
  explicit OitPass(const OitPlan& plan) : plan_(plan) {}
  [[nodiscard]] bool hasWork(const frame::FrameInputs& in) const final {
    return in.facts.transparentTriangles > 0 && wanted();
  }
  [[nodiscard]] std::string reason(const frame::FrameInputs& in) const final {
    if (in.facts.transparentTriangles == 0) return "nothing transparent";
    if (!wanted()) return fmt::format("{} does not use it", plan_.method->id);
    return fmt::format("{} by {}", counted(in.facts.transparentTriangles, "transparent triangle"),
                       plan_.method->id);
  }
  void declare(frame::PassDeclaration& d) const final {
    if (wanted()) declareWork(d);
  }
  void execute(frame::PassContext& context) final {
    if (plan_.resized()) context.bindConstants(frame::Raster::Resized);
    run(context);
    if (plan_.resized()) context.bindConstants(frame::Raster::Image);
  }

 protected:
  /// Whether the plan's method uses this pass.
  [[nodiscard]] virtual bool wanted() const = 0;
  /// What it touches where it is wanted.
  virtual void declareWork(frame::PassDeclaration& d) const = 0;
  /// Its work in one frame, at the plan's size. Allocates nothing.
  virtual void run(frame::PassContext& context) = 0;

  // Which of two resources a frame uses may change from frame to frame; declarations name both.
  void readsDepth(frame::PassDeclaration& d, frame::Use use) const {
    d.reads(frame::Resource::Depth, use);
    if (plan_.resizable) d.reads(frame::Resource::ResizedDepth, use);
  }
  void readsTestedDepth(frame::PassDeclaration& d, frame::Use use) const {
    plan_.culls() ? d.reads(frame::Resource::CullDepth, use) : readsDepth(d, use);
  }
  void modifiesColor(frame::PassDeclaration& d, frame::Use use) const {
    d.modifies(frame::Resource::HdrColor, use);
    if (plan_.resizable) d.modifies(frame::Resource::ResizedColor, use);
  }
  /// Binds targets with a viewport of the plan's size.
  void bindTargets(const frame::PassContext& context, std::initializer_list<frame::Resource> colors,
                   frame::Resource depth) const {
    context.bindTargets(colors, depth, plan_.size);
  }

  const OitPlan& plan_;
};

/// Threads for all strips of so many samples and the shape of their groups: a row of groups per row
/// of samples.
inline void dispatchStrips(const frame::PassContext& context, glm::ivec2 size) {
  const glm::ivec2 threads((size.x + STRIP - 1) / STRIP, size.y);
  context.dispatch(threads, {STRIP_GROUP, 1});
}

/// Pixels a side of which the search for a price looks at one.
[[nodiscard]] inline int priceStride(glm::ivec2 size) {
  const auto pixels = static_cast<std::int64_t>(size.x) * size.y;
  int stride = 1;
  while (pixels / (stride * stride) > PRICE_PIXELS) ++stride;
  return stride;
}

}  // namespace macula::passes
