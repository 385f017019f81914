// The slow controls: moved by steps, with a wait after each.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/control/quality_controls.h"

namespace macula::control {

/// Moves the controls behind r. A step is judged by the median of the times of kWait frames that
/// were all drawn with it, so that it waits for as long as times are late and no single hitch moves
/// anything. What a step has saved is kept, up to ControlInfo::mostGain: it is taken back once the
/// time would stay below the target without it. A steady load therefore takes a step once: beyond
/// 1.02 of the target it is taken, and below 0.97 without it given back.
class SlowControls {
 public:
  /// Frames that judge a step. The median of 10 times that spread by 4 % spreads by 1.6 %.
  static constexpr std::size_t kWait = 10;

  /// Takes the time of a frame.
  /// @param frame its index @param totalMs > 0
  /// @param resizeEnded it was drawn while r could give no more
  void observe(std::uint64_t frame, double totalMs, bool resizeEnded);
  /// Decides for the next frame.
  /// @param frame its index
  void decide(std::uint64_t frame, double targetMs, const ControlWork& work);
  /// Times of frames before this one say nothing any more.
  void forgetTimes(std::uint64_t frame);
  /// All controls back to rest, at once.
  void rest();

  /// A slow control that is not at rest.
  [[nodiscard]] bool engaged() const { return !steps_.empty(); }
  /// The last decision found the time over the target and no control left.
  [[nodiscard]] bool exhausted() const { return exhausted_; }
  /// Where exhausted(): the median time when it was first found so, or has since moved by a tenth,
  /// ms.
  [[nodiscard]] double leastMs() const { return leastMs_; }
  /// Writes the slow controls' places.
  void apply(ControlValues& values) const;

 private:
  struct Step {
    QualityControl control;
    double beforeMs;    ///< median without it
    double gain = 0.0;  ///< time without it over time with it; 0: not measured yet
  };

  bool take(std::uint64_t frame, const ControlWork& work);

  std::vector<Step> steps_;  ///< in the order in which they were taken
  std::array<double, kWait> times_{};
  std::size_t count_ = 0;    ///< times so far, of which the last kWait are kept
  std::uint64_t since_ = 0;  ///< first frame that the present controls were used for
  double medianMs_ = 0.0;
  double leastMs_ = 0.0;
  bool exhausted_ = false;
};

}  // namespace macula::control
