#include "passes/oit/covered_tiles.h"

#include <cstddef>

#include "shared/bindings.h"
#include "shared/oit_totals.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

gl::Defines::value_type listedTileDefine(const OitPlan& plan) {
  return {"LISTED_TILE", std::to_string(plan.listedTile())};
}

void declareCoveredTiles(frame::PassDeclaration& d) {
  d.reads(Resource::CoveredTiles, Use::Storage);
  d.reads(Resource::OitTotals, Use::Indirect);
}

void dispatchCoveredTiles(const frame::PassContext& context) {
  context.bindStorage(SSBO_COVERED_TILES, Resource::CoveredTiles);
  context.bindStorage(SSBO_OIT_TOTALS, Resource::OitTotals);
  context.dispatchIndirect(Resource::OitTotals, offsetof(shader::OitTotals, dispatches));
}

}  // namespace macula::passes
