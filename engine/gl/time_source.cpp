#include "engine/gl/time_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace macula::gl {
namespace {

using Clock = std::chrono::steady_clock;

/// The timer may differ from the steady clock by this share: launch costs are in one and not in
/// the other.
constexpr double kTolerance = 0.20;
/// Below this a launch costs as much as the work, and the comparison says nothing.
constexpr double kLeastMs = 4.0;
constexpr int kFirstIterations = 256;
constexpr int kMostIterations = 1 << 22;
constexpr GLuint kGroups = 64;

void dispatch(GLuint program, int iterations, int times) {
  glUseProgram(program);
  glUniform1i(0, iterations);
  for (int i = 0; i < times; ++i) {
    glDispatchCompute(kGroups, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  }
}

double finishMs(GLuint program, int iterations, int times) {
  glFinish();
  const auto begin = Clock::now();
  dispatch(program, iterations, times);
  glFinish();
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

double queryMs(GLuint program, int iterations, int times) {
  GLuint id = 0;
  glCreateQueries(GL_TIME_ELAPSED, 1, &id);
  const QueryId query(id);
  glBeginQuery(GL_TIME_ELAPSED, id);
  dispatch(program, iterations, times);
  glEndQuery(GL_TIME_ELAPSED);
  GLuint64 nanoseconds = 0;
  glGetQueryObjectui64v(id, GL_QUERY_RESULT, &nanoseconds);
  return static_cast<double>(nanoseconds) * 1e-6;
}

}  // namespace

void judge(TimeSourceCheck& check) {
  for (std::size_t i = 0; i < check.kRepeats.size(); ++i) {
    const double ratio = check.queryMs[i] / check.finishMs[i];
    if (!(std::abs(ratio - 1.0) <= kTolerance)) {
      check.source = TimeSource::Finish;
      check.reason = fmt::format(
          "the GL timer says {:.2f} ms where the steady clock says {:.2f} ms ({} dispatches), so "
          "glFinish and the steady clock are used",
          check.queryMs[i], check.finishMs[i], check.kRepeats[i]);
      return;
    }
  }
  check.source = TimeSource::Query;
  check.reason = "the GL timer agrees with glFinish and the steady clock within 20 %";
}

TimeSourceCheck checkTimeSource(ProgramCache& programs) {
  const GLuint program = programs.get({{"time_source.comp"}, {}, {}});
  const Buffer sink("time-source check", sizeof(GLuint) * kGroups * 64);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, sink.id());
  int iterations = kFirstIterations;
  finishMs(program, iterations, 1);  // compiles
  while (finishMs(program, iterations, 1) < kLeastMs && iterations < kMostIterations) iterations *= 4;
  TimeSourceCheck check;
  for (std::size_t i = 0; i < check.kRepeats.size(); ++i) {
    // The least of three: other work on the machine only ever adds.
    constexpr int kTries = 3;
    double leastFinish = finishMs(program, iterations, check.kRepeats[i]);
    double leastQuery = queryMs(program, iterations, check.kRepeats[i]);
    for (int n = 1; n < kTries; ++n) {
      leastFinish = std::min(leastFinish, finishMs(program, iterations, check.kRepeats[i]));
      leastQuery = std::min(leastQuery, queryMs(program, iterations, check.kRepeats[i]));
    }
    check.finishMs[i] = leastFinish;
    check.queryMs[i] = leastQuery;
  }
  judge(check);
  return check;
}

}  // namespace macula::gl
