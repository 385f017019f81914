// How well a target was held by a real renderer whose times nobody can repeat.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace macula::control {

/// A frame of a run: drawn under control, and once more beside it with a fixed r.
struct HeldFrame {
  double ms = 0.0;           ///< > 0
  double resizableMs = 0.0;  ///< of it, in passes whose work follows 1 / r^2
  double resize = 1.0;       ///< r as it was really used
  double fixedMs = 0.0;      ///< of the frame with the fixed r
  int load = 1;              ///< times that shading is computed
  bool othersAtRest = true;  ///< no control but r is away from rest
};

/// What is compared.
struct HoldRun {
  double targetMs = 0.0;
  double mostResize = 1.0;  ///< r's end
  std::span<const HeldFrame> frames;
  std::vector<std::size_t> steps;  ///< frames at which the load changes, ascending; without 0
};

/// Why the ideal r is not another one.
enum class ResizeLimit {
  Target,    ///< nothing: it meets the target
  FullRate,  ///< r = 1 is in time
  NoWork,    ///< nothing is computed at 1/r
  End,       ///< r ends before the target is met
  Floor,     ///< what does not shrink with r takes as long as the target, or longer
};

/// "target within reach", "r at its end 8" and so on. @param mostResize r's end
[[nodiscard]] std::string textOf(ResizeLimit limit, double mostResize);

/// t = K / r^2 + C of one load, and the r that follows from it. By r alone: frames in which other
/// controls are away from rest are left out, unless there are no others.
struct ResizeModel {
  double workMs = 0.0;       ///< K: median of the resizable time, times r^2
  double restMs = 0.0;       ///< C: median of the other times
  double idealResize = 1.0;  ///< that meets the target by K / r^2 + C, 1 to the most
  ResizeLimit limit = ResizeLimit::NoWork;
  /// K / r^2 + C at the ideal r: the target, or less where full rate fits, more where r does not
  /// reach it.
  double reachableMs = 0.0;
};

/// All frames of one load, wherever they are: it has one ideal r.
struct HoldLoad {
  int times = 1;  ///< that shading is computed
  ResizeModel model;
};

/// Frames between two changes of the load.
struct HoldPart {
  std::size_t begin = 0;
  std::size_t end = 0;
  int load = 1;
  ResizeModel model;        ///< of its load
  std::size_t judged = 0;   ///< frames without those that settle
  double within = 0.0;      ///< share of them within the tolerance
  std::optional<bool> met;  ///< whether that is as many as the gate asks for; none of none
  /// Frames from the part's begin from which on every median of 5 times is in the tolerance; none
  /// where the last is not, or there are fewer times.
  std::optional<std::size_t> settleFrames;
  /// Over those of the ideal r, without the part's first kSettling frames; none where there are no
  /// others.
  std::optional<double> usedPixels;
};

/// Frames after the begin and after each change of the load that the gate leaves out.
inline constexpr std::size_t kSettling = 10;
/// The gate of the project: so many of the other frames...
inline constexpr double kGateShare = 0.9;
/// ...lie within this share of the target, plus the spread of the fixed r.
inline constexpr double kGateTolerance = 0.05;
/// A machine may be so busy that its times spread by more than themselves. Further from the target
/// than this nothing counts as held.
inline constexpr double kMostTolerance = 0.3;

struct HoldMeasures {
  std::vector<HoldLoad> loads;  ///< in the order in which they came
  std::vector<HoldPart> parts;
  /// What kGateShare of the frames with the fixed r stay within, as a share of the running median
  /// of 31 of them: what the machine does to as many frames as the gate asks for.
  double fixedSpread = 0.0;
  double tolerance = 0.0;        ///< kGateTolerance + fixedSpread, kMostTolerance at the most
  std::size_t judged = 0;        ///< frames without those that settle
  double withinFive = 0.0;       ///< share of the judged frames within kGateTolerance of the target
  double withinTolerance = 0.0;  ///< the same with the spread: what the gate asks for
  double fixedWithin = 0.0;      ///< of the fixed r, around its own running median
  std::optional<bool> met;       ///< the gate; none without judged frames
  double over102 = 0.0;          ///< share of the judged frames over 1.02 T
  double over110 = 0.0;          ///< over 1.1 T
  std::size_t longestOver = 0;   ///< frames in a row over 1.02 T, anywhere
  double p50Ms = 0.0;            ///< of the judged frames
  double p95Ms = 0.0;
  double p99Ms = 0.0;
  double biasMs = 0.0;     ///< their mean - T
  double sigmaMs = 0.0;    ///< their standard deviation
  double changes = 0.0;    ///< of r, a hundred frames
  double reversals = 0.0;  ///< of its direction, a hundred frames
};

/// Frames count as within where they lie around the target, or around the time at r = 1 where full
/// rate fits, or where they are drawn at full rate and are in time. A target out of reach is not
/// held.
/// @throws std::invalid_argument for no frames
[[nodiscard]] HoldMeasures measureHold(const HoldRun& run);

/// K and C from frames of one load, and the r that follows.
[[nodiscard]] ResizeModel modelOf(std::span<const HeldFrame> frames, double targetMs,
                                  double mostResize);

/// "held", "held in part", "not held" or "not judged": held is what every judged part held.
[[nodiscard]] std::string verdictOf(const HoldMeasures& measures);

}  // namespace macula::control
