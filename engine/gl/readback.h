// Small buffer ranges that the CPU reads some frames after the GPU wrote them, without a stall.
#pragma once

#include <cstddef>
#include <cstring>
#include <memory>
#include <string_view>
#include <type_traits>
#include <vector>

#include "engine/gl/objects.h"

namespace macula::gl {

/// A ring of slots in one persistently mapped buffer. A slot is filled by copies on the GPU, and
/// read once the GPU has reached the fence behind them.
class Readback {
 public:
  /// @param bytes of a slot, > 0 · @param slots > 0
  /// @throws InputError where the GPU has no memory for it
  Readback(std::string_view label, std::size_t bytes, std::size_t slots);

  /// Before copies of what shaders and commands so far leave behind: barriers, and a flush.
  void begin();
  /// Copies bytes of a buffer to byte `at` of a slot.
  void copy(std::size_t slot, GLuint buffer, std::size_t offset, std::size_t bytes, std::size_t at);
  /// Ends a slot's copies.
  void fence(std::size_t slot);
  /// Whether what was copied before the slot's last fence is there; never waits.
  [[nodiscard]] bool ready(std::size_t slot);
  /// Waits until it is.
  void wait(std::size_t slot);
  /// The bytes from `at` of a slot that is ready.
  template <typename T>
  [[nodiscard]] T read(std::size_t slot, std::size_t at) const {
    static_assert(std::is_trivially_copyable_v<T>);
    T value;
    std::memcpy(&value, mapped_ + slot * bytes_ + at, sizeof(T));
    return value;
  }

 private:
  struct DeleteSync {
    void operator()(GLsync fence) const { glDeleteSync(fence); }
  };
  using Fence = std::unique_ptr<std::remove_pointer_t<GLsync>, DeleteSync>;

  Object<BufferTraits> buffer_;
  std::size_t bytes_;
  const std::byte* mapped_ = nullptr;
  std::vector<Fence> fences_;  ///< by slot; none: ready
};

}  // namespace macula::gl
