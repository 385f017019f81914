// Inputs and outputs of the networks of importance, once for C++ and GLSL.
#ifndef MACULA_SHARED_NETWORK_H
#define MACULA_SHARED_NETWORK_H

// Features of the thesis's network (Tsopouridis 2021, section 4.2).
#define THESIS_FEATURES 12

// Depth slices of Macula's own network: twice as many as the plain prediction uses by default, each
// divided into half as many parts, which costs memory but no time. Its features: seven of each
// slice, the pixel's number of fragments, and the opaque colour behind them.
#define LEARNED_SLICES 8
#define LEARNED_PARTS 2
#define LEARNED_FEATURES 60

// It corrects predicted errors (shaders/lib/predicted_error.glsl) at four places: before slices 0,
// 2, 4 and 6; and the variance of order inside each two slices. All as log2, at most this much up
// or down.
#define LEARNED_KNOTS 4
#define LEARNED_SLICES_A_KNOT 2
#define LEARNED_MOST 12.0

// Squared errors below 2^-20 are nothing on a display; a layer of optical depth 2^-8 cannot be
// seen.
#define LEARNED_LEAST_ERROR 9.5367431640625e-7
#define LEARNED_LEAST_DEPTH 0.00390625

// Steps of a premultiplied colour whose sum does not depend on order below 4,096.
#define FEATURE_COLOR_STEPS 4096.0

#endif
