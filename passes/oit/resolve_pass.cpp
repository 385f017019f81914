#include "passes/oit/resolve_pass.h"

#include "passes/oit/common.h"
#include "shared/bindings.h"
#include "shared/dispatch.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

namespace {

constexpr glm::ivec2 kGroup{FULLSCREEN_GROUP};

}  // namespace

void ResolvePass::declare(frame::PassDeclaration& d) const {
  if (!plan_.method->stores()) return;
  d.reads(Resource::FragmentRange, Use::Texture);
  d.reads(Resource::FragmentFill, Use::Texture);
  if (plan_.method->insertion == Insertion::Sorted) {
    d.reads(Resource::FragmentKeys, Use::Storage);
    d.reads(Resource::FragmentColors, Use::Storage);
  } else {  // deep pixels are sorted in place
    d.consumes(Resource::FragmentKeys, Use::Storage);
    d.consumes(Resource::FragmentColors, Use::Storage);
  }
  d.modifies(Resource::HdrColor, Use::Image);
}

bool ResolvePass::hasWork(const frame::FrameInputs& in) const {
  return in.facts.transparentTriangles > 0 && plan_.method->stores();
}

std::string ResolvePass::reason(const frame::FrameInputs& in) const {
  return transparencyReason(in, plan_.method->stores(), plan_.method->id);
}

void ResolvePass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  gl::Defines defines;
  if (plan_.method->insertion == Insertion::Sorted) defines.emplace_back("SORTED", "1");
  program_ = programs.get({{"oit/resolve.comp"}, defines, {}});
}

void ResolvePass::execute(frame::PassContext& context) {
  glUseProgram(program_);
  context.bindTexture(TEX_INPUT0, Resource::FragmentRange);
  context.bindTexture(TEX_INPUT1, Resource::FragmentFill);
  context.bindImage(IMG_0, Resource::HdrColor, GL_READ_WRITE);
  context.bindStorage(SSBO_FRAGMENT_KEYS, Resource::FragmentKeys);
  context.bindStorage(SSBO_FRAGMENT_COLORS, Resource::FragmentColors);
  context.dispatch(context.inputs().displaySize, kGroup);
}

}  // namespace macula::passes
