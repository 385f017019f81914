// Lists of the tiles, and of those pixels of a sample, that transparent fragments cover. A pass
// whose work is expensive visits only these, by an indirect dispatch: where branches are emulated,
// an empty pixel would cost as much as a full one.
#pragma once

#include "passes/oit/oit_pass.h"

namespace macula::passes {

/// Places of the sampled pixels that transparent fragments cover.
inline constexpr frame::Resource kCoveredSamples{"covered samples", 0, frame::SizeRule::Declared,
                                                 frame::ByteClass::Overhead,
                                                 frame::Initial::Undefined};

/// Pixels a side of a cell of which one pixel is sampled, for an image of this size.
[[nodiscard]] int sampledCellSide(glm::ivec2 size);

/// LISTED_TILE of shaders/lib/covered.glsl.
[[nodiscard]] gl::Defines::value_type listedTileDefine(const OitPlan& plan);

/// Rows of a pass that visits the covered tiles.
void coveredTilesRows(frame::PassDeclaration& d);
/// Dispatches a thread for each covered tile.
void dispatchCoveredTiles(const frame::PassContext& context);

}  // namespace macula::passes
