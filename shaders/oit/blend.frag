// Transparent fragments in the order in which they are drawn.
#include "lib/transparent.glsl"

layout(location = 0) out vec4 color;

void main() {
#ifdef HOLED
  if (!isThere()) discard;
#endif
  color = shadeTransparent();
}
