// A fragment for the sample that the stencil test chooses.
#include "lib/oit.glsl"
#include "lib/transparent.glsl"

layout(location = 0) out uvec2 key;
layout(location = 1) out vec4 color;

void main() {
#ifdef HOLED
  // Before the stencil test, which is late here: what is not there takes no sample.
  if (!isThere()) discard;
#endif
  // One depth for all samples: interpolated to each, some would pass the opaque surface and some
  // not, and their stencils would no longer agree.
  gl_FragDepth = gl_FragCoord.z;
  key = fragmentKey(gl_FragCoord.z, fragmentId());
  color = min(shadeTransparent(), vec4(kMaxHalf));
}
