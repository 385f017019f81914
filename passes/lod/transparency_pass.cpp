#include "passes/lod/transparency_pass.h"

#include "shared/bindings.h"
#include "shared/dispatch.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

namespace {

constexpr glm::ivec2 kGroup{FULLSCREEN_GROUP};

}  // namespace

void LodTransparencyPass::declareWork(frame::PassDeclaration& d) const {
  d.reads(Resource::ResizedColor, Use::Texture);
  d.reads(Resource::ResizedDepth, Use::Texture);
  d.reads(Resource::Depth, Use::Texture);
  d.reads(Resource::Normal, Use::Texture);
  d.modifies(Resource::HdrColor, Use::Image);
}

void LodTransparencyPass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  program_ = programs.get({{"lod/transparency.comp"}, {}, {}});
}

void LodTransparencyPass::execute(frame::PassContext& context) {
  if (!plan_.resizesTransparency()) return;
  glUseProgram(program_);
  glUniform2f(0, pitch().x, pitch().y);
  glUniform2i(1, plan_.texels.x, plan_.texels.y);
  context.bindTexture(TEX_INPUT0, Resource::ResizedColor);
  context.bindTexture(TEX_INPUT1, Resource::ResizedDepth);
  context.bindTexture(TEX_INPUT2, Resource::Depth);
  context.bindTexture(TEX_INPUT3, Resource::Normal);
  context.bindImage(IMG_0, Resource::HdrColor, GL_READ_WRITE);
  context.dispatch(plan_.texels + 1, kGroup);  // a cell between texels each, and outside of the rim
}

}  // namespace macula::passes
