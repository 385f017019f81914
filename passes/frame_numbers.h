// Times and sums of frames, on their way from the GPU.
#pragma once

#include <array>
#include <cstdint>

#include "engine/frame/frame_resources.h"
#include "engine/gl/readback.h"
#include "engine/gl/timer.h"
#include "passes/frame_result.h"
#include "passes/oit/plan.h"
#include "shared/lod_totals.h"
#include "shared/oit_totals.h"

namespace macula::passes {

/// What the GPU summed over a frame; zero where no pass makes it.
struct FrameSums {
  shader::OitTotals totals;
  shader::LodTotals lod;
  shader::OitStatistics statistics;
};

/// What is known of a frame before its numbers arrive: they mean nothing without it.
struct IssuedFrame {
  std::uint64_t number = 0;  ///< RendererSteps::frames before it was drawn
  OitPlan plan;
  double resizeFactor = 1.0;
  ShadingCounts shading;  ///< without what LodTotals count
  bool countsShaded = false;
  bool countsHoles = false;
  bool transparent = false;  ///< the scene has transparent surfaces
  bool timed = false;
  bool statistics = false;  ///< OitStatistics were summed
  bool told = false;        ///< its result was given out
};

/// A ring of frames whose numbers are on their way. A frame takes a slot, marks its times there,
/// has its sums copied, and is looked at again later. While all slots are taken, frames go without.
class FrameNumbers {
 public:
  static constexpr std::size_t kSlots = gl::FrameTimer::kSlots;
  static constexpr std::size_t kNoSlot = ~std::size_t{0};

  explicit FrameNumbers(gl::TimeSource source);

  /// A slot for the next frame; kNoSlot where all are taken.
  [[nodiscard]] std::size_t take();
  /// Frees all slots: what is on its way is not wanted any more.
  void drop();
  void free(std::size_t slot) { taken_[slot] = false; }
  [[nodiscard]] IssuedFrame& frame(std::size_t slot) { return frames_[slot]; }
  [[nodiscard]] gl::FrameTimer& timer() { return timer_; }

  /// Copies the sums as the passes so far leave them.
  void copy(std::size_t slot, const frame::FrameResources& resources);
  /// Waits for what was copied, and for the times.
  void wait(std::size_t slot);
  /// The taken slot with the oldest frame, where its numbers are there; kNoSlot else. Never waits.
  [[nodiscard]] std::size_t ready();
  /// Valid once the slot is ready.
  [[nodiscard]] FrameSums sums(std::size_t slot) const;

 private:
  gl::FrameTimer timer_;
  gl::Readback sums_;
  std::array<IssuedFrame, kSlots> frames_;
  struct Copied {
    bool totals = false;
    bool lod = false;
    bool statistics = false;
  };
  std::array<Copied, kSlots> copied_;
  std::array<bool, kSlots> taken_{};
};

}  // namespace macula::passes
