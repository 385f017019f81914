// Runs a few threads through every order of their memory accesses, under a memory model as weak as
// GLSL's, and checks each outcome. Threads are functions that access memory through the explorer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace macula::model {

/// The memory model (GLSL 4.60, 7.10 "Memory Qualifiers" and 8.17 "Shader Memory Control
/// Functions", of volatile variables): a store waits in its thread until it is committed, stores to
/// different places in any order; a load gives any value that its place has held since the thread's
/// last barrier, but never an older one than the thread has seen there; a barrier waits for the
/// thread's stores. Atomics act on memory at once and order nothing else.
///
/// Orders that lead to a state already seen are followed once: a state is memory, and of each
/// thread what it has read and what its stores and barriers still allow.
class Explorer {
 public:
  using Thread = std::function<void()>;
  /// What is wrong with memory once all threads have ended and all stores are committed; empty:
  /// nothing.
  using Check = std::function<std::string(const std::vector<std::uint32_t>& memory)>;

  struct Result {
    std::uint64_t states = 0;    ///< different ones
    std::uint64_t outcomes = 0;  ///< orders that were followed to their end
    std::uint64_t waits = 0;     ///< states in which a thread waited for a lock
    std::string fault;           ///< the first that was found; the search ends with it
  };

  /// Follows every order.
  /// @param memory its initial contents, a word a place
  static Result explore(const std::vector<std::uint32_t>& memory,
                        const std::vector<Thread>& threads, const Check& check);

  // For threads, while explore() runs them.
  /// Which one runs, from 0 on.
  [[nodiscard]] static std::size_t thread();
  [[nodiscard]] static std::uint32_t load(std::size_t place);
  static void store(std::size_t place, std::uint32_t value);
  /// Waits for this thread's stores; later loads give what memory holds now, or something newer.
  static void barrier();
  /// @returns the old value. A thread that would find a lock taken (1 where it stores 1) is not
  /// run: another try could change nothing.
  static std::uint32_t exchangeLock(std::size_t place, std::uint32_t value);
};

}  // namespace macula::model
