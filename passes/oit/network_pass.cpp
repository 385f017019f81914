#include "passes/oit/network_pass.h"

#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool NetworkPass::wanted() const {
  return plan_.usesNetwork();
}

void NetworkPass::declareWork(frame::PassDeclaration& d) const {
  d.reads(Resource::FragmentCount, Use::Texture);
  if (plan_.networkModel() == NetworkModel::Thesis) {
    d.reads(Resource::DepthRange, Use::Texture);
    d.reads(Resource::ColorSums, Use::Texture);
    d.reads(Resource::NearestColor, Use::Texture);
    d.reads(Resource::OitTotals, Use::Storage);
  } else {
    d.reads(Resource::SliceSums, Use::Storage);
    d.reads(Resource::HdrColor, Use::Texture);
  }
  d.writes(Resource::NetworkOutput, Use::Image);
}

void NetworkPass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  program_ = programs.get(
      {{"oit/network.comp"},
       networkDefines(*plan_.network, plan_.networkModel(), plan_.importance.networkTile),
       {}});
}

void bindNetworkInputs(const frame::PassContext& context, const OitPlan& plan) {
  context.bindTexture(TEX_INPUT0, Resource::FragmentCount);
  if (plan.networkModel() == NetworkModel::Thesis) {
    context.bindTexture(TEX_INPUT1, Resource::DepthRange);
    context.bindTexture(TEX_INPUT3, Resource::ColorSums);
    context.bindTexture(TEX_INPUT4, Resource::NearestColor);
    context.bindStorage(SSBO_OIT_TOTALS, Resource::OitTotals);
  } else {
    context.bindStorage(SSBO_SLICES, Resource::SliceSums);
    // The opaque image, also where transparency is resized.
    context.bindTexture(TEX_INPUT1, Resource::HdrColor);
    const glm::vec2 pitch = glm::vec2(plan.imageSize) / glm::vec2(plan.size);
    glUniform2f(0, pitch.x, pitch.y);
  }
}

void NetworkPass::run(frame::PassContext& context) {
  glUseProgram(program_);
  bindNetworkInputs(context, plan_);
  context.bindImage(IMG_0, Resource::NetworkOutput, GL_WRITE_ONLY);
  const int tile = plan_.importance.networkTile;
  context.dispatch((plan_.size + tile - 1) / tile, kFullScreenGroup);
}

}  // namespace macula::passes
