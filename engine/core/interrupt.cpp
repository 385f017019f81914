#include "engine/core/interrupt.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <string_view>

namespace macula {
namespace {

std::atomic<bool> asked{false};
std::atomic<bool> onTerminal{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler must not wait for a lock");

/// Only what POSIX allows in a signal handler.
void note(int signal) {
  if (asked.exchange(true)) {
    std::signal(signal, SIG_DFL);
    ::raise(signal);  // delivered when this handler returns
    return;
  }
  if (!onTerminal) return;
  constexpr std::string_view kAnswer =
      "\nmacula: ending after this step; again to end at once, without what is unwritten\n";
  const int before = errno;
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, kAnswer.data(), kAnswer.size());
  errno = before;
}

}  // namespace

InterruptGuard::InterruptGuard() {
  asked = false;
  onTerminal = ::isatty(STDERR_FILENO) == 1;
  struct sigaction action {};
  action.sa_handler = note;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, &oldInterrupt_);
  sigaction(SIGTERM, &action, &oldTerminate_);
}

InterruptGuard::~InterruptGuard() {
  sigaction(SIGINT, &oldInterrupt_, nullptr);
  sigaction(SIGTERM, &oldTerminate_, nullptr);
  asked = false;
}

bool interruptAsked() {
  return asked.load(std::memory_order_relaxed);
}

void endIfInterrupted() {
  if (interruptAsked())
    throw Interrupted("interrupted before anything was finished; nothing was written");
}

}  // namespace macula
