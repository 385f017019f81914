// Whether the timestamps of a device can be believed: the one place that decides it.
#pragma once

#include <cstddef>

namespace macula::gaze {

/// Compares a device's clock with the host's over whole spans of time: some drivers send whole
/// seconds in a field of microseconds, some repeat one number, some count in other units than they
/// state. A clock is believed once a whole span of it has advanced as the host's did, and until one
/// does not.
class ClockJudge {
 public:
  /// A span lasts at least this long and has at least this many samples: a shorter one would take
  /// samples that arrive together late for a wrong clock.
  static constexpr double kSpanSeconds = 0.5;
  static constexpr std::size_t kSpanSamples = 16;
  /// Device time may advance this many times as fast or as slowly as the host's within a span.
  static constexpr double kTolerance = 2.0;
  /// At least this share of the samples of a span must have a later timestamp than the one before:
  /// a coarser clock does not tell samples apart.
  static constexpr double kAdvancing = 0.9;

  enum class Verdict { Unknown, Good, Wrong };

  /// Takes the times of one sample, both in seconds and finite; the host's do not decrease.
  void add(double deviceSeconds, double hostSeconds);

  [[nodiscard]] Verdict verdict() const { return verdict_; }
  [[nodiscard]] bool believes() const { return verdict_ == Verdict::Good; }

 private:
  Verdict verdict_ = Verdict::Unknown;
  bool started_ = false;
  double hostBegin_ = 0.0;
  double deviceBegin_ = 0.0;
  double deviceLast_ = 0.0;
  std::size_t samples_ = 0;   ///< in this span, after its first
  std::size_t advances_ = 0;  ///< of those, later than the one before
};

}  // namespace macula::gaze
