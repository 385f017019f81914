// What a frame did with its transparent fragments, for the report.
#pragma once

#include <cstdint>
#include <optional>

#include "passes/oit/plan.h"
#include "shared/oit_totals.h"

namespace macula::passes {

/// Fragments of one frame, at the rate at which transparency is drawn. generated = stored + merged
/// + lost.
struct FragmentCounts {
  std::uint64_t generated = 0;  ///< pass opaque depth, and alpha exceeds LEAST_ALPHA
  std::uint64_t stored = 0;
  std::uint64_t merged = 0;  ///< in a tail
  std::uint64_t lost = 0;
};

/// Layers over the covered samples; none where nothing is covered or nothing is stored.
struct LayerStatistics {
  std::uint32_t min = 0;
  std::uint32_t max = 0;
  double mean = 0.0;
};

struct FragmentReport {
  std::optional<FragmentCounts> fragments;  ///< none where the method does not count
  std::optional<LayerStatistics> layers;
  std::uint32_t deepest = 0;        ///< largest number of fragments in a sample
  std::uint32_t largestLayers = 0;  ///< largest k(p)
  std::uint64_t tailSlots = 0;      ///< slots that hold tails
  bool exact = false;  ///< every transparent fragment reached the image in its place, at full rate
};

/// What follows for the plan's method from the sums of makeStatisticsPass() and of the frame.
[[nodiscard]] FragmentReport reportOf(const OitPlan& plan, const shader::OitStatistics& statistics,
                                      const shader::OitTotals& totals,
                                      const gl::Capabilities& device);

}  // namespace macula::passes
