// Self-test of stencil routing: a layer that writes its number.
layout(location = 0) uniform uint number;
layout(location = 0) out uint layer;

void main() {
  gl_FragDepth = gl_FragCoord.z;
  layer = number;
}
