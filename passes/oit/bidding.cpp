#include "passes/oit/bidding.h"

#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

void declareBids(frame::PassDeclaration& d, const OitPlan& plan) {
  d.reads(plan.countResource(), Use::Texture);
  if (plan.mapsImportance()) d.reads(Resource::Importance, Use::Image);
  if (plan.learnsBids()) d.reads(Resource::NetworkOutput, Use::Texture);
  if (plan.slices()) {
    d.reads(Resource::SliceSums, Use::Storage);
    d.reads(Resource::HdrColor, Use::Texture);
  }
}

void addSliceDefines(gl::Defines& defines, const OitPlan& plan) {
  defines.emplace_back("SLICES", std::to_string(plan.importance.slices));
  defines.emplace_back("SLICE_TILE", std::to_string(plan.importance.tile));
}

gl::Defines bidDefines(const OitPlan& plan) {
  gl::Defines defines;
  if (plan.packed()) defines.emplace_back("PACKED", "1");
  if (plan.tailInSlot()) defines.emplace_back("TAIL_IN_SLOT", "1");
  const Predictor predictor = plan.options.importance;
  defines.emplace_back(plan.method->allocation == Allocation::OneK ? "BID_UNIFORM"
                       : predictor == Predictor::Published         ? "BID_IMPORTANCE"
                       : predictor == Predictor::Transmittance     ? "BID_TRANSMITTANCE"
                                                                   : "BID_ERROR",
                       "1");
  if (plan.learnsBids()) {
    defines.emplace_back("BID_LEARNED", "1");
    defines.emplace_back("NETWORK_TILE", std::to_string(plan.importance.networkTile));
  }
  if (plan.slices()) addSliceDefines(defines, plan);
  return defines;
}

void bindBids(const frame::PassContext& context, const OitPlan& plan) {
  context.bindTexture(TEX_INPUT0, plan.countResource());
  if (plan.mapsImportance()) context.bindImage(IMG_2, Resource::Importance, GL_READ_ONLY);
  if (plan.learnsBids()) context.bindTexture(TEX_INPUT2, Resource::NetworkOutput);
  if (plan.slices()) {
    context.bindStorage(SSBO_SLICES, Resource::SliceSums);
    // The opaque image, also where transparency is resized.
    context.bindTexture(TEX_INPUT1, Resource::HdrColor);
    const glm::vec2 pitch = glm::vec2(plan.imageSize) / glm::vec2(plan.size);
    glUniform2f(1, pitch.x, pitch.y);
    glUniform2f(0, static_cast<float>(plan.importance.periphery),
                static_cast<float>(plan.importance.gazeWeight));
  }
}

}  // namespace macula::passes
