// The control laws of others, from their descriptions, as baselines.
#pragma once

#include <array>
#include <cstddef>

#include "engine/control/law.h"

namespace macula::control {

/// Always the same r, whatever LawOptions::mostResize is.
class FixedLaw final : public Law {
 public:
  explicit FixedLaw(const LawOptions& options) : resize_(options.fixedResize) {}
  [[nodiscard]] double next(const FrameTimes* /*newest*/, double /*usedResize*/) override {
    return resize_;
  }
  [[nodiscard]] bool holdsTarget() const override { return false; }

 private:
  double resize_;
};

/// Yang 2008, Eq. 4 with a constant K', |dr| <= 0.2 and r >= 1. A time is taken for one of the
/// frame just drawn, whichever r its frame had.
class YangLaw final : public Law {
 public:
  explicit YangLaw(const LawOptions& options)
      : targetMs_(options.targetMs),
        mostResize_(options.mostResize),
        work_(options.expectedWorkMs) {}
  [[nodiscard]] double next(const FrameTimes* newest, double resize) override;

 private:
  double targetMs_;
  double mostResize_;
  double work_;
};

/// Filament's dynamic resolution: a PI controller on the area, on the median of 15 times.
class FilamentLaw final : public Law {
 public:
  explicit FilamentLaw(const LawOptions& options)
      : targetMs_(options.targetMs), mostResize_(options.mostResize) {}
  [[nodiscard]] double next(const FrameTimes* newest, double resize) override;

 private:
  static constexpr std::size_t kWindow = 15;
  double targetMs_;
  double mostResize_;
  std::array<double, kWindow> times_{};
  std::size_t count_ = 0;
  double integral_ = 0.0;
};

/// Unreal Engine 5's heuristic: a weighted mean over 16 frames of the scale that would have met
/// 0.9 T; changes of 2 % or more, 8 frames apart; at once after 2 frames over the budget.
class UnrealLaw final : public Law {
 public:
  explicit UnrealLaw(const LawOptions& options)
      : targetMs_(options.targetMs), mostResize_(options.mostResize) {}
  [[nodiscard]] double next(const FrameTimes* newest, double resize) override;

 private:
  static constexpr std::size_t kWindow = 16;
  double targetMs_;
  double mostResize_;
  std::array<double, kWindow> scales_{};
  std::size_t count_ = 0;
  int sinceChange_ = 0;
  int over_ = 0;
};

/// Unity HDRP: half of the range down after 4 windows of 15 frames over the target, a fifth up
/// after 8 below it.
class UnityLaw final : public Law {
 public:
  explicit UnityLaw(const LawOptions& options)
      : targetMs_(options.targetMs), mostResize_(options.mostResize) {}
  [[nodiscard]] double next(const FrameTimes* newest, double resize) override;

 private:
  double targetMs_;
  double mostResize_;
  double sum_ = 0.0;
  int count_ = 0;
  int overWindows_ = 0;
  int underWindows_ = 0;
};

/// id Software, Doom 3 BFG: 0.11 of the scale down on a frame over the target, 0.06 up after 5
/// below it.
class IdLaw final : public Law {
 public:
  explicit IdLaw(const LawOptions& options)
      : targetMs_(options.targetMs), mostResize_(options.mostResize) {}
  [[nodiscard]] double next(const FrameTimes* newest, double resize) override;

 private:
  double targetMs_;
  double mostResize_;
  int under_ = 0;
};

}  // namespace macula::control
