// The time-source check: is the GL timer right on this device?
#pragma once

#include <array>
#include <string>

#include "engine/gl/program.h"
#include "engine/gl/timer.h"

namespace macula::gl {

/// One dispatch repeated once, twice and four times, timed by the GL timer and by glFinish and a
/// steady clock.
struct TimeSourceCheck {
  static constexpr std::array<int, 3> kRepeats{1, 2, 4};
  std::array<double, 3> queryMs{};
  std::array<double, 3> finishMs{};
  TimeSource source = TimeSource::Finish;  ///< the one to use
  std::string reason;                      ///< one line: why it was chosen
};

/// Decides from the measured times; no GL. The timer passes where each of its times lies within
/// 20 % of the steady clock's.
void judge(TimeSourceCheck& check);

/// Runs the check in the current context (some tens of milliseconds).
[[nodiscard]] TimeSourceCheck checkTimeSource(ProgramCache& programs);

}  // namespace macula::gl
