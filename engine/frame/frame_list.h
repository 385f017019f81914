// The frame: an ordered list of passes, validated, allocated once, run with barriers and times.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/frame/barriers.h"
#include "engine/frame/frame_inputs.h"
#include "engine/frame/frame_resources.h"
#include "engine/frame/pass.h"
#include "engine/frame/validate.h"
#include "engine/gl/program.h"
#include "engine/gl/timer.h"

namespace macula::frame {

/// The time of one pass of the last frame.
struct PassTime {
  std::string_view name;
  double ms = 0.0;
};

/// Whether a pass runs, and why; for `macula scene info`.
struct PassReport {
  std::string_view name;
  bool runs = false;
  std::string reason;
};

class FrameList {
 public:
  /// @param results resources that leave the frame
  FrameList(std::vector<std::unique_ptr<Pass>> passes, std::vector<Resource> results);

  /// @returns problems, one line each; see validate(). No GL.
  [[nodiscard]] std::vector<std::string> validate() const;
  /// Which passes run for these inputs, and why. No GL.
  [[nodiscard]] std::vector<PassReport> report(const FrameInputs& inputs) const;
  /// What the passes that have work touch. No GL.
  [[nodiscard]] std::vector<Resource> neededResources(const FrameInputs& inputs) const;

  /// Looks again at declarations and work: after a change of scene, settings or size. The only
  /// place where the frame allocates.
  void prepare(const FrameInputs& inputs, FrameResources& resources, gl::ProgramCache& programs,
               std::int64_t maxStorageBlockBytes);
  /// Runs the passes that have work. Allocates nothing after the first frame.
  void run(PassContext& context, gl::FrameTimer& timer);
  /// Times of the passes that ran last, in order. Valid after run().
  [[nodiscard]] std::span<const PassTime> times() const { return times_; }

 private:
  struct Entry {
    std::unique_ptr<Pass> pass;
    std::vector<Touch> touches;
    bool runs = false;
  };
  void clearUnwritten(const Entry& entry, FrameResources& resources);

  std::vector<Entry> entries_;
  std::vector<Resource> results_;
  std::vector<PassTime> times_;
  BarrierTracker barriers_;
  /// Per resource: written by a pass since its last clear.
  std::array<bool, kResourceCount> dirty_{};
  /// Per resource: written by a pass of the frame that runs now.
  std::array<bool, kResourceCount> written_{};
};

}  // namespace macula::frame
