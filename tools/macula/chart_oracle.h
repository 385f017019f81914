// The place where an experiment asks an oracle: what would the best choice of k have reached?
#pragma once

#include <cstdint>
#include <optional>

#include "chart_contender.h"

namespace macula::tools {

/// What an oracle chose for a budget.
struct OracleAnswer {
  image::ImageF display;  ///< the image by its choice: encoded display values 0..1, RGB
  std::uint64_t stored = 0;
  std::uint64_t merged = 0;  ///< in a tail
  std::uint64_t lost = 0;
  std::uint32_t kMin = 0;  ///< over the covered pixels
  std::uint32_t kMax = 0;
  double kMean = 0.0;
};

/// Chooses k per pixel from all fragments of the scene.
/// @param reference has just drawn the exact frame (ab-sbuffer): its buffers hold every fragment
/// @param slots fragments that the budget holds
/// @throws InputError where this build has no oracles; the point then says so
[[nodiscard]] OracleAnswer askOracle(experiment::Oracle oracle, const Contender& reference,
                                     const Stage& stage, std::uint64_t slots);

}  // namespace macula::tools
