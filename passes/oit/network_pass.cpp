#include "passes/oit/network_pass.h"

#include "passes/oit/covered_lists.h"
#include "passes/oit/network_inputs.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool NetworkPass::wanted() const {
  return plan_.usesNetwork();
}

void NetworkPass::declareWork(frame::PassDeclaration& d) const {
  declareNetworkInputs(d, plan_);
  declareCoveredTiles(d);
  d.modifies(Resource::NetworkOutput, Use::Image);  // 0 where nothing is transparent
}

void NetworkPass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  gl::Defines defines = networkDefines(*plan_.network, plan_.networkModel(), plan_.importance.tile);
  defines.push_back(listedTileDefine(plan_));
  program_ = programs.get({{"oit/network.comp"}, defines, {}});
}

void NetworkPass::run(frame::PassContext& context) {
  glUseProgram(program_);
  bindNetworkInputs(context, plan_);
  context.bindImage(IMG_0, Resource::NetworkOutput, GL_WRITE_ONLY);
  dispatchCoveredTiles(context);
}

}  // namespace macula::passes
