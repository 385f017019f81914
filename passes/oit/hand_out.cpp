#include "passes/oit/hand_out.h"

#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

namespace {

/// Tails that are known before the capture begin empty.
bool emptiesTails(const OitPlan& plan) {
  return plan.tailInSlot() && !plan.dynamicTail();
}

}  // namespace

void declareHandOut(frame::PassDeclaration& d, const OitPlan& plan) {
  // Emptied as a whole, which is cheaper than a store in every pixel; only covered ones are
  // written.
  d.modifies(Resource::FragmentRange, Use::Image);
  if (emptiesTails(plan)) {
    d.writes(Resource::FragmentKeys, Use::Storage);
    if (!plan.packed()) d.writes(Resource::FragmentColors, Use::Storage);
  }
}

gl::Defines handOutDefines(const OitPlan& plan) {
  gl::Defines defines;
  if (plan.packed()) defines.emplace_back("PACKED", "1");
  if (emptiesTails(plan)) defines.emplace_back("TAIL_IN_SLOT", "1");
  return defines;
}

void bindHandOut(const frame::PassContext& context, const OitPlan& plan) {
  context.bindImage(IMG_0, Resource::FragmentRange, GL_WRITE_ONLY);
  if (emptiesTails(plan)) {
    context.bindStorage(SSBO_FRAGMENT_KEYS, Resource::FragmentKeys);
    if (!plan.packed()) context.bindStorage(SSBO_FRAGMENT_COLORS, Resource::FragmentColors);
  }
}

}  // namespace macula::passes
