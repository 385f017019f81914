// What errors of predictions are measured in.

/// About what a display shows of a radiance: gamma 2 in place of sRGB.
vec3 shown(vec3 radiance) { return sqrt(clamp(radiance, 0.0, 1.0)); }
