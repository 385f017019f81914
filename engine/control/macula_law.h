// Macula's control law.
#pragma once

#include <cstdint>

#include "engine/control/clock_probe.h"
#include "engine/control/law.h"
#include "engine/control/work_estimate.h"

namespace macula::control {

/// Inverts t = K / r^2 + C. K and C are estimated apart, each time paired with the r that its frame
/// was drawn with, so that dead time shifts what is known and does not unsettle it. The aim lies
/// below the target by what the measured spread asks for. It gives way at once, comes back slowly,
/// and stays where it is inside of a dead band. Nothing is integrated, so nothing winds up at r = 1
/// or 8. Where r has moved and times have not shown that they follow, it is probed (clock_probe.h).
class MaculaLaw final : public Law {
 public:
  explicit MaculaLaw(const LawOptions& options)
      : targetMs_(options.targetMs),
        step_(options.resizeStep),
        mostResize_(options.mostResize),
        leastAim_(options.leastAim),
        probe_(options.mostResize) {}
  [[nodiscard]] double next(const FrameTimes* newest, double resize) override;
  bool scalePixels(double ratio) override;
  [[nodiscard]] Trouble trouble() const override { return trouble_; }

 private:
  void learn(const FrameTimes& times);
  [[nodiscard]] double wanted() const;
  /// The next r on the way to the one that is wanted.
  [[nodiscard]] double moved(double goal, double resize) const;

  double targetMs_;
  double step_;
  double mostResize_;
  double leastAim_;
  WorkEstimate work_;   ///< K: ms of the resizable passes at r = 1
  WorkEstimate fixed_;  ///< C: ms of the others
  WorkEstimate total_;  ///< measured over modelled: its spread gives the headroom
  std::uint64_t lastFrame_ = 0;
  bool sawFrame_ = false;
  int silent_ = 0;  ///< questions since times came
  ClockProbe probe_;
  Trouble trouble_ = Trouble::None;
};

}  // namespace macula::control
