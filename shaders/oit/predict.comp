// Predicts the number of a pixel's fragments: that of the last frame, reprojected by the depth of the
// pixel's nearest fragment then. Between pixels, the largest of the four around; beside a covered pixel
// at least one, so that an edge that moves by a pixel still finds a slot.
#include "shared/dispatch.h"
layout(local_size_x = FULLSCREEN_GROUP, local_size_y = FULLSCREEN_GROUP) in;

#include "lib/frame.glsl"
#define RANGES
#define STORE_ACCESS readonly
#define KEYS_ONLY
#include "lib/fragment_store.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D lastCount;
layout(binding = TEX_INPUT1) uniform usampler2D lastRange;
layout(binding = TEX_INPUT2) uniform usampler2D lastFill;
layout(binding = TEX_INPUT3) uniform sampler2D opaqueDepth;
layout(r32f, binding = IMG_0) writeonly uniform image2D predictedCount;

/// Shifts of less than this, in pixels, are taken for rounding.
const float kStill = 1.0 / 64.0;

float depthOfFront(ivec2 p) {
  if ((texelFetch(lastFill, p, 0).r & ~RANGE_TAIL) == 0u) return texelFetch(opaqueDepth, p, 0).r;
  return uintBitsToFloat(~keys[texelFetch(lastRange, p, 0).r].x);
}

float countAt(ivec2 p) {
  return texelFetch(lastCount, clamp(p, ivec2(0), ivec2(frame.size) - 1), 0).r;
}

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (p.x >= int(frame.size.x) || p.y >= int(frame.size.y)) return;
  vec2 center = vec2(p) + 0.5;
  vec4 clip = frame.reprojection * vec4(center * frame.inverseSize * 2.0 - 1.0, depthOfFront(p), 1.0);
  vec2 last = (clip.xy / clip.w * 0.5 + 0.5) * frame.size - 0.5;
  vec2 nearest = round(last);
  last = mix(last, nearest, lessThan(abs(last - nearest), vec2(kStill)));
  ivec2 low = ivec2(floor(last));
  ivec2 high = ivec2(ceil(last));
  float count = max(max(countAt(low), countAt(high)),
                    max(countAt(ivec2(low.x, high.y)), countAt(ivec2(high.x, low.y))));
  // Only the camera moves: where it has not, neither has an edge.
  bool still = ivec2(nearest) == p && last == nearest;
  for (int i = 0; i < 9 && count == 0.0 && !still; ++i) {
    count = min(countAt(ivec2(nearest) + ivec2(i % 3, i / 3) - 1), 1.0);
  }
  imageStore(predictedCount, p, vec4(count));
}
