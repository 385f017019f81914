// A simulated GPU: frame times as a function of r, noise and load. Deterministic.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "engine/control/law.h"
#include "engine/control/quality_controls.h"

namespace macula::control {

/// What a frame really costs, before any noise: t = work / r^2 + fixed, and the parts that other
/// controls reach.
struct Load {
  double workMs = 20.0;
  double fixedMs = 3.0;
  double layersMs = 0.0;       ///< of transparent surfaces: in proportion to the layers' share
  double foveatedShare = 0.0;  ///< of the work: in proportion to 1 / slope^2

  [[nodiscard]] double workOf(const ControlValues& controls) const {
    const double slope = controls[QualityControl::FoveaSlope];
    const double resize = controls[QualityControl::Resize];
    return workMs * (1.0 - foveatedShare + foveatedShare / (slope * slope)) / (resize * resize);
  }
  [[nodiscard]] double milliseconds(const ControlValues& controls) const {
    return workOf(controls) + layersMs * controls[QualityControl::LayerShare] + fixedMs;
  }
  [[nodiscard]] double milliseconds(double resize) const {
    ControlValues controls;
    controls[QualityControl::Resize] = resize;
    return milliseconds(controls);
  }
  [[nodiscard]] ControlWork controls() const {
    return {.resize = workMs > 0.0, .fovea = foveatedShare > 0.0, .layers = layersMs > 0.0};
  }
};

/// One experiment on a law.
struct PlantCase {
  std::string name;
  std::string title;  ///< for people
  int frames = 900;
  /// Frame at which the load changes; what is measured as steady lies after it has settled, and
  /// settling counts from here. 0: from the first frame.
  int stepFrame = 0;
  int steadyFrom = 300;  ///< first frame of the steady state
  std::function<Load(int frame)> load = [](int) { return Load{}; };
  double noise = 0.015;       ///< standard deviation, share of the time
  double spikeShare = 0.0;    ///< of the frames
  double leastSpikeMs = 3.0;  ///< spikes are even between the two
  double mostSpikeMs = 8.0;
  int deadFrames = 3;       ///< times of frame i are known when frame i + deadFrames is planned
  double tickMs = 0.0;      ///< times come in multiples of it; 0: as they are
  double lostShare = 0.0;   ///< of the times that never come
  double zeroShare = 0.0;   ///< that come as 0
  double staleShare = 0.0;  ///< that come as the time before, again
  bool separate = true;     ///< resizable and fixed passes are timed apart
  double cpuMs = 2.0;       ///< of every frame
  double refreshMs = 0.0;   ///< times are waited up to multiples of it; 0: no vsync in the clock
  double jitterMs = 0.0;    ///< standard deviation of times that are waited for
  double resizeStep = 0.0;  ///< r is rounded to multiples of it; 0: as it is
  double hitchMs = 0.0;     ///< added to one frame, in the middle of the steady state
};

/// The protocol.
[[nodiscard]] std::vector<PlantCase> plantCases();

/// A frame of a run.
struct PlantFrame {
  double resize = 1.0;
  ControlValues controls;
  double trueMs = 0.0;       ///< without noise
  double spentMs = 0.0;      ///< with noise and spikes
  double idealResize = 1.0;  ///< that meets the target exactly, 1 to 8
};

struct PlantRun {
  std::vector<PlantFrame> frames;
  std::string notice;  ///< of the law after the last frame
};

/// Chooses the controls of a frame as Controller::next() does.
using Chooser = std::function<ControlValues(const FrameTimes* newest, double resize, int frame)>;

/// The same for anything that chooses controls; gives no notice.
[[nodiscard]] PlantRun runPlant(const Chooser& choose, const PlantCase& plantCase, double targetMs,
                                std::uint32_t seed);

/// Runs a law on a case. The same arguments give the same run.
[[nodiscard]] PlantRun runPlant(Law& law, const PlantCase& plantCase, double targetMs,
                                std::uint32_t seed);

/// What a run comes to. Steady means from PlantCase::steadyFrom on.
struct PlantMeasures {
  /// Frames from the step until the true time stays within 5 % of its mean over the steady state;
  /// nothing where it never does.
  std::optional<int> settleFrames;
  double overShare = 0.0;     ///< of steady frames that took more than 1.02 T
  double over110Share = 0.0;  ///< more than 1.1 T
  int longestOver = 0;        ///< frames in a row over 1.02 T, anywhere
  double usedPixels = 0.0;    ///< steady pixels over those of the ideal r
  bool limitCycle = false;    ///< without noise, r still swings by over 3 % at the end
  double biasMs = 0.0;        ///< steady mean - T
  double sigmaMs = 0.0;
  double p50Ms = 0.0;
  double p95Ms = 0.0;
  double p99Ms = 0.0;
  double changesPerSecond = 0.0;    ///< of r, at 60 frames a second
  double reversalsPerSecond = 0.0;  ///< of its direction
};

/// Both with the case's step of r; with that of the options where the case has none.
[[nodiscard]] std::pair<PlantCase, LawOptions> withStep(PlantCase plantCase, LawOptions options);

/// Measures a law over some seeds: the worst settling, means of the rest. The limit cycle is
/// looked for in a run of its own without noise.
/// @param options their step of r counts where the case has none
[[nodiscard]] PlantMeasures measureLaw(const std::string& law, const PlantCase& plantCase,
                                       const LawOptions& options, int seeds);

}  // namespace macula::control
