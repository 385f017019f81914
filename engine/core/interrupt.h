// Ctrl-C: what is finished is written, then the program ends.
#pragma once

#include <csignal>
#include <stdexcept>

namespace macula {

/// What a shell says of a program that Ctrl-C ended: 128 + SIGINT.
inline constexpr int kInterruptedStatus = 130;

/// A run was ended early by SIGINT or SIGTERM: what() is one line that says what was written.
class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// While it lives, the first SIGINT or SIGTERM only sets a flag, which loops look at between two
/// steps; the next one of either ends the program at once. One at a time.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

 private:
  struct sigaction oldInterrupt_ {};
  struct sigaction oldTerminate_ {};
};

/// Whether a guard that lives has seen a signal.
[[nodiscard]] bool interruptAsked();

/// Ends a run that has nothing to write yet. @throws Interrupted where a signal came
void endIfInterrupted();

}  // namespace macula
