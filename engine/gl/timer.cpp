#include "engine/gl/timer.h"

#include <fmt/format.h>

#include <numeric>
#include <stdexcept>

#include "engine/gl/blocking.h"

namespace macula::gl {
namespace {

constexpr double kMsPerNs = 1e-6;

}  // namespace

std::string_view nameOf(TimeSource source) {
  return source == TimeSource::Finish ? "finish" : "query";
}

FrameTimer::FrameTimer(TimeSource source) : source_(source) {
  if (source_ != TimeSource::Query) return;
  for (Frame& frame : frames_) {
    frame.queries.reserve(kMaxMarks);
    for (std::size_t i = 0; i < kMaxMarks; ++i) {
      GLuint id = 0;
      glCreateQueries(GL_TIMESTAMP, 1, &id);
      frame.queries.emplace_back(id);
    }
  }
}

void FrameTimer::begin(std::size_t slot) {
  open_ = slot;
  frames_[slot].marks = frames_[slot].known = 0;
  mark();
}

void FrameTimer::mark() {
  Frame& frame = frames_[open_];
  if (frame.marks == kMaxMarks) {
    throw std::logic_error(fmt::format("a frame has more than {} passes to time", kMaxMarks - 1));
  }
  if (source_ == TimeSource::Finish) {
    finish();
    frame.at[frame.marks] = Clock::now();
  } else {
    glQueryCounter(frame.queries[frame.marks].id(), GL_TIMESTAMP);
  }
  ++frame.marks;
}

bool FrameTimer::ready(std::size_t slot) {
  Frame& frame = frames_[slot];
  for (; frame.known < frame.marks; ++frame.known) {
    const std::size_t i = frame.known;
    double ms = 0.0;
    if (source_ == TimeSource::Query) {
      const auto now = resultIfThere(frame.queries[i].id());
      if (!now) return false;
      frame.nanoseconds[i] = *now;
      if (i > 0) ms = static_cast<double>(*now - frame.nanoseconds[i - 1]) * kMsPerNs;
    } else if (i > 0) {
      ms = std::chrono::duration<double, std::milli>(frame.at[i] - frame.at[i - 1]).count();
    }
    if (i > 0) frame.intervals[i - 1] = ms;
  }
  return true;
}

void FrameTimer::wait(std::size_t slot) {
  const Frame& frame = frames_[slot];
  // Marks are reached in their order.
  while (!ready(slot)) (void)queryResult(frame.queries[frame.marks - 1].id());
}

double FrameTimer::totalMs(std::size_t slot) const {
  const Frame& frame = frames_[slot];
  return std::accumulate(frame.intervals.begin(),
                         frame.intervals.begin() + static_cast<std::ptrdiff_t>(intervals(slot)),
                         0.0);
}

}  // namespace macula::gl
