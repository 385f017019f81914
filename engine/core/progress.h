// How far a run is, in lines of text: for logs and pipes, where no bar can be drawn.
#pragma once

#include <functional>
#include <string>

namespace macula {

/// Seconds between two lines.
inline constexpr double kProgressSeconds = 10.0;

class ProgressLines {
 public:
  /// Seconds since any begin; never goes back.
  using Clock = std::function<double()>;

  /// @param total steps @param clock asked now and after each step
  ProgressLines(std::string label, int total, Clock clock);

  /// One more step is done.
  /// @returns a line, where kProgressSeconds have passed since the begin or the last line and
  ///   something is left to do; else nothing. Remaining time: as long for each step as so far.
  [[nodiscard]] std::string advance();

 private:
  std::string label_;
  int total_;
  int done_ = 0;
  Clock clock_;
  double begin_;
  double last_;
};

}  // namespace macula
