// Depth from the light; MASK materials are alpha-tested.
#ifdef MASK
#include "lib/scene.glsl"
layout(location = 0) in vec4 inUv;
layout(location = 1) in vec4 inColor;
layout(location = 2) flat in uvec3 inIds;
layout(binding = TEX_BASE_COLOR) uniform sampler2D baseColorTexture;
#endif

void main() {
#ifdef MASK
  MaterialData m = materials[inIds.x];
  float alpha = m.baseColor.a * inColor.a;
  if ((m.flags.x & MATERIAL_HAS_BASE_COLOR_TEXTURE) != 0u) {
    vec2 uv = (m.flags.y & (1u << TEX_BASE_COLOR)) != 0u ? inUv.zw : inUv.xy;
    alpha *= texture(baseColorTexture, uv).a;
  }
  if (alpha < m.surface.w) discard;
#endif
}
