// Stencil-routed k-buffer (Bavoil and Myers 2008): the stencil test selects the sample that stores the
// fragment.
#include "lib/oit.glsl"
#include "lib/transparent.glsl"

layout(location = 0) out uvec2 key;
layout(location = 1) out vec4 color;

void main() {
#ifdef HOLED
  // Before the stencil test, which is late here: a hole must not use up a sample.
  if (!isThere()) discard;
#endif
  // One depth for all samples. Interpolated depths could pass the opaque surface at some samples and
  // not at others, and their stencils would no longer agree.
  gl_FragDepth = gl_FragCoord.z;
  key = fragmentKey(gl_FragCoord.z, fragmentId());
  color = min(shadeTransparent(), vec4(kMaxHalf));
}
