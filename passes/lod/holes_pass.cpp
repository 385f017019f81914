#include "passes/lod/holes_pass.h"

#include "passes/opaque_shading.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

void LodHolesPass::declareWork(frame::PassDeclaration& d) const {
  declareShadingInputs(d);
  d.reads(Resource::LodHoles, Use::Storage);
  d.reads(Resource::LodTotals, Use::Indirect);
  d.modifies(plan_.target(), Use::Image);
}

void LodHolesPass::prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) {
  const ShadingWork work = plan_.parts.shading ? ShadingWork::All : ShadingWork::Parts;
  gl::Defines defines = shadingDefines(in.facts, work, plan_.parts);
  defines.emplace_back("AT_HOLES", "1");
  program_ = programs.get({{"lighting.comp"}, defines, {}});
}

void LodHolesPass::execute(frame::PassContext& context) {
  if (plan_.fullRate()) return;
  glUseProgram(program_);
  bindShadingInputs(context);
  context.bindImage(IMG_0, plan_.target(), GL_WRITE_ONLY);
  context.bindStorage(SSBO_LOD_HOLES, Resource::LodHoles);
  context.bindStorage(SSBO_LOD_TOTALS, Resource::LodTotals);
  for (int i = 0; i < plan_.load; ++i) {
    context.dispatchIndirect(Resource::LodTotals, dispatchOffset(LOD_RATES));
  }
}

}  // namespace macula::passes
