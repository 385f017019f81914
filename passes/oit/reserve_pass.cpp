#include "passes/oit/reserve_pass.h"

#include "passes/oit/common.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

void ReservePass::declare(frame::PassDeclaration& d) const {
  if (plan_.method->allocation != Allocation::ImportanceMap) return;
  d.reads(Resource::FragmentCount, Use::Texture);
  d.reads(Resource::Importance, Use::Image);
  d.modifies(Resource::OitTotals, Use::Storage);
}

bool ReservePass::hasWork(const frame::FrameInputs& in) const {
  return in.facts.transparentTriangles > 0 && plan_.method->allocation == Allocation::ImportanceMap;
}

std::string ReservePass::reason(const frame::FrameInputs& in) const {
  return transparencyReason(in, plan_.method->allocation == Allocation::ImportanceMap,
                            plan_.method->id);
}

void ReservePass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  program_ = programs.get({{"oit/reserve.comp"}, {}, {}});
}

void ReservePass::execute(frame::PassContext& context) {
  glUseProgram(program_);
  glUniform1ui(0, plan_.slots);
  context.bindTexture(TEX_INPUT0, Resource::FragmentCount);
  context.bindImage(IMG_0, Resource::Importance, GL_READ_ONLY);
  context.bindStorage(SSBO_OIT_TOTALS, Resource::OitTotals);
  dispatchStrips(context);
}

}  // namespace macula::passes
