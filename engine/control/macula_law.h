// Macula's control law.
#pragma once

#include <cstdint>

#include "engine/control/law.h"
#include "engine/control/work_estimate.h"

namespace macula::control {

/// Inverts t = K / r^2 + C. K and C are estimated apart, each time paired with the r that its frame
/// was drawn with, so that dead time shifts what is known and does not unsettle it. The aim lies
/// below the target by what the measured spread asks for. It gives way at once, comes back slowly,
/// and stays where it is inside of a dead band. Nothing is integrated, so nothing winds up at r = 1
/// or 8.
class MaculaLaw final : public Law {
 public:
  explicit MaculaLaw(const LawOptions& options)
      : targetMs_(options.targetMs),
        step_(options.resizeStep),
        mostResize_(options.mostResize),
        leastAim_(options.leastAim) {}
  [[nodiscard]] double next(const FrameTimes* newest, double resize) override;
  bool scalePixels(double ratio) override;
  [[nodiscard]] Trouble trouble() const override { return trouble_; }

 private:
  void learn(const FrameTimes& times);
  void watchEffect(const FrameTimes& times);
  [[nodiscard]] double wanted() const;

  double targetMs_;
  double step_;
  double mostResize_;
  double leastAim_;
  WorkEstimate work_;   ///< K: ms of the resizable passes at r = 1
  WorkEstimate fixed_;  ///< C: ms of the others
  WorkEstimate total_;  ///< measured over modelled: its spread gives the headroom
  std::uint64_t lastFrame_ = 0;
  bool sawFrame_ = false;
  int silent_ = 0;                ///< questions since times came
  FrameTimes watched_;            ///< the newest frame whose times are known
  double expectedSquares_ = 0.0;  ///< of changes of the time with r, as modelled, ms^2
  double seenProducts_ = 0.0;     ///< modelled times seen changes, ms^2
  int ineffective_ = 0;           ///< changes in a row after which no effect was found
  Trouble trouble_ = Trouble::None;
};

}  // namespace macula::control
