// Self-test of stencil routing: copies the first two samples of a few pixels.
#include "shared/bindings.h"
layout(local_size_x = 4, local_size_y = 4) in;

layout(binding = TEX_INPUT0) uniform usampler2DMS layers;
layout(rg32ui, binding = IMG_0) writeonly uniform uimage2D result;

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  uint first = texelFetch(layers, p, 0).r;
  uint second = texelFetch(layers, p, 1).r;
  imageStore(result, p, uvec4(first, second, 0u, 0u));
}
