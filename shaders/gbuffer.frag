// Opaque surfaces into the G-buffer: 20 bytes a sample with depth.
// MASK: alpha-tested. VEINS_KIND: number of the material's veins plus one.
#include "lib/frame.glsl"
#include "lib/material.glsl"

#ifndef VEINS_KIND
#define VEINS_KIND 0u
#endif

layout(location = 0) out vec2 outNormalOct;
layout(location = 1) out vec4 outBaseColor;
layout(location = 2) out vec4 outSurface;
layout(location = 3) out vec3 outEmissive;

void main() {
  SurfacePoint s = findSurface();
#ifdef MASK
  if (s.alpha == 0.0) discard;
#endif
  outNormalOct = encodeOctahedral(s.normal);
  outBaseColor = vec4(s.baseColor, s.metallic);
  SurfaceKind kind = SurfaceKind(s.unlit, VEINS_KIND, s.geometricNormal, false);
#ifdef NORMAL_MAP
  kind.mapped = true;
#endif
  outSurface = vec4(s.roughness, s.occlusion, packKind(kind));
  outEmissive = s.emissive;
}
