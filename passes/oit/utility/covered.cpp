#include "passes/oit/utility/covered.h"

#include <algorithm>
#include <cstddef>

#include "passes/oit/passes.h"
#include "shared/bindings.h"
#include "shared/oit_constants.h"
#include "shared/oit_totals.h"

namespace macula::passes {
namespace {

using frame::Access;

std::size_t area(glm::ivec2 size) {
  return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
}

/// Makes one of the lists, at the size of this frame.
class CoveredPass : public OitComputePass {
 public:
  CoveredPass(const OitPlan& plan, std::string_view name, const frame::Resource& list)
      : OitComputePass(plan), name_(name), list_(list) {}
  [[nodiscard]] std::string_view name() const override { return name_; }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    d.texture(TEX_INPUT0, plan_.countResource());
    d.storage(SSBO_COVERED, list_, Access::Write);
    d.bytes(list_, mostEntries() * sizeof(std::uint32_t));
    totalsRow(d, Access::ReadWrite);
  }

 protected:
  /// Samples a side of a place.
  [[nodiscard]] virtual int side() const = 0;
  /// Of any size that is drawn.
  [[nodiscard]] virtual std::size_t mostEntries() const = 0;
  [[nodiscard]] virtual gl::Defines::value_type define() const = 0;

 private:
  [[nodiscard]] gl::ProgramKey program() const override {
    return {{"oit/covered.comp"}, {define()}, {}};
  }

  void dispatch(const frame::PassContext& context) override {
    dispatchTiles(context, (plan_.size + side() - 1) / side());
  }

  std::string_view name_;
  const frame::Resource& list_;
};

class CoveredTilesPass final : public CoveredPass {
 public:
  explicit CoveredTilesPass(const OitPlan& plan)
      : CoveredPass(plan, "oit.coveredTiles", kCoveredTiles) {}

 private:
  [[nodiscard]] bool wanted() const override { return plan_.listsTiles(); }
  [[nodiscard]] int side() const override { return plan_.listedTile(); }
  [[nodiscard]] std::size_t mostEntries() const override {
    return area((plan_.imageSize + side() - 1) / side());
  }
  [[nodiscard]] gl::Defines::value_type define() const override { return listedTileDefine(plan_); }
};

class CoveredSamplesPass final : public CoveredPass {
 public:
  explicit CoveredSamplesPass(const OitPlan& plan)
      : CoveredPass(plan, "oit.coveredSamples", kCoveredSamples) {}

 private:
  [[nodiscard]] bool wanted() const override { return plan_.sharesByUtility(); }
  [[nodiscard]] int side() const override { return sampledCellSide(plan_.size); }
  [[nodiscard]] std::size_t mostEntries() const override {
    const glm::ivec2 size = plan_.imageSize;
    // Cells that the last row and column only begin add some to SAMPLED_PIXELS.
    return std::min(area(size), static_cast<std::size_t>(SAMPLED_PIXELS + size.x + size.y + 1));
  }
  [[nodiscard]] gl::Defines::value_type define() const override { return {"SAMPLED", "1"}; }
};

}  // namespace

int sampledCellSide(glm::ivec2 size) {
  const auto pixels = static_cast<std::int64_t>(size.x) * size.y;
  int side = 1;
  while (pixels / (side * side) > SAMPLED_PIXELS) ++side;
  return side;
}

gl::Defines::value_type listedTileDefine(const OitPlan& plan) {
  return {"LISTED_TILE", std::to_string(plan.listedTile())};
}

void coveredTilesRows(frame::PassDeclaration& d) {
  d.storage(SSBO_COVERED, kCoveredTiles, Access::Read);
  totalsRow(d, Access::Read);
  d.indirect(kOitTotals);
}

void dispatchCoveredTiles(const frame::PassContext& context) {
  context.dispatchIndirect(kOitTotals, offsetof(shader::OitTotals, dispatches[LIST_OF_TILES]));
}

OitPassPtr makeCoveredTilesPass(const OitPlan& plan) {
  return std::make_unique<CoveredTilesPass>(plan);
}

OitPassPtr makeCoveredSamplesPass(const OitPlan& plan) {
  return std::make_unique<CoveredSamplesPass>(plan);
}

}  // namespace macula::passes
