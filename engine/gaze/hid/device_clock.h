// Whether a tracker's own timestamps can be believed.
#pragma once

#include <cstddef>
#include <optional>

namespace macula::gaze::hid {

/// Checked against the host over spans of at least this long and this many reports. Shorter spans
/// would take a late batch of reports for a wrong clock.
inline constexpr double kClockSpanSeconds = 0.5;
inline constexpr std::size_t kClockSpanReports = 16;
/// Device time may advance this many times as fast or as slowly as the host's within a span.
inline constexpr double kClockTolerance = 2.0;
/// At least this share of reports must have a timestamp later than the one before. A clock of whole
/// seconds repeats itself in nearly all.
inline constexpr double kClockAdvancing = 0.5;

/// Lets timestamps through only once a whole span of them has advanced as the host's clock did, and
/// until one does not: some drivers send whole seconds in a field of microseconds, some repeat one
/// number, some count in other units than the descriptor states. What is withheld is no timestamp
/// at all, so that nothing downstream takes repeats for repeated samples.
class DeviceClock {
 public:
  enum class Verdict { Unknown, Good, Wrong };

  /// Takes one report's times and gives back the device's where it is to be believed.
  [[nodiscard]] std::optional<double> check(double hostSeconds,
                                            std::optional<double> deviceSeconds);

  [[nodiscard]] Verdict verdict() const { return verdict_; }

 private:
  void judge(double hostSpan, double deviceSpan);

  Verdict verdict_ = Verdict::Unknown;
  bool started_ = false;
  double hostBegin_ = 0.0;
  double deviceBegin_ = 0.0;
  double deviceLast_ = 0.0;
  std::size_t reports_ = 0;   ///< in this span, after its first
  std::size_t advances_ = 0;  ///< of those, later than the one before
};

}  // namespace macula::gaze::hid
