#include "engine/control/plant.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>

namespace macula::control {
namespace {

/// Random numbers whose values do not depend on the library.
class Dice {
 public:
  explicit Dice(std::uint32_t seed) : engine_(seed) {}
  /// 0..1
  double even() { return static_cast<double>(engine_()) / 4294967296.0; }
  bool happens(double share) { return even() < share; }
  /// Standard normal (Box and Muller 1958).
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - even()));
    return radius * std::cos(2.0 * std::numbers::pi * even());
  }

 private:
  std::mt19937 engine_;
};

double idealResize(const Load& load, double targetMs) {
  const double forWork = targetMs - load.fixedMs - load.layersMs;
  if (forWork <= 0.0) return kMostResize;
  return std::clamp(std::sqrt(load.workMs / forWork), kLeastResize, kMostResize);
}

/// Frame times as a timer gives them.
class Clock {
 public:
  Clock(const PlantCase& plantCase, Dice& dice) : case_(plantCase), dice_(dice) {}

  FrameTimes measure(int frame, double resize, double workMs, double spentMs) {
    FrameTimes times;
    times.frame = static_cast<std::uint64_t>(frame);
    times.resize = resize;
    times.cpuMs = case_.cpuMs;
    double total = spentMs;
    if (case_.refreshMs > 0.0) total = std::ceil(total / case_.refreshMs) * case_.refreshMs;
    if (case_.refreshMs > 0.0 && case_.jitterMs > 0.0) total += case_.jitterMs * dice_.normal();
    times.totalMs = ticked(total);
    if (case_.separate && case_.refreshMs <= 0.0) times.resizableMs = ticked(workMs);
    if (dice_.happens(case_.zeroShare)) {
      times.totalMs = 0.0;
      times.resizableMs = 0.0;
    }
    if (dice_.happens(case_.staleShare) && seen_) times = last_;
    seen_ = true;
    last_ = times;
    return times;
  }

 private:
  [[nodiscard]] double ticked(double ms) const {
    return case_.tickMs > 0.0 ? std::round(ms / case_.tickMs) * case_.tickMs : ms;
  }

  const PlantCase& case_;
  Dice& dice_;
  FrameTimes last_;
  bool seen_ = false;
};

}  // namespace

PlantRun runPlant(const Chooser& choose, const PlantCase& plantCase, double targetMs,
                  std::uint32_t seed) {
  PlantRun run;
  run.frames.reserve(static_cast<std::size_t>(plantCase.frames));
  Dice dice(seed);
  Clock clock(plantCase, dice);
  std::deque<std::optional<FrameTimes>> pipe(static_cast<std::size_t>(plantCase.deadFrames));
  double resize = 1.0;
  for (int frame = 0; frame < plantCase.frames; ++frame) {
    const std::optional<FrameTimes> newest = pipe.front();
    pipe.pop_front();
    ControlValues controls = choose(newest ? &*newest : nullptr, resize, frame);
    resize = controls[QualityControl::Resize];
    if (plantCase.resizeStep > 0.0) {
      resize =
          std::max(std::round(resize / plantCase.resizeStep) * plantCase.resizeStep, kLeastResize);
    }
    controls[QualityControl::Resize] = resize;
    const Load load = plantCase.load(frame);
    const double factor = 1.0 + plantCase.noise * dice.normal();
    const double spike = dice.happens(plantCase.spikeShare)
                             ? std::lerp(plantCase.leastSpikeMs, plantCase.mostSpikeMs, dice.even())
                             : 0.0;
    const bool hitch =
        plantCase.hitchMs > 0.0 && frame == (plantCase.steadyFrom + plantCase.frames) / 2;
    const double late = spike + (hitch ? plantCase.hitchMs : 0.0);
    const double work = load.workOf(controls) * factor;
    PlantFrame drawn;
    drawn.resize = resize;
    drawn.controls = controls;
    drawn.trueMs = load.milliseconds(controls);
    drawn.spentMs = drawn.trueMs * factor + late;
    drawn.idealResize = idealResize(load, targetMs);
    run.frames.push_back(drawn);
    // A spike hits some pass or other: here the fixed ones.
    const FrameTimes times = clock.measure(frame, resize, work, drawn.spentMs);
    pipe.push_back(dice.happens(plantCase.lostShare) ? std::nullopt : std::optional(times));
  }
  return run;
}

PlantRun runPlant(Law& law, const PlantCase& plantCase, double targetMs, std::uint32_t seed) {
  const Chooser choose = [&](const FrameTimes* newest, double resize, int) {
    ControlValues controls;
    controls[QualityControl::Resize] = law.next(newest, resize);
    return controls;
  };
  PlantRun run = runPlant(choose, plantCase, targetMs, seed);
  run.notice = law.notice();
  return run;
}

}  // namespace macula::control
