// What a renderer tells about a frame.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "engine/frame/frame_list.h"
#include "passes/oit/statistics/statistics.h"

namespace macula::passes {

/// Opaque pixels of one frame, and how many were really shaded.
struct ShadingCounts {
  std::uint64_t pixels = 0;  ///< of the image, in samples
  std::uint64_t shaded = 0;  ///< samples of what lod.what names, holes among them
  std::uint64_t holes = 0;   ///< reconstruction failures: pixels that no low-rate sample fits
};

/// What is asked for beside the image.
struct Wanted {
  bool times = true;  ///< of the passes; with glFinish as the clock, they then cannot overlap
  /// FrameResult::fragments to exact. Where a method counts none while it draws, they cost a pass
  /// over the geometry.
  bool statistics = true;
};

struct FrameResult {
  std::uint64_t frame = 0;  ///< RendererSteps::frames before it was drawn
  bool timed = false;       ///< totalMs, resizableMs and passes are known
  double totalMs = 0.0;     ///< of the GPU, from the begin of the first pass to the end of the last
  double resizeFactor = 1.0;  ///< r in use
  double resizableMs = 0.0;   ///< of the passes whose work follows, or would follow, 1 / r^2
  ShadingCounts shading;
  std::span<const frame::PassTime> passes;  ///< until the next result
  bool counted = false;                     ///< what follows, up to exact, is known
  std::optional<FragmentCounts> fragments;  ///< none where the method does not count
  std::optional<LayerStatistics> layers;
  std::uint32_t deepest = 0;    ///< largest number of fragments in a sample
  std::uint64_t tailSlots = 0;  ///< slots that hold tails
  bool exact = false;  ///< every transparent fragment reached the image in its place, at full rate
  std::uint32_t lockFailures = 0;
  int recaptures = 0;  ///< times the frame was drawn again with a larger pool
  /// Frames, this one among them, that the renderer left as they were although their pool was too
  /// small: fragments are missing from them. Later frames have a larger one.
  std::uint64_t overflows = 0;
};

/// How often each thing was done to a renderer. Two renderers to which the same was done between
/// the same frames draw the same bits, so a recording of every step of these is complete.
struct RendererSteps {
  std::uint64_t frames = 0;    ///< drawn to the end
  std::uint64_t resets = 0;    ///< history was given up: a new size, changed settings
  std::uint64_t scenes = 0;    ///< a scene was set, or its transparent surfaces shown or hidden
  std::uint64_t restarts = 0;  ///< everything that earlier frames left behind was given up
};

}  // namespace macula::passes
