// Weighted blended transparency (McGuire and Bavoil 2013): sums that do not depend on order.
#include "lib/oit.glsl"
#include "lib/transparent.glsl"

layout(location = 0) out vec4 weighted;
layout(location = 1) out vec4 coverage;  // a: optical depth, whose sum is the exact transmittance

/// McGuire and Bavoil 2013, Eq. 9: falls off with the cube of window depth, where 0 is near.
float depthWeight(float alpha) {
  float d = gl_FragCoord.z;  // depth is reversed here, so this is their 1 - d(z)
  return alpha * max(1e-2, 3e3 * d * d * d);
}

void main() {
#ifdef HOLED
  if (!isThere()) discard;
#endif
  vec4 c = shadeTransparent();
  float alpha = clamp(c.a, 0.0, 1.0);
  weighted = alpha > 0.0 ? vec4(c.rgb, alpha) * (depthWeight(alpha) / alpha) : vec4(0.0);
  coverage = vec4(0.0, 0.0, 0.0, opticalDepth(alpha));
}
