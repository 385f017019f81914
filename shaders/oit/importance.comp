// Importance map and its sum.
// FACTORS: also write each factor, for heat maps.
#include "lib/tile.glsl"

#include "lib/importance.glsl"
#include "lib/oit.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D fragmentCount;
layout(rgba8_snorm, binding = IMG_2) uniform image2D frontNormal;
layout(r32ui, binding = IMG_0) writeonly uniform uimage2D importance;
#ifdef FACTORS
layout(rgba16f, binding = IMG_1) writeonly uniform image2D factors;
#endif
layout(std430, binding = SSBO_OIT_TOTALS) buffer Totals { OitTotals totals; };
#include "lib/importance_sum.glsl"
layout(location = 0) uniform vec4 settings;  // rangeBias, periphery, noise, layerLimit
layout(location = 1) uniform uint noiseSeed;

vec3 toEyeAt(vec2 pixelCenter, vec3 eye, mat4 inverseViewProjection, vec2 inverseSize) {
  // Any depth on the ray will do.
  vec4 p = inverseViewProjection * vec4(pixelCenter * inverseSize * 2.0 - 1.0, 0.5, 1.0);
  return normalize(eye - p.xyz / p.w);
}

void main() {
  ImportanceSettings s = ImportanceSettings(settings.x, settings.y, settings.z, settings.w);
  // Read once: see Gaze.
  Gaze gaze = gazeOfFrame();
  vec3 eye = frame.eye.xyz;
  mat4 inverseViewProjection = frame.inverseViewProjection;
  vec2 inverseSize = frame.inverseSize;
  uint hashedSeed = hashPcg(noiseSeed);
  bool historyValid = frame.historyValid != 0u;
  uint sum = 0u;
  uint covered = 0u;
  uint countMax = 0u;
  ivec2 p = firstPlace();
  int places = placesInside(p, ivec2(frame.size));
  for (int i = 0; i < places; ++i, p += kPlaceStep) {
    float count = texelFetch(fragmentCount, p, 0).r;
    // The normal of the last frame stays until another is stored: a pixel whose only slot is its
    // tail's stores none, and would otherwise lose and regain its normal from frame to frame.
    vec4 normal = imageLoad(frontNormal, p);
    if (normal.w > 0.0 && (count == 0.0 || !historyValid)) {
      normal = vec4(0.0);
      imageStore(frontNormal, p, normal);
    }
    uint value = 0u;
    if (count > 0.0) {
      vec2 center = vec2(p) + 0.5;
      float depthFactor = depthComplexityFactor(count, s);
      float periphery = peripheryFactor(center, gaze, s.periphery);
      float fresnel = 1.0;
      if (normal.w > 0.0) {
        fresnel = fresnelFactor(normal, toEyeAt(center, eye, inverseViewProjection, inverseSize));
      }
      float total = max(0.0, periphery * depthFactor * fresnel + noiseTerm(p, hashedSeed, s));
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
  addImportance(sum, covered, countMax);
}
