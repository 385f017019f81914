// One invocation at a time in a pixel: EXCLUSIVELY(p, wanted, action), in main() and outside of all
// branches. Whatever `action` reads is what the invocation before it has written; resources that it
// reads or writes must be `SHARED_MEMORY`.
// SYNC_INTERLOCK: by the rasteriser (ARB_fragment_shader_interlock), in no particular order: what is
// stored does not depend on it. SYNC_SPINLOCK: by a lock a pixel. SYNC_ORDERED: a pixel's invocations
// follow each other anyway. SYNC_NONE: hazards on purpose.
// LOCK_WAITED: a statement for each try that failed; by default none.

#if defined(SYNC_INTERLOCK) || defined(SYNC_SPINLOCK)
// Volatile, which implies coherent: nothing that was loaded before the section may be used in it.
#define SHARED_MEMORY volatile
#else
#define SHARED_MEMORY
#endif

#if defined(SYNC_INTERLOCK)
// Its begin and end order memory accesses themselves.
#define EXCLUSIVELY(p, wanted, action) \
  beginInvocationInterlockARB();       \
  if (wanted) action;                  \
  endInvocationInterlockARB();
#elif defined(SYNC_SPINLOCK)
#ifndef LOCK_WAITED
#define LOCK_WAITED
#endif
#ifndef LOCK_ACQUIRE
#define LOCK_ACQUIRE memoryBarrier();
#endif
#ifndef LOCK_RELEASE
#define LOCK_RELEASE memoryBarrier();
#endif
// Several tries in an iteration, because llvmpipe ends loops after 65,535 of them: there the holder of
// the lock is a thread that the system may suspend for many milliseconds.
#define TRIED_ONCE(p) (imageAtomicExchange(fragmentLock, p, 1u) == 0u)
#define TRIED_4_TIMES(p) (TRIED_ONCE(p) || TRIED_ONCE(p) || TRIED_ONCE(p) || TRIED_ONCE(p))
#define TRIED_16_TIMES(p) \
  (TRIED_4_TIMES(p) || TRIED_4_TIMES(p) || TRIED_4_TIMES(p) || TRIED_4_TIMES(p))
// The section stands inside the loop: where invocations run in lockstep, one that holds the lock must
// not wait for one that does not. `wanted` is false in helper invocations, which write nothing.
#define EXCLUSIVELY(p, wanted, action)                      \
  bool done = !(wanted);                                    \
  for (int i = 0; i < LOCK_BOUND && !done; ++i) {           \
    if (!TRIED_ONCE(p)) {                                   \
      LOCK_WAITED                                           \
      if (!TRIED_16_TIMES(p)) continue;                     \
    }                                                       \
    LOCK_ACQUIRE                                            \
    action;                                                 \
    LOCK_RELEASE                                            \
    imageAtomicExchange(fragmentLock, p, 0u);               \
    done = true;                                            \
  }                                                         \
  if (!done) atomicAdd(totals.lockFailures, 1u);
#else
#define EXCLUSIVELY(p, wanted, action) \
  if (wanted) action;
#endif
