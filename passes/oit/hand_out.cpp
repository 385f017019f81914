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
  d.writes(Resource::FragmentRange, Use::Image);
  d.writes(Resource::FragmentFill, Use::Image);
  if (plan.keepsFrontNormal()) d.writes(Resource::FrontNormal, Use::Image);
  if (plan.usesLocks()) d.writes(Resource::FragmentLock, Use::Image);
  if (emptiesTails(plan)) {
    d.writes(Resource::FragmentKeys, Use::Storage);
    if (!plan.packed()) d.writes(Resource::FragmentColors, Use::Storage);
  }
}

gl::Defines handOutDefines(const OitPlan& plan) {
  gl::Defines defines;
  if (plan.packed()) defines.emplace_back("PACKED", "1");
  if (emptiesTails(plan)) defines.emplace_back("TAIL_IN_SLOT", "1");
  if (plan.keepsFrontNormal()) defines.emplace_back("FRONT_NORMAL", "1");
  if (plan.usesLocks()) defines.emplace_back("LOCKS", "1");
  return defines;
}

void bindHandOut(const frame::PassContext& context, const OitPlan& plan) {
  context.bindImage(IMG_0, Resource::FragmentRange, GL_WRITE_ONLY);
  context.bindImage(IMG_1, Resource::FragmentFill, GL_WRITE_ONLY);
  if (plan.keepsFrontNormal()) context.bindImage(IMG_3, Resource::FrontNormal, GL_WRITE_ONLY);
  if (plan.usesLocks()) context.bindImage(IMG_4, Resource::FragmentLock, GL_WRITE_ONLY);
  if (emptiesTails(plan)) {
    context.bindStorage(SSBO_FRAGMENT_KEYS, Resource::FragmentKeys);
    if (!plan.packed()) context.bindStorage(SSBO_FRAGMENT_COLORS, Resource::FragmentColors);
  }
}

}  // namespace macula::passes
