// Opaque surfaces into the G-buffer: 20 bytes a sample with depth.
// MASK: alpha-tested.
#include "lib/frame.glsl"
#include "lib/material.glsl"

layout(location = 0) out vec2 outNormalOct;
layout(location = 1) out vec4 outBaseColor;
layout(location = 2) out vec4 outSurface;
layout(location = 3) out vec3 outEmissive;

void main() {
  MaterialData m = materials[inIds.x];
  SurfacePoint s = surfaceAt(m);
#ifdef MASK
  if (s.alpha == 0.0) discard;
#endif
  outNormalOct = encodeOctahedral(s.normal);
  outBaseColor = vec4(s.baseColor, s.metallic);
  outSurface = vec4(s.roughness, s.occlusion, s.unlit ? 1.0 : 0.0, float(m.flags.z) / 255.0);
  outEmissive = s.emissive;
}
