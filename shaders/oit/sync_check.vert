// Self-test of per-pixel ordering: a triangle that covers everything, many times.
layout(location = 0) flat out uint triangle;

void main() {
  int corner = gl_VertexID % 3;
  triangle = uint(gl_VertexID / 3);
  gl_Position = vec4(corner == 1 ? 3.0 : -1.0, corner == 2 ? 3.0 : -1.0, 0.5, 1.0);
}
