// Networks of importance. The thesis's (kb-learned) gives each pixel an importance, from features
// that the count pass gathers; Macula's own corrects the predicted error of utility/. Either one is
// evaluated once for each covered tile and interpolated between tiles.
#include "engine/gl/gl.h"
#include "passes/oit/learned/network_inputs.h"
#include "passes/oit/oit_pass.h"
#include "passes/oit/passes.h"
#include "passes/oit/utility/covered.h"
#include "shared/bindings.h"

namespace macula::passes {
namespace {

using frame::Access;

/// Sums the features of the whole image: fragments, covered pixels, nearest and farthest depth.
class ExtentPass final : public OitComputePass {
 public:
  using OitComputePass::OitComputePass;
  [[nodiscard]] std::string_view name() const override { return "oit.extent"; }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    d.texture(TEX_INPUT0, kFragmentCount);
    d.texture(TEX_INPUT1, kDepthRange);
    totalsRow(d, Access::ReadWrite);
  }

 private:
  [[nodiscard]] bool wanted() const override { return plan_.gathersColors(); }

  [[nodiscard]] gl::ProgramKey program() const override { return {{"oit/extent.comp"}, {}, {}}; }
};

class NetworkPass final : public OitComputePass {
 public:
  using OitComputePass::OitComputePass;
  [[nodiscard]] std::string_view name() const override { return "oit.network"; }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    networkInputRows(d, plan_);
    coveredTilesRows(d);
    // 0 where nothing is transparent: only covered tiles are written.
    d.image(IMG_0, kNetworkOutput, Access::ReadWrite);
    const int tile = plan_.importance.networkTile;
    d.size(kNetworkOutput, (plan_.imageSize + tile - 1) / tile);
  }

 private:
  [[nodiscard]] bool wanted() const override { return plan_.usesNetwork(); }

  [[nodiscard]] gl::ProgramKey program() const override {
    gl::Defines defines =
        networkDefines(*plan_.network, plan_.networkModel(), plan_.importance.tile);
    defines.push_back(listedTileDefine(plan_));
    return {{"oit/network.comp"}, defines, {}};
  }

  void dispatch(const frame::PassContext& context) override {
    setNetworkUniforms(plan_);
    dispatchCoveredTiles(context);
  }
};

/// Importance of each pixel by the thesis's network, in the place of the published map, and its
/// sum.
class NetworkImportancePass final : public OitComputePass {
 public:
  using OitComputePass::OitComputePass;
  [[nodiscard]] std::string_view name() const override { return "oit.networkImportance"; }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    d.texture(TEX_INPUT0, kFragmentCount);
    d.texture(TEX_INPUT2, kNetworkOutput);
    // 0 where nothing is transparent: only covered pixels are written.
    d.image(IMG_0, kImportance, Access::ReadWrite);
    if (plan_.factorMaps) d.image(IMG_1, kImportanceFactors, Access::ReadWrite);
    totalsRow(d, Access::ReadWrite);
  }

 private:
  [[nodiscard]] bool wanted() const override {
    return plan_.mapsImportance() && plan_.usesNetwork();
  }

  [[nodiscard]] gl::ProgramKey program() const override {
    gl::Defines defines{{"NETWORK_TILE", std::to_string(plan_.importance.networkTile)}};
    if (plan_.factorMaps) defines.emplace_back("FACTORS", "1");
    return {{"oit/network_importance.comp"}, defines, {}};
  }
};

}  // namespace

void networkInputRows(frame::PassDeclaration& d, const OitPlan& plan) {
  d.texture(TEX_INPUT0, kFragmentCount);
  if (plan.networkModel() == NetworkModel::Thesis) {
    d.texture(TEX_INPUT1, kDepthRange);
    d.texture(TEX_INPUT3, kColorSums);
    d.texture(TEX_INPUT4, kNearestColor);
  } else {
    d.storage(SSBO_SLICES, kSliceSums, Access::Read);
    // The opaque image, at full rate even where transparency is at a reduced rate.
    d.texture(TEX_INPUT1, kHdrColor);
  }
}

void setNetworkUniforms(const OitPlan& plan) {
  if (plan.networkModel() != NetworkModel::Learned) return;
  const glm::vec2 pitch = plan.pitch();
  glUniform2f(0, pitch.x, pitch.y);
}

OitPassPtr makeExtentPass(const OitPlan& plan) {
  return std::make_unique<ExtentPass>(plan);
}

OitPassPtr makeNetworkPass(const OitPlan& plan) {
  return std::make_unique<NetworkPass>(plan);
}

OitPassPtr makeNetworkImportancePass(const OitPlan& plan) {
  return std::make_unique<NetworkImportancePass>(plan);
}

}  // namespace macula::passes
