#include "passes/oit/allocate_pass.h"

#include "passes/oit/common.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

void AllocatePass::declare(frame::PassDeclaration& d) const {
  if (!plan_.method->stores()) return;
  d.reads(Resource::FragmentCount, Use::Texture);
  if (plan_.method->allocation == Allocation::ImportanceMap) {
    d.reads(Resource::Importance, Use::Image);
  }
  d.writes(Resource::FragmentRange, Use::Image);
  d.writes(Resource::FragmentFill, Use::Image);
  if (plan_.method->keepsFrontNormal()) d.writes(Resource::FrontNormal, Use::Image);
  if (plan_.usesLocks()) d.writes(Resource::FragmentLock, Use::Image);
  d.modifies(Resource::OitTotals, Use::Storage);
}

bool AllocatePass::hasWork(const frame::FrameInputs& in) const {
  return in.facts.transparentTriangles > 0 && plan_.method->stores();
}

std::string AllocatePass::reason(const frame::FrameInputs& in) const {
  return transparencyReason(in, plan_.method->stores(), plan_.method->id);
}

void AllocatePass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  gl::Defines defines = definesOf(plan_);
  if (plan_.usesLocks()) defines.emplace_back("LOCKS", "1");
  program_ = programs.get({{"oit/allocate.comp"}, defines, {}});
}

void AllocatePass::execute(frame::PassContext& context) {
  glUseProgram(program_);
  glUniform1ui(0, plan_.slots);
  context.bindTexture(TEX_INPUT0, Resource::FragmentCount);
  context.bindImage(IMG_0, Resource::FragmentRange, GL_WRITE_ONLY);
  context.bindImage(IMG_1, Resource::FragmentFill, GL_WRITE_ONLY);
  if (plan_.method->allocation == Allocation::ImportanceMap) {
    context.bindImage(IMG_2, Resource::Importance, GL_READ_ONLY);
  }
  if (plan_.method->keepsFrontNormal()) {
    context.bindImage(IMG_3, Resource::FrontNormal, GL_WRITE_ONLY);
  }
  if (plan_.usesLocks()) context.bindImage(IMG_4, Resource::FragmentLock, GL_WRITE_ONLY);
  context.bindStorage(SSBO_OIT_TOTALS, Resource::OitTotals);
  dispatchStrips(context);
}

}  // namespace macula::passes
