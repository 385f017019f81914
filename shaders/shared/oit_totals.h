// Sums over the image that the transparency passes share. All integers: thread order changes none.
#ifndef MACULA_SHARED_OIT_TOTALS_H
#define MACULA_SHARED_OIT_TOTALS_H
#include "shared/cpp_glsl.h"
MACULA_SHARED_BEGIN

struct OitTotals {
  uint importanceLow;   // sum of importance, 64 bits in two words
  uint importanceHigh;
  uint covered;         // pixels with a transparent fragment
  uint starved;         // of these, those whose share of the budget rounds to no layer
  uint generated;       // fragments counted
  uint stored;          // sum of min(n, k)
  uint cursor;          // slots handed out
  uint kMax;            // over covered pixels
  uint kMinInverted;    // 0xFFFFFFFF - least k over covered pixels, so that 0 is the start
  uint kSum;
  uint countMax;        // largest n of this frame
  uint lockFailures;    // fragments given up at the bound of a spin lock
  uint refused;         // slots asked for beyond the pool (exact methods): the frame is inexact
  uint padding0;
  uint padding1;
  uint padding2;
};

MACULA_SHARED_END
#endif
