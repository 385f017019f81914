// One layer of depth peeling (Everitt 2001): of the fragments behind the last layer's (depth, id) and in
// front of the opaque surface, STAGE_DEPTH: the nearest depth, by the depth test; STAGE_IDS: the least id
// at that depth; STAGE_COLOR: the colour of the fragment with both.
#ifndef STAGE_DEPTH
layout(early_fragment_tests) in;  // the depth test for equality comes first
#endif

#include "lib/oit.glsl"
#include "lib/material.glsl"
#ifdef STAGE_COLOR
#include "lib/transparent.glsl"
layout(location = 0) out vec4 color;
#endif

#ifndef STAGE_COLOR
layout(binding = TEX_INPUT0) uniform sampler2D opaqueDepth;
layout(rg32ui, binding = IMG_0) readonly uniform uimage2D lastKey;
#endif
#ifdef STAGE_IDS
layout(r32ui, binding = IMG_1) uniform uimage2D ids;
#elif defined(STAGE_COLOR)
layout(r32ui, binding = IMG_1) readonly uniform uimage2D ids;
#endif

void main() {
#ifdef HOLED
  if (!isThere()) discard;
#endif
  ivec2 p = ivec2(gl_FragCoord.xy);
#ifdef STAGE_COLOR
  vec4 shaded = shadeTransparent();
  if (imageLoad(ids, p).r != fragmentId()) discard;
  color = shaded;
#else
  uvec2 key = fragmentKey(gl_FragCoord.z, fragmentId());
  bool behindLast = isNearer(imageLoad(lastKey, p).rg, key);
  if (!behindLast || gl_FragCoord.z < texelFetch(opaqueDepth, p, 0).r) discard;
#ifdef STAGE_IDS
  imageAtomicMin(ids, p, fragmentId());
#endif
#endif
}
