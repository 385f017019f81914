// Constants of the transparency passes, once for C++ and GLSL.
#ifndef MACULA_SHARED_OIT_CONSTANTS_H
#define MACULA_SHARED_OIT_CONSTANTS_H

// One unit of importance in fixed point. 16 bits: a factor's float error is smaller than one step,
// and a sum over 2^28 pixels fits 64 bits.
#define IMPORTANCE_ONE 65536u

// Pixels that one thread sums before it touches a shared counter. Fewer, and atomics dominate;
// more, and a GPU has too few threads to fill it.
#define STRIP 32

// Threads of a work-group of the strip passes.
#define STRIP_GROUP 64

// Tries for a spin lock. A pixel's contenders are the fragments in flight over it, some thousands
// at the most; each holds the lock for one insertion.
#define LOCK_BOUND 32768

// Fragments of one pixel that the resolve sorts in registers or local memory; deeper pixels are
// sorted in place, which needs no array.
#define SORT_SMALL 16
#define SORT_LARGE 128

// Slots of one pixel; more would only be unused.
#define MAX_PIXEL_LAYERS 65535u

// The depth key of an empty slot: no depth has it.
#define NO_KEY 0xFFFFFFFFu

// Set in a pixel's number of slots where a tail stands behind them.
#define RANGE_TAIL 0x80000000u

// Optical depth of a layer at the most, in halvings: 1 / 65,536 passes, less than a half float of
// radiance resolves.
#define MAX_OPTICAL_DEPTH 16.0

// Steps of a tail's sums in one unit. With 2^14, floats hold sums below 2^10 exactly.
#define TAIL_STEPS 16384.0

#endif
