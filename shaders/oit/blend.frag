// Transparent fragments for blending in draw order.
#include "lib/half.glsl"
#include "lib/transparent.glsl"

layout(location = 0) out vec4 color;

void main() {
#ifdef HOLED
  if (!isThere()) discard;
#endif
  color = min(shadeTransparent(), vec4(kMaxHalf));
}
