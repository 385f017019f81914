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
  uint cursor;          // sum of k: slots handed out; exact methods may ask for more than exist
  uint kMax;            // over covered pixels
  uint kMinInverted;    // 0xFFFFFFFF - least k over covered pixels, so that 0 is the start
  uint countMax;        // largest n of this frame
  uint lockFailures;    // fragments given up at the bound of a spin lock
  uint padding0;
  uint padding1;
  uint padding2;
  uint padding3;
  uint padding4;
};

MACULA_SHARED_END
#endif
