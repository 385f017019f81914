// What the networks of importance see and say, once for C++ and GLSL.
#ifndef MACULA_SHARED_NETWORK_H
#define MACULA_SHARED_NETWORK_H

// Features of the thesis's network (Tsopouridis 2021, section 4.2).
#define THESIS_FEATURES 12

// Depth slices that Macula's own network sees, and its features: six of each slice with a colour of
// three, the pixel's number of fragments, and the opaque colour behind them.
#define LEARNED_SLICES 4
#define LEARNED_FEATURES 32

// It says how many layers a pixel should keep at some prices of a slot: 2^-3, 2^-7, ... 2^-23, from
// what a visible layer of a dark pixel is worth to what no display shows. Layers at prices between
// them are on a straight line.
#define LEARNED_KNOTS 6
#define LEARNED_KNOT_HIGHEST -3.0
#define LEARNED_KNOT_STEP 4.0

// Fragments of a pixel crowd towards the eye, where they weigh most: a slice ends at this power of
// the way from the nearest to the farthest.
#define LEARNED_SLICE_POWER 0.65

// An error of 2^-20 on the display is nothing; a layer of optical depth 2^-8 cannot be seen.
#define LEARNED_LEAST_ERROR 9.5367431640625e-7
#define LEARNED_LEAST_DEPTH 0.00390625

// Steps of a premultiplied colour whose sum does not depend on order below 4,096.
#define FEATURE_COLOR_STEPS 4096.0

#endif
