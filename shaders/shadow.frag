// Depth from the light; MASK materials are alpha-tested.
#ifdef MASK
#include "lib/material.glsl"
#endif

void main() {
#ifdef MASK
  if (findBaseColor().a < material.surface.w) discard;
#endif
}
