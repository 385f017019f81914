#include "passes/oit/network_inputs.h"

#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

void declareNetworkInputs(frame::PassDeclaration& d, const OitPlan& plan) {
  d.reads(Resource::FragmentCount, Use::Texture);
  if (plan.networkModel() == NetworkModel::Thesis) {
    d.reads(Resource::DepthRange, Use::Texture);
    d.reads(Resource::ColorSums, Use::Texture);
    d.reads(Resource::NearestColor, Use::Texture);
  } else {
    d.reads(Resource::SliceSums, Use::Storage);
    d.reads(Resource::HdrColor, Use::Texture);
  }
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

}  // namespace macula::passes
