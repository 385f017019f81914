// Sums over the image that the transparency passes share. All integers: thread order changes none.
#ifndef MACULA_SHARED_OIT_TOTALS_H
#define MACULA_SHARED_OIT_TOTALS_H
#include "shared/cpp_glsl.h"

// The search for the Lagrange multiplier (shaders/lib/multiplier.glsl): rounds, and candidates
// (four to a vector) in each. Two rounds of 16 find it within 44 octaves / 17^2, some 10 %.
#define MULTIPLIER_ROUNDS 2
#define MULTIPLIER_CANDIDATES 16
#define MULTIPLIER_VECTORS_A_ROUND 4
#define MULTIPLIER_VECTORS_IN_ALL 8

// Lists of what transparent fragments cover.
#define OIT_LISTS 3
#define LIST_OF_TILES 0    // all tiles
#define LIST_OF_SAMPLES 1  // a sample of the pixels, for the search for the multiplier
#define LIST_OF_DEEP 2  // tiles of oit/resolve.comp with a pixel of more than it sorts in registers

// Bins of the histogram of counts; a deeper pixel counts as this deep.
#define COUNT_BINS 1024

MACULA_SHARED_BEGIN

struct OitTotals {
  uint importanceLow;  // sum of importance, 64 bits in two words
  uint importanceHigh;
  uint covered;       // pixels with a transparent fragment
  uint starved;       // of these, those whose share of the budget rounds to no layer
  uint cursor;        // slots allocated; exact methods may ask for more than exist
  uint countMax;      // largest n of this frame
  uint lockFailures;  // fragments given up at the bound of a spin lock
  uint oneLayer;      // k of kb-plus
  uvec4 extent;       // x: all fragments; y: bits of the nearest reversed depth; z: complement of
                      // those of the farthest; w: pixels with a fragment; for networks
  uvec4 demand;       // slots, of all pixels: the least of each, their demand at a high multiplier,
                      // at a low one, a slot for every fragment
  uvec4 cut;          // the budget M among these amounts: x: how many of them are within it; y, z:
                      // (M - A) / (B - A) of oit/share.comp in steps of 2^-64, low and high word
  uvec4 dispatches[OIT_LISTS];                     // of each list: shaders/lib/list_dispatch.glsl
  uvec4 sampledDemand[MULTIPLIER_VECTORS_IN_ALL];  // of the sample, at each candidate
};

/// What became of a frame's fragments, summed after it for the report; no pass reads it.
struct OitStatistics {
  uint generated;     // fragments that pass opaque depth
  uint stored;        // kept one by one
  uint merged;        // in a tail
  uint slots;         // of all covered pixels
  uint covered;       // pixels with a transparent fragment
  uint countMax;      // largest n
  uint kMax;          // over covered pixels
  uint kMinInverted;  // 0xFFFFFFFF - least k over covered pixels, so that 0 is the start
  uint tails;         // pixels with a tail
  uint padding0;
  uint padding1;
  uint padding2;
};

MACULA_SHARED_END
#endif
