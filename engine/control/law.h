// A control law: times of past frames in, the resize factor of the next frame out. No GL, no clock.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace macula::control {

/// Range of the resize factor r: the width of the full buffer over that of the resized one.
inline constexpr double kLeastResize = 1.0;
inline constexpr double kMostResize = 8.0;

/// The headroom below the target is no more than what is missing to 1: times that spread by 5 % and
/// more would else cost more pixels than their late frames are worth, and lie outside of +-5 %.
inline constexpr double kLeastAim = 0.96;

/// What is known of a frame that has been drawn.
struct FrameTimes {
  std::uint64_t frame = 0;  ///< its index
  double resize = 1.0;      ///< r that it was drawn with
  double totalMs = 0.0;     ///< of the GPU, all passes; 0 or less where no time came
  /// Of the passes whose work follows 1 / r^2; nothing where passes are not timed apart.
  std::optional<double> resizableMs;
  /// That the CPU worked on the frame, without waiting for the GPU; nothing where it is not
  /// measured.
  std::optional<double> cpuMs;
  /// From the last swap to this one; nothing without a window.
  std::optional<double> intervalMs;
  /// The CPU works on the next frame while the GPU draws this one: their times do not add up.
  bool overlapped = false;
};

/// Why a law does nothing at present.
enum class Trouble {
  None,
  NoTimes,      ///< none have come for some time
  NoEffect,     ///< times do not follow r: the clock measures something else; it stays so
  CpuBound,     ///< the CPU alone needs longer than the target
  Unreachable,  ///< r is at its end, and the time still over the target
};

/// The least multiple of `step` that is not below r; r itself where the step is 0. The one below
/// would be late in every frame.
[[nodiscard]] double inSteps(double resize, double step);

/// One line; empty for Trouble::None.
[[nodiscard]] std::string noticeOf(Trouble trouble);

/// Chooses the resize factor frame by frame. Each frame asks once, with the times that arrived
/// since the last question: usually those of one frame some frames ago, at times of none or of
/// several.
class Law {
 public:
  Law() = default;
  Law(const Law&) = delete;
  Law& operator=(const Law&) = delete;
  virtual ~Law() = default;

  /// @param newest the latest frame whose times have arrived since the last call; null for none
  /// @param resize r of the frame before, as it was really used
  /// @returns r for the next frame, kLeastResize to kMostResize
  [[nodiscard]] virtual double next(const FrameTimes* newest, double resize) = 0;

  /// The image has another size: costs are to be thought of as `ratio` times what they were.
  /// @param ratio of the pixel numbers, after over before; > 0
  /// @returns false where the law cannot, and has to be made again
  virtual bool scalePixels(double ratio) {
    static_cast<void>(ratio);
    return false;
  }

  /// Whether it follows the times at all.
  [[nodiscard]] virtual bool holdsTarget() const { return true; }
  [[nodiscard]] virtual Trouble trouble() const { return Trouble::None; }
  /// One line on why the law does nothing at present; empty where it works.
  [[nodiscard]] std::string notice() const { return noticeOf(trouble()); }
};

/// What every law is made from.
struct LawOptions {
  double targetMs = 1000.0 / 60.0;  ///< > 0
  /// K' of Yang 2008, Eq. 3: ms of the resizable work at r = 1, "experimentally determined using a
  /// scene with the expected workload". Used by yang2008 alone.
  double expectedWorkMs = 20.0;
  double fixedResize = 1.0;         ///< of the law `fixed`
  double resizeStep = 0.0;          ///< r comes in multiples of it; 0: as it is
  double mostResize = kMostResize;  ///< r never goes beyond
  /// Share of the target that `macula` aims at, at the least, however far times spread.
  double leastAim = kLeastAim;
};

/// The names that makeLaw() knows: fixed, yang2008, macula, and the laws of others for comparison.
[[nodiscard]] std::vector<std::string> lawNames();

/// @throws InputError naming the nearest for an unknown name
[[nodiscard]] std::unique_ptr<Law> makeLaw(std::string_view name, const LawOptions& options);

}  // namespace macula::control
