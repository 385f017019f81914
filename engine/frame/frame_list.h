// The frame: an ordered list of passes, validated, allocated once, run with barriers and times.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/frame/barriers.h"
#include "engine/frame/binding_check.h"
#include "engine/frame/device_needs.h"
#include "engine/frame/frame_inputs.h"
#include "engine/frame/frame_resources.h"
#include "engine/frame/pass.h"
#include "engine/frame/validate.h"
#include "engine/gl/program.h"
#include "engine/gl/timer.h"

namespace macula::frame {

/// The time of one pass of a frame.
struct PassTime {
  std::string_view name;
  double ms = 0.0;
};

/// Whether a pass runs, and why; for `macula scene info`.
struct PassReport {
  std::string name;
  bool runs = false;
  std::string reason;
};

/// What FrameList::prepare() keeps to.
struct AllocationRules {
  gl::Limits limits;  ///< a buffer larger than a storage block is refused with an InputError
  bool shareMemory =
      true;  ///< else every resource can be read after the frame, at a price in bytes
};

class FrameList {
 public:
  /// @param results resources that leave the frame · @param readAfterwards others whose contents
  /// stay until the next frame, although no pass of it reads them · @param reportPasses passes that
  /// measure a finished frame, see runReport()
  FrameList(std::vector<std::unique_ptr<Pass>> passes, std::vector<const Resource*> results,
            std::vector<const Resource*> readAfterwards = {},
            std::vector<std::unique_ptr<Pass>> reportPasses = {});

  /// @returns problems of what runs for these inputs, one line each; see validate(). No GL.
  [[nodiscard]] std::vector<std::string> validate(const FrameInputs& inputs) const;
  /// Which timed passes run for these inputs, and why. No GL.
  [[nodiscard]] std::vector<PassReport> report(const FrameInputs& inputs) const;
  /// What the passes that have work access. No GL.
  [[nodiscard]] std::vector<const Resource*> neededResources(const FrameInputs& inputs) const;

  /// The first thing that a pass with work needs and a device does not offer. No GL.
  [[nodiscard]] std::optional<Shortage> shortage(const FrameInputs& inputs,
                                                 const gl::Limits& limits) const;

  /// Looks again at tables and work: after a change of scene, settings or size. The only place
  /// where the frame allocates. In debug contexts, reports what differs between tables and shaders.
  void prepare(const FrameInputs& inputs, FrameResources& resources, gl::ProgramCache& programs,
               const AllocationRules& rules);
  /// Runs the timed passes that have work. Allocates nothing after the first frame.
  /// @param timer its frame has begun, and gets a mark behind each pass; null: passes are not timed
  void run(PassContext& context, gl::FrameTimer* timer);
  /// Runs those of the report's passes that have work. After run(); their time is not the frame's.
  void runReport(PassContext& context);
  /// Names of the passes that ran last, in order. They stay as long as the list.
  [[nodiscard]] std::span<const std::string_view> ran() const { return ran_; }
  /// For readers of a finished frame, who report their accesses there.
  [[nodiscard]] BarrierTracker& barriers() { return barriers_; }
  /// What the last prepare() compared; nothing outside of debug contexts.
  [[nodiscard]] const BindingCount& compared() const { return compared_; }

 private:
  struct Entry {
    std::unique_ptr<Pass> pass;
    PassDeclaration table;
    std::vector<std::uint32_t> slots;  ///< of the table's rows
    std::vector<GLuint> programs;      ///< that prepare() asked for
    bool runs = false;
  };
  [[nodiscard]] std::vector<Demand> demands(const FrameInputs& inputs, bool shareMemory) const;
  void checkBindings();
  static void checkNeeds(const Entry& entry);
  [[nodiscard]] std::span<Entry> framePasses() { return std::span(entries_).first(framePasses_); }
  void runPass(Entry& entry, PassContext& context);
  void refresh(Entry& entry, const PassContext& context);
  void clearUnwritten(const Entry& entry, const FrameResources& resources);

  std::vector<Entry> entries_;   ///< of the frame, then of the report
  std::size_t framePasses_ = 0;  ///< entries of the frame
  std::vector<const Resource*> results_;
  std::vector<const Resource*> readAfterwards_;
  std::vector<std::string_view> ran_;
  BarrierTracker barriers_;
  BindingCount compared_;
  std::vector<bool> dirty_;    ///< by slot: its memory was written since its last clear
  std::vector<bool> written_;  ///< by slot: a pass of the present frame has written it
};

}  // namespace macula::frame
