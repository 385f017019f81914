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

/// Marks points of a frame and gives the milliseconds between them. Holds at most kMaxMarks.
class FrameTimer {
 public:
  static constexpr std::size_t kMaxMarks = 64;
  explicit FrameTimer(TimeSource source);
  void begin();  ///< the first mark; waits for earlier work
  void mark();   ///< the end of one interval and the begin of the next
  void end();    ///< waits for the GPU and takes the total by the steady clock
  [[nodiscard]] TimeSource source() const { return source_; }
  /// Milliseconds of interval i, in the order of the calls of mark(). Valid after end().
  [[nodiscard]] double intervalMs(std::size_t i) const { return intervals_[i]; }
  [[nodiscard]] std::size_t intervals() const { return marks_ == 0 ? 0 : marks_ - 1; }
  /// From begin() to end(), from glFinish to glFinish.
  [[nodiscard]] double totalMs() const { return totalMs_; }

 private:
  using Clock = std::chrono::steady_clock;
  TimeSource source_;
  std::size_t marks_ = 0;
  std::array<Clock::time_point, kMaxMarks> times_{};
  std::vector<QueryId> queries_;
  std::array<double, kMaxMarks> intervals_{};
  Clock::time_point begin_;
  double totalMs_ = 0.0;
};

}  // namespace macula::gl
