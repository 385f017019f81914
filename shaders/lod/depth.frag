// Opaque depth of a texel of the reduced-rate image: that of the pixel at its middle. No colour yet.
#include "lib/raster.glsl"
#include "shared/bindings.h"

layout(binding = TEX_INPUT0) uniform sampler2D opaqueDepth;
layout(location = 0) uniform vec2 pitch;  // pixels a texel
layout(location = 0) out vec4 color;

void main() {
  ivec2 size = textureSize(opaqueDepth, 0);
  gl_FragDepth = texelFetch(opaqueDepth, pixelAt(ivec2(gl_FragCoord.xy), pitch, size), 0).r;
  color = vec4(0.0);
}
