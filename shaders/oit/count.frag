// Counts fragments by additive blending: fixed function, no atomics.
layout(location = 0) out float count;

void main() { count = 1.0; }
