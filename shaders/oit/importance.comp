// Importance map and its sum. A thread walks a strip of pixels and adds to the totals once.
// FACTORS: also write each factor, for heat maps.
#include "shared/oit_constants.h"
layout(local_size_x = STRIP_GROUP) in;

#include "lib/importance.glsl"
#include "lib/oit.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D fragmentCount;
layout(rgba8_snorm, binding = IMG_2) uniform image2D frontNormal;
layout(r32ui, binding = IMG_0) writeonly uniform uimage2D importance;
#ifdef FACTORS
layout(rgba16f, binding = IMG_1) writeonly uniform image2D factors;
#endif
layout(std430, binding = SSBO_OIT_TOTALS) buffer Totals { OitTotals totals; };
layout(location = 0) uniform vec4 settings;  // rangeBias, periphery, noise, layerLimit
layout(location = 1) uniform uint noiseSeed;

vec3 toEyeAt(vec2 pixelCenter) {
  // Any depth on the ray will do.
  vec4 p = frame.inverseViewProjection * vec4(pixelCenter * frame.inverseSize * 2.0 - 1.0, 0.5, 1.0);
  return normalize(frame.eye.xyz - p.xyz / p.w);
}

void main() {
  ImportanceSettings s = ImportanceSettings(settings.x, settings.y, settings.z, settings.w);
  ivec2 first = ivec2(int(gl_GlobalInvocationID.x) * STRIP, int(gl_WorkGroupID.y));
  int end = min(first.x + STRIP, int(frame.size.x));
  uint sum = 0u;
  uint covered = 0u;
  uint countMax = 0u;
  for (ivec2 p = first; p.x < end; ++p.x) {
    float count = texelFetch(fragmentCount, p, 0).r;
    // The normal of the last frame stays until another is stored: a pixel whose only slot is its
    // tail's stores none, and would otherwise lose and regain its normal from frame to frame.
    vec4 normal = imageLoad(frontNormal, p);
    if (normal.w > 0.0 && (count == 0.0 || frame.historyValid == 0u)) {
      normal = vec4(0.0);
      imageStore(frontNormal, p, normal);
    }
    uint value = 0u;
    if (count > 0.0) {
      vec2 center = vec2(p) + 0.5;
      float depthFactor = depthComplexityFactor(count, s);
      float periphery = peripheryFactor(center, s);
      float fresnel = 1.0;
      if (normal.w > 0.0) fresnel = fresnelFactor(normal, toEyeAt(center));
      float total = max(0.0, periphery * depthFactor * fresnel + noiseTerm(p, noiseSeed, s));
      value = uint(total * float(IMPORTANCE_ONE) + 0.5);
      sum += value;
      ++covered;
      countMax = max(countMax, uint(count));
#ifdef FACTORS
      imageStore(factors, p, vec4(periphery, depthFactor, fresnel, total));
#endif
      imageStore(importance, p, uvec4(value));
    }
  }
  if (covered == 0u) return;
  uint old = atomicAdd(totals.importanceLow, sum);
  if (old + sum < old) atomicAdd(totals.importanceHigh, 1u);
  atomicAdd(totals.covered, covered);
  atomicMax(totals.countMax, countMax);
}
