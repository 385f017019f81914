#include "passes/oit/covered_lists.h"

#include <cstddef>

#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

frame::Resource listResource(int list) {
  return list == LIST_OF_TILES ? Resource::CoveredTiles : Resource::CoveredSamples;
}

gl::Defines::value_type listedTileDefine(const OitPlan& plan) {
  return {"LISTED_TILE", std::to_string(plan.listedTile())};
}

void declareCoveredTiles(frame::PassDeclaration& d) {
  d.reads(Resource::CoveredTiles, Use::Storage);
  d.reads(Resource::OitTotals, Use::Indirect);
}

void dispatchCoveredTiles(const frame::PassContext& context) {
  context.bindStorage(SSBO_COVERED, Resource::CoveredTiles);
  context.bindStorage(SSBO_OIT_TOTALS, Resource::OitTotals);
  context.dispatchIndirect(Resource::OitTotals,
                           offsetof(shader::OitTotals, dispatches[LIST_OF_TILES]));
}

}  // namespace macula::passes
