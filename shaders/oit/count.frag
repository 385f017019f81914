// Counts fragments by additive blending: fixed function, no atomics.
// RANGE: also the nearest and the farthest depth, by maximum blending.
// HOLED: fragments whose alpha makes a hole are not counted.
#include "lib/material.glsl"

layout(location = 0) out float count;
#ifdef RANGE
layout(location = 1) out vec2 range;  // reversed depth of the nearest, minus that of the farthest
#endif

void main() {
#ifdef HOLED
  if (!isThere()) discard;
#endif
  count = 1.0;
#ifdef RANGE
  range = vec2(gl_FragCoord.z, -gl_FragCoord.z);
#endif
}
