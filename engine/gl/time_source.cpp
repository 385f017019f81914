#include "engine/gl/time_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "engine/core/plural.h"
#include "engine/gl/blocking.h"

namespace macula::gl {
namespace {

using Clock = std::chrono::steady_clock;

/// The timer may differ from the steady clock by this share: launch costs are in one and not in
/// the other.
constexpr double kTolerance = 0.20;
/// Below this a launch costs as much as the work, and the comparison means nothing.
constexpr double kLeastMs = 4.0;
/// Loop iterations of a thread; well below the bound that some rasterisers put on loops.
constexpr int kIterations = 4096;
constexpr GLuint kGroupThreads = 64;  // as in shaders/time_source.comp
constexpr GLuint kFirstGroups = 64;
constexpr GLuint kMostGroups = 1U << 16U;

void dispatch(GLuint program, GLuint groups, int times) {
  glUseProgram(program);
  glUniform1i(0, kIterations);
  for (int i = 0; i < times; ++i) {
    glDispatchCompute(groups, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  }
}

double finishMs(GLuint program, GLuint groups, int times) {
  finish();
  const auto begin = Clock::now();
  dispatch(program, groups, times);
  finish();
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

double queryMs(GLuint program, GLuint groups, int times) {
  GLuint id = 0;
  glCreateQueries(GL_TIME_ELAPSED, 1, &id);
  const QueryId query(id);
  glBeginQuery(GL_TIME_ELAPSED, id);
  dispatch(program, groups, times);
  glEndQuery(GL_TIME_ELAPSED);
  return static_cast<double>(queryResult(id)) * 1e-6;
}

}  // namespace

void judge(TimeSourceCheck& check) {
  for (std::size_t i = 0; i < check.kRepeats.size(); ++i) {
    const double ratio = check.queryMs[i] / check.finishMs[i];
    if (!(std::abs(ratio - 1.0) <= kTolerance)) {
      check.source = TimeSource::Finish;
      check.reason = fmt::format(
          "the GL timer says {:.2f} ms where the steady clock says {:.2f} ms ({}), so "
          "glFinish and the steady clock are used",
          check.queryMs[i], check.finishMs[i],
          counted(static_cast<std::uint64_t>(check.kRepeats[i]), "dispatch", "dispatches"));
      return;
    }
  }
  check.source = TimeSource::Query;
  check.reason = "the GL timer agrees with glFinish and the steady clock within 20 %";
}

TimeSourceCheck checkTimeSource(ProgramCache& programs) {
  const GLuint program = programs.get({{"time_source.comp"}, {}, {}});
  const Buffer sink("time-source check", sizeof(GLuint) * kMostGroups * kGroupThreads);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, sink.id());
  GLuint groups = kFirstGroups;
  finishMs(program, groups, 1);  // compiles
  while (finishMs(program, groups, 1) < kLeastMs && groups < kMostGroups) groups *= 2;
  TimeSourceCheck check;
  for (std::size_t i = 0; i < check.kRepeats.size(); ++i) {
    // The least of three: other work on the machine only ever adds.
    constexpr int kTries = 3;
    double leastFinish = finishMs(program, groups, check.kRepeats[i]);
    double leastQuery = queryMs(program, groups, check.kRepeats[i]);
    for (int n = 1; n < kTries; ++n) {
      leastFinish = std::min(leastFinish, finishMs(program, groups, check.kRepeats[i]));
      leastQuery = std::min(leastQuery, queryMs(program, groups, check.kRepeats[i]));
    }
    check.finishMs[i] = leastFinish;
    check.queryMs[i] = leastQuery;
  }
  judge(check);
  return check;
}

}  // namespace macula::gl
