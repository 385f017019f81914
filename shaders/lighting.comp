// Deferred lighting of the opaque surfaces, and the background where there are none.
// LIT: at least one material of the scene is lit. SHADOWS, ENVIRONMENT: see lib/lighting.glsl.
#include "shared/dispatch.h"
layout(local_size_x = FULLSCREEN_GROUP, local_size_y = FULLSCREEN_GROUP) in;

#include "lib/frame.glsl"
#include "lib/lighting.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D depthTexture;
layout(binding = TEX_INPUT1) uniform sampler2D normalTexture;
layout(binding = TEX_INPUT2) uniform sampler2D baseColorTexture;
layout(binding = TEX_INPUT3) uniform sampler2D surfaceTexture;
layout(binding = TEX_INPUT4) uniform sampler2D emissiveTexture;
layout(rgba16f, binding = IMG_0) writeonly uniform image2D hdrColor;

vec3 worldAt(vec2 uv, float depth) {
  vec4 p = frame.inverseViewProjection * vec4(uv * 2.0 - 1.0, depth, 1.0);
  return p.xyz / p.w;
}

vec3 backgroundAt(vec2 uv) {
#ifdef ENVIRONMENT
  // Half way between the planes: on the far plane the inverse of reversed depth is ill-conditioned.
  return environmentRadiance(normalize(worldAt(uv, 0.5) - frame.eye.xyz), 0.0);
#else
  return frame.background.rgb;
#endif
}

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (p.x >= int(frame.size.x) || p.y >= int(frame.size.y)) return;
  vec2 uv = (vec2(p) + 0.5) * frame.size.zw;
  float depth = texelFetch(depthTexture, p, 0).r;
  if (depth == 0.0) {
    imageStore(hdrColor, p, vec4(backgroundAt(uv), 1.0));
    return;
  }
  vec4 baseColor = texelFetch(baseColorTexture, p, 0);
  vec4 surface = texelFetch(surfaceTexture, p, 0);
  vec3 radiance = texelFetch(emissiveTexture, p, 0).rgb;
  if (surface.z > 0.5) {
    radiance += baseColor.rgb;  // unlit
  }
#ifdef LIT
  else {
    SurfacePoint s;
    s.position = worldAt(uv, depth);
    s.normal = decodeOctahedral(texelFetch(normalTexture, p, 0).rg);
    s.baseColor = baseColor.rgb;
    s.alpha = 1.0;
    s.metallic = baseColor.a;
    s.roughness = surface.x;
    s.occlusion = surface.y;
    s.emissive = vec3(0.0);
    s.unlit = false;
    Radiance sum = lightSurface(s, frame.eye.xyz);
    radiance += sum.diffuse + sum.specular;
  }
#endif
  imageStore(hdrColor, p, vec4(radiance, 1.0));
}
