#include "passes/oit/network_pass.h"

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
  d.writes(Resource::NetworkOutput, Use::Image);
}

void NetworkPass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  program_ = programs.get(
      {{"oit/network.comp"},
       networkDefines(*plan_.network, plan_.networkModel(), plan_.importance.networkTile),
       {}});
}

void NetworkPass::run(frame::PassContext& context) {
  glUseProgram(program_);
  bindNetworkInputs(context, plan_);
  context.bindImage(IMG_0, Resource::NetworkOutput, GL_WRITE_ONLY);
  const int tile = plan_.importance.networkTile;
  context.dispatch((plan_.size + tile - 1) / tile, kFullScreenGroup);
}

}  // namespace macula::passes
