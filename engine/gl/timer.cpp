#include "engine/gl/timer.h"

#include <cassert>

namespace macula::gl {
namespace {

double milliseconds(std::chrono::steady_clock::duration d) {
  return std::chrono::duration<double, std::milli>(d).count();
}

}  // namespace

std::string_view nameOf(TimeSource source) {
  return source == TimeSource::Finish ? "finish" : "query";
}

FrameTimer::FrameTimer(TimeSource source) : source_(source) {
  if (source_ != TimeSource::Query) return;
  queries_.reserve(kMaxMarks);
  for (std::size_t i = 0; i < kMaxMarks; ++i) {
    GLuint id = 0;
    glCreateQueries(GL_TIMESTAMP, 1, &id);
    queries_.emplace_back(id);
  }
}

void FrameTimer::begin() {
  glFinish();
  marks_ = 0;
  begin_ = Clock::now();
  mark();
}

void FrameTimer::mark() {
  assert(marks_ < kMaxMarks);
  if (source_ == TimeSource::Finish) {
    glFinish();
    times_[marks_] = Clock::now();
  } else {
    glQueryCounter(queries_[marks_].id(), GL_TIMESTAMP);
  }
  ++marks_;
}

void FrameTimer::end() {
  glFinish();
  totalMs_ = milliseconds(Clock::now() - begin_);
  GLuint64 previous = 0;
  for (std::size_t i = 0; i < marks_; ++i) {
    GLuint64 now = 0;
    if (source_ == TimeSource::Query) {
      glGetQueryObjectui64v(queries_[i].id(), GL_QUERY_RESULT, &now);
    }
    if (i > 0) {
      constexpr double kMsPerNs = 1e-6;
      intervals_[i - 1] = source_ == TimeSource::Query
                              ? static_cast<double>(now - previous) * kMsPerNs
                              : milliseconds(times_[i] - times_[i - 1]);
    }
    previous = now;
  }
}

}  // namespace macula::gl
