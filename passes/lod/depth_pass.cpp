#include "passes/lod/depth_pass.h"

#include "engine/gl/render_state.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

void LodDepthPass::declareWork(frame::PassDeclaration& d) const {
  d.reads(Resource::Depth, Use::Texture);
  d.writes(Resource::ResizedDepth, Use::DepthTarget);
  d.writes(Resource::ResizedColor, Use::ColorTarget);
}

void LodDepthPass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  program_ = programs.get({{"oit/full_screen.vert", "lod/depth.frag"}, {}, {}});
}

void LodDepthPass::execute(frame::PassContext& context) {
  if (!plan_.resizesTransparency()) return;
  context.bindTargets({Resource::ResizedColor}, Resource::ResizedDepth, plan_.texels);
  gl::apply({.depthTest = true, .depthFunc = GL_ALWAYS, .depthWrite = true});
  glProgramUniform2f(program_, 0, pitch().x, pitch().y);
  context.bindTexture(TEX_INPUT0, Resource::Depth);
  fullScreen_.draw(program_);
}

}  // namespace macula::passes
