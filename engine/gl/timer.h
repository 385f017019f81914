// Times of passes, from a clock that has shown that it tells the truth.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <string_view>
#include <vector>

#include "engine/gl/objects.h"

namespace macula::gl {

enum class TimeSource {
  Finish,  ///< glFinish and a steady clock: right everywhere, but passes cannot overlap
  Query,   ///< GL_TIMESTAMP queries: needs a GPU whose timer passes the time-source check
};

[[nodiscard]] std::string_view nameOf(TimeSource source);

/// Marks points of frames and gives the milliseconds between them. With queries nothing waits but
/// wait(): the marks of several frames may be on their way, each in a slot of its own.
class FrameTimer {
 public:
  static constexpr std::size_t kMaxMarks = 64;  ///< of a frame
  static constexpr std::size_t kSlots = 4;      ///< frames whose marks may be on their way
  explicit FrameTimer(TimeSource source);
  [[nodiscard]] TimeSource source() const { return source_; }

  /// The first mark of a frame. With glFinish, waits for earlier work. @param slot below kSlots
  void begin(std::size_t slot);
  /// The end of one interval and the begin of the next.
  /// @throws std::logic_error where the frame has kMaxMarks already
  void mark();

  /// Whether the times of a slot's frame are there; never waits.
  [[nodiscard]] bool ready(std::size_t slot);
  /// Waits until they are.
  void wait(std::size_t slot);
  /// Milliseconds of interval i, in the order of the calls of mark(). Valid once the slot is ready.
  [[nodiscard]] double intervalMs(std::size_t slot, std::size_t i) const {
    return frames_[slot].intervals[i];
  }
  [[nodiscard]] std::size_t intervals(std::size_t slot) const {
    return frames_[slot].marks == 0 ? 0 : frames_[slot].marks - 1;
  }
  /// From the first mark to the last.
  [[nodiscard]] double totalMs(std::size_t slot) const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Frame {
    std::size_t marks = 0;
    std::size_t known = 0;                          ///< marks whose times have been read
    std::array<Clock::time_point, kMaxMarks> at{};  ///< with glFinish
    std::array<GLuint64, kMaxMarks> nanoseconds{};  ///< with queries
    std::vector<QueryId> queries;
    std::array<double, kMaxMarks> intervals{};
  };

  TimeSource source_;
  std::array<Frame, kSlots> frames_;
  std::size_t open_ = 0;  ///< slot of the frame that is being marked
};

}  // namespace macula::gl
