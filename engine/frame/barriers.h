// Memory barriers that follow from binding tables. No GL calls.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/frame/binding.h"
#include "engine/gl/gl.h"

namespace macula::frame {

/// Where a resource lies: bytes [begin, end) of a block. Ranges of one block may overlap, where
/// resources share memory.
struct MemoryRange {
  std::uint32_t block = 0;
  std::size_t begin = 0;
  std::size_t end = 0;

  [[nodiscard]] bool overlaps(const MemoryRange& o) const {
    return block == o.block && begin < o.end && o.begin < end;
  }
};

/// Follows the accesses of all frames and says which bits of glMemoryBarrier an access needs.
///
/// OpenGL 4.5, section 7.12.2: reads and writes by image variables and shader storage are not
/// ordered with other accesses; all others (texture fetches, render targets, GL commands) are
/// ordered among themselves. A barrier bit names the *later* access: what the bit covers reflects
/// what shaders wrote before, and image and storage writes wait until all earlier accesses are
/// complete. So a bit is needed between two accesses of the same memory where one writes and
/// - the earlier is an image or storage write (read or write after write), or
/// - the later is an image or storage write (write after read or write), or
/// - the earlier is an image or storage read and the later any write. Of render targets and GL
///   commands the specification only says that they wait for earlier *writes* of shaders; the bit
///   is put there, too, as nothing else would order them.
/// glFinish is no memory barrier: what a frame leaves pending stays pending in the next.
class BarrierTracker {
 public:
  /// Where each slot lies. Everything counts as accessed before in every way.
  void setMemory(std::span<const MemoryRange> slots);
  /// Between frames, anything may have been read by readers that do not report here.
  void beginFrame();
  /// Bits needed before the active rows of a step; 0 where none is. Then notes their accesses.
  /// @param slots number in setMemory() of each row's resource
  GLbitfield before(std::span<const Binding> rows, std::span<const std::uint32_t> slots,
                    std::uint32_t step);
  /// The same before a resource is cleared by a GL command.
  GLbitfield beforeClear(const Resource& resource, std::uint32_t slot);
  /// Slots that lie in the memory of a slot, itself included.
  [[nodiscard]] std::span<const std::uint32_t> sharing(std::uint32_t slot) const {
    return overlaps_[slot];
  }

 private:
  /// Bits that were not issued since the accesses that make a later one need them.
  struct Pending {
    GLbitfield forReads = 0;
    GLbitfield forWrites = 0;
  };
  [[nodiscard]] GLbitfield neededBy(const Binding& row, std::uint32_t slot) const;
  void settle(GLbitfield bits);
  void note(const Binding& row, std::uint32_t slot);

  std::vector<Pending> pending_;                      ///< by slot
  std::vector<std::vector<std::uint32_t>> overlaps_;  ///< slots of the same memory, itself included
};

}  // namespace macula::frame
