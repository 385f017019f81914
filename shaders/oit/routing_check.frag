// A layer that knows its number.
layout(location = 0) uniform uint number;
layout(location = 0) out uint layer;

void main() {
  gl_FragDepth = gl_FragCoord.z;
  layer = number;
}
