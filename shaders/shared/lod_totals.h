// Counts of the level of detail, and the dispatches that follow from them.
#ifndef MACULA_SHARED_LOD_TOTALS_H
#define MACULA_SHARED_LOD_TOTALS_H
#include "shared/cpp_glsl.h"

// Texels of the resized image a side of a tile: cells of every rate divide it, and a tile of the
// finest rate fills four work-groups.
#define LOD_TILE 16
#define LOD_TILE_SHIFT 4
// Rates: a sample every 1, 2, 4 or 8 texels.
#define LOD_RATES 4

MACULA_SHARED_BEGIN

struct LodTotals {
  // Of the list of each rate, then of the list of holes: work-groups in x, y and z, as
  // glDispatchComputeIndirect takes them; w: entries of the list.
  uvec4 dispatches[LOD_RATES + 1];
  uint shaded;  // samples on the tiles' grids
  uint padding0;
  uint padding1;
  uint padding2;
};

MACULA_SHARED_END
#endif
