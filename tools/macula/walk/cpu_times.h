// How long the CPU worked on each of the last frames, for GPU times that arrive some frames later.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace macula::tools {

/// Milliseconds that the calling thread has run so far. While it waits, for the GPU or for anything
/// else, none pass.
[[nodiscard]] double threadMs();

/// One frame's share of the CPU's time.
struct CpuTimes {
  std::uint64_t frame = 0;  ///< FrameResult::frame
  double cpuMs = 0.0;       ///< of the thread that draws
  double othersMs = 0.0;    ///< of the second method, which is no time of the first
  double intervalMs = 0.0;  ///< until the next frame began; 0 before that is known
};

/// The last of them.
class CpuHistory {
 public:
  void add(const CpuTimes& times) { all_[times.frame % kFrames] = times; }
  /// The frame that was added last has ended.
  void end(std::uint64_t frame, double intervalMs) {
    if (find(frame)) all_[frame % kFrames].intervalMs = intervalMs;
  }
  [[nodiscard]] std::optional<CpuTimes> find(std::uint64_t frame) const {
    const CpuTimes& times = all_[frame % kFrames];
    if (times.frame != frame) return {};
    return times;
  }

 private:
  static constexpr std::size_t kFrames = 16;  ///< more than any GPU is behind by
  static constexpr std::uint64_t kNone = ~std::uint64_t{0};
  static constexpr std::array<CpuTimes, kFrames> empty() {
    std::array<CpuTimes, kFrames> all{};
    for (CpuTimes& times : all) times.frame = kNone;
    return all;
  }
  std::array<CpuTimes, kFrames> all_ = empty();
};

}  // namespace macula::tools
