#ifndef MACULA_HALF_GLSL
#define MACULA_HALF_GLSL

/// The largest half float; more would be infinite, and zero times that NaN.
const float kMaxHalf = 65504.0;

#endif
