#include "walk/cpu_times.h"

#include <ctime>

namespace macula::tools {

double threadMs() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  constexpr double kMsPerSecond = 1e3;
  constexpr double kMsPerNanosecond = 1e-6;
  return kMsPerSecond * static_cast<double>(now.tv_sec) +
         kMsPerNanosecond * static_cast<double>(now.tv_nsec);
}

}  // namespace macula::tools
