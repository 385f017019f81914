// A known amount of arithmetic for the time-source check.
layout(local_size_x = 64) in;
layout(location = 0) uniform int iterations;
layout(std430, binding = 0) buffer Sink { uint sink[]; };

void main() {
  uint x = gl_GlobalInvocationID.x;
  for (int i = 0; i < iterations; ++i) x = x * 747796405u + 2891336453u;
  sink[gl_GlobalInvocationID.x] = x;
}
