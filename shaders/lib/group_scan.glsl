// Prefix sums over the threads of a work-group, in shared memory. Needs GROUP_THREADS. All threads of the
// group must call these functions together.

shared uvec4 groupValues[GROUP_THREADS];

/// All threads arrive, and see what the others have written to shared memory.
void meetGroup() {
  memoryBarrierShared();
  barrier();
}

/// Sum over this thread and those before it among every `width` threads (a power of two), as Hillis and
/// Steele (1986) find it.
uvec4 sumUpTo(uvec4 own, uint width) {
  uint i = gl_LocalInvocationIndex;
  meetGroup();  // what the last call left has been read
  groupValues[i] = own;
  meetGroup();
  for (uint away = 1u; away < width; away *= 2u) {
    uvec4 before = i % width >= away ? groupValues[i - away] : uvec4(0u);
    meetGroup();
    own += before;
    groupValues[i] = own;
    meetGroup();
  }
  return own;
}

/// After sumUpTo(): the sum over all of this thread's `width` threads.
uvec4 sumOfAll(uint width) { return groupValues[gl_LocalInvocationIndex / width * width + width - 1u]; }
