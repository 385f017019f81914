// Constants of the transparency passes, once for C++ and GLSL.
#ifndef MACULA_SHARED_OIT_CONSTANTS_H
#define MACULA_SHARED_OIT_CONSTANTS_H

// One unit of importance in fixed point. 16 bits: a factor's float error is smaller than one step,
// and a sum over 2^28 pixels fits 64 bits.
#define IMPORTANCE_ONE 65536u

// Times that a spin lock is waited for, with some tries each (lib/pixel_lock.glsl). A pixel's
// contenders are the fragments in flight over it, some thousands at the most; each holds the lock
// for one insertion.
#define LOCK_BOUND 32768

// Fragments of one pixel that the resolve sorts in registers: so many runs of so many, one to a
// component of a vector, are a block. Deeper pixels take a dispatch of their own, with an array of
// numbers, one block to a component again; and still deeper ones are sorted in place.
#define SORT_RUNS 4u
#define SORT_RUN 8u
#define SORT_BLOCK (SORT_RUNS * SORT_RUN)
#define SORT_LARGE 128u

// Slots of one pixel; more would only be unused.
#define MAX_PIXEL_LAYERS 65535u

// Fixed point of depth slices: steps in one unit of optical depth, and where the count of fragments
// stands above it, with room for 2^10 fragments and an optical depth of 2^12 a slice.
#define SLICE_STEPS 1024.0
#define SLICE_COUNT_SHIFT 22
// Where how often either ran over stands above the sums of colour (shaders/lib/slices.glsl). A
// fragment adds less than 2^15 + 1 to such a sum and 2^13 + 1 to optical depth: 8,191 fragments a
// slice fit.
#define SLICE_CARRY_SHIFT 28
// A transmittance of 1/256: less cannot be told from nothing in 8 bits.
#define SLICE_MAX_DEPTH 8.0
// Radiance beyond white, so that highlights count but do not drown the rest.
#define SLICE_MAX_COLOR 4.0
#define MAX_SLICES 16
// Even parts into which the prediction divides a slice, its fragments spread over them.
#define SLICE_PARTS 4

// The Lagrange multiplier is searched for between 2^-40 and 2^4: from what one fragment among
// thousands can change to more than the utility of a whole pixel.
#define MULTIPLIER_LOWEST -40.0
#define MULTIPLIER_HIGHEST 4.0
// Octaves by which the high and the low multiplier stand off the one found in a sample of the
// pixels: its sums are about one per cent off.
#define MULTIPLIER_MARGIN 0.05
// Pixels that are enough for that sample.
#define SAMPLED_PIXELS 65536
// Threads of the search: each sums some pixels before it adds to the totals.
#define MULTIPLIER_THREADS 2048

// The depth key of an empty slot: no depth has it.
#define NO_KEY 0xFFFFFFFFu

// Set in a pixel's number of slots where a tail stands behind them.
#define RANGE_TAIL 0x80000000u
// Set in a pixel's fill where all slots are in use; the other bits are then the farthest depth in
// them, of which 30 bits tell all floats of 0..1 apart.
#define FILL_FULL 0x40000000u

// Optical depth of a layer at the most, in halvings: a transmittance of 1 / 65,536 is less than a
// half float of radiance resolves.
#define MAX_OPTICAL_DEPTH 16.0

// Steps of a tail's sums in one unit. With 2^14, floats hold sums below 2^10 exactly.
#define TAIL_STEPS 16384.0

#endif
