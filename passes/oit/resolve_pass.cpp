#include "passes/oit/resolve_pass.h"

#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool ResolvePass::wanted() const {
  return plan_.method->stores();
}

void ResolvePass::declareWork(frame::PassDeclaration& d) const {
  const Insertion insertion = plan_.method->insertion;
  if (plan_.method->hasRanges()) d.reads(Resource::FragmentRange, Use::Texture);
  if (insertion == Insertion::StencilRouted) {
    d.reads(Resource::RoutedKeys, Use::Texture);
    d.reads(Resource::RoutedColors, Use::Texture);
  } else {
    if (insertion != Insertion::AtomicMin) d.reads(Resource::FragmentFill, Use::Texture);
    // Sorting in place leaves the arrays in an order of its own.
    d.consumes(Resource::FragmentKeys, Use::Storage);
    if (!plan_.packed()) d.consumes(Resource::FragmentColors, Use::Storage);
    if (insertion == Insertion::Linked) d.consumes(Resource::FragmentLinks, Use::Storage);
  }
  if (plan_.denseTail()) d.reads(Resource::TailSums, Use::Texture);
  modifiesColor(d, Use::Image);
}

void ResolvePass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  program_ = programs.get({{"oit/resolve.comp"}, definesOf(plan_), {}});
}

void ResolvePass::run(frame::PassContext& context) {
  const Insertion insertion = plan_.method->insertion;
  glUseProgram(program_);
  if (plan_.method->hasRanges()) context.bindTexture(TEX_INPUT0, Resource::FragmentRange);
  if (insertion == Insertion::StencilRouted) {
    context.bindTexture(TEX_INPUT3, Resource::RoutedKeys);
    context.bindTexture(TEX_INPUT4, Resource::RoutedColors);
  } else {
    if (insertion != Insertion::AtomicMin) {
      context.bindTexture(TEX_INPUT1, Resource::FragmentFill);
    }
    context.bindStorage(SSBO_FRAGMENT_KEYS, Resource::FragmentKeys);
    if (!plan_.packed()) context.bindStorage(SSBO_FRAGMENT_COLORS, Resource::FragmentColors);
    if (insertion == Insertion::Linked) {
      context.bindStorage(SSBO_FRAGMENT_LINKS, Resource::FragmentLinks);
    }
  }
  if (plan_.denseTail()) context.bindTexture(TEX_INPUT2, Resource::TailSums);
  context.bindImage(IMG_0, plan_.color(), GL_READ_WRITE);
  context.dispatch(plan_.size, kFullScreenGroup);
}

}  // namespace macula::passes
