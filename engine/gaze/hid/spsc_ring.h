// A ring between one writing and one reading thread, without locks and of fixed size.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <type_traits>

namespace macula::gaze::hid {

/// The writer never waits: where the ring is full, it is told so and drops the new element.
/// @tparam Capacity a power of two; all of it can be used
template <typename T, std::size_t Capacity>
class SpscRing {
  static_assert(Capacity > 0 && (Capacity & (Capacity - 1)) == 0);
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  /// For the writing thread. @return false where the ring was full
  [[nodiscard]] bool push(const T& element) {
    const std::size_t end = end_.load(std::memory_order_relaxed);
    // Acquire: the reader has copied an element out before its place is written again.
    if (end - begin_.load(std::memory_order_acquire) == Capacity) return false;
    elements_[end % Capacity] = element;
    end_.store(end + 1, std::memory_order_release);
    return true;
  }

  /// For the reading thread: gives every element that is there to `take`, the oldest first.
  /// @return how many
  template <typename Take>
  std::size_t drain(Take&& take) {
    const std::size_t begin = begin_.load(std::memory_order_relaxed);
    const std::size_t end = end_.load(std::memory_order_acquire);
    for (std::size_t i = begin; i != end; ++i) take(elements_[i % Capacity]);
    begin_.store(end, std::memory_order_release);
    return end - begin;
  }

 private:
  static constexpr std::size_t kCacheLine = 64;  ///< keeps the two counters from sharing one

  alignas(kCacheLine) std::atomic<std::size_t> begin_{0};
  alignas(kCacheLine) std::atomic<std::size_t> end_{0};
  alignas(kCacheLine) std::array<T, Capacity> elements_{};
};

}  // namespace macula::gaze::hid
