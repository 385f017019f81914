// Copies opaque depth to every sample of a pixel.
#include "shared/bindings.h"

layout(binding = TEX_INPUT0) uniform sampler2D opaqueDepth;

void main() { gl_FragDepth = texelFetch(opaqueDepth, ivec2(gl_FragCoord.xy), 0).r; }
