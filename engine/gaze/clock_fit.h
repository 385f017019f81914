// From the clock of a tracker to the clock of this machine.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace macula::gaze {

/// Fits host = device + offset + drift (device - first device time) to pairs of a sample's device
/// time and the host time at which it arrived. A sample arrives late, never early, so of each
/// second only the pair with the least delay counts (Cristian 1989: the quickest answer tells the
/// time best); the line is fitted to those by least squares. A constant part of the delay cannot be
/// told from an offset: the fit takes the quickest arrival for the moment of measurement. Whether
/// the device's times can be believed at all is ClockJudge's to say.
class ClockFit {
 public:
  /// Seconds of device time of which the quickest arrival is kept.
  static constexpr double kBlockSeconds = 1.0;
  /// Blocks that the line is fitted to: quartz drifts by temperature, so an old block is forgotten.
  static constexpr std::size_t kBlocks = 60;
  /// Fewer blocks give the offset alone: over a few seconds jitter looks like drift.
  static constexpr std::size_t kBlocksForDrift = 10;
  /// A device clock that steps back, or leaves the fit by more than this, has been set.
  static constexpr double kRestartSeconds = 1.0;
  /// A block that lies farther off the line was stepped: no driver is late by as much for a second.
  static constexpr double kStepSeconds = 0.050;

  ClockFit();

  /// Takes one pair. Both in seconds; the host's times do not decrease.
  void add(double deviceSeconds, double hostSeconds);

  /// Host time at which the sample was taken, by the fit; nothing before the first pair.
  [[nodiscard]] std::optional<double> toHost(double deviceSeconds) const;

  /// Host time minus device time at the first pair since the last restart, in seconds.
  [[nodiscard]] double offsetSeconds() const { return base_ + intercept_; }
  /// How much faster the host's clock runs, in parts per million.
  [[nodiscard]] double driftPpm() const;
  /// Root mean square distance of the kept pairs from the line, in seconds.
  [[nodiscard]] double residualSeconds() const { return residual_; }
  /// Times that the device's clock was found to have been set.
  [[nodiscard]] std::size_t restarts() const { return restarts_; }

 private:
  struct Block {
    double start = 0.0;   ///< device time of its first pair, since firstDevice_
    double device = 0.0;  ///< of the pair with the least delay
    double delay = 0.0;   ///< host - device - base_, least of the block
  };

  void restart(double deviceSeconds, double hostSeconds);
  void fit();

  std::vector<Block> blocks_;  ///< ring of at most kBlocks
  std::size_t newest_ = 0;
  bool started_ = false;
  double firstDevice_ = 0.0;
  double newestDevice_ = 0.0;
  double base_ = 0.0;  ///< host - device of the first pair: keeps the sums small
  double intercept_ = 0.0;
  double slope_ = 0.0;
  double residual_ = 0.0;
  std::size_t restarts_ = 0;
};

}  // namespace macula::gaze
