// Whether times follow r: small changes of r that no load asks for, and what the clock says to
// them.
#pragma once

#include <optional>

#include "engine/control/law.h"

namespace macula::control {

/// A clock that waits for a display gives times in multiples of its period, and a law that inverts
/// t = K / r^2 + C on it swings between two of them, or runs to r's end while times stand still.
/// Such times cannot be told from good ones by watching: a law holds times where they are, so that
/// r moves while they rest on any clock. Hence r is probed: where it has moved, and nothing has
/// shown that times follow, one frame is drawn with fewer pixels than the two beside it. The time
/// of a sound clock falls with them; that of a clock that waits stays, or falls by a whole period.
/// Noise alone looks like the first twice as often as like the second.
class ClockProbe {
 public:
  /// @param mostResize r's end
  explicit ClockProbe(double mostResize) : mostResize_(mostResize) {}

  /// Takes the times of a frame. @param workMs K as it is known now
  void observe(const FrameTimes& times, double workMs);

  /// r of the next frame. Asked once a frame.
  /// @param wanted r that the law wants @param resize of the frame before
  /// @param workShare of the time, in passes that follow r
  /// @param fresh times of a frame have come since the last question
  [[nodiscard]] double next(double wanted, double resize, double workShare, bool fresh);

  /// Times of frames of another size are not compared with these.
  void forgetTimes() { older_ = old_ = {}; }

  /// Probes have shown that times do not follow r. It stays so.
  [[nodiscard]] bool failed() const;

 private:
  struct Seen {
    FrameTimes times;
    [[nodiscard]] double pixels() const { return 1.0 / (times.resize * times.resize); }
  };

  [[nodiscard]] bool judgeProbe(const Seen& newest, double workMs);
  void judgeStep(const Seen& newest, double workMs);
  void confirm(double resize);

  double mostResize_;
  std::optional<Seen> older_;        ///< the frame before old_, where its times are known
  std::optional<Seen> old_;          ///< the newest frame whose times are known
  std::optional<double> confirmed_;  ///< r where times last followed; r of the first time before
  double path_ = 0.0;                ///< sum of the changes of ln(pixels) since then, fading
  bool upwards_ = true;              ///< the next probe has fewer pixels, not more
  std::optional<double> returnTo_;   ///< r beside the probe that has just been made
  int wait_ = 0;                     ///< questions until the next probe
  double stuck_ = 0.0;               ///< probes that changed nothing, less those that did
};

}  // namespace macula::control
