// What would the best choice of k have reached? Asked of the oracles of engine/measure.
#pragma once

#include <cstdint>
#include <memory>

#include "chart_contender.h"
#include "engine/measure/frame_record.h"

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

/// The metrics of an answer: bytes, fragments and k; no times.
/// @param bytes of the budget
[[nodiscard]] measure::FrameRecord recordOf(const OracleAnswer& answer, std::uint64_t bytes);

/// All fragments of a group's frame, and the oracles that choose from them.
class Oracles {
 public:
  /// @param exact has just drawn the exact frame
  /// @throws InputError where this build has no oracles, or the frame was not exact
  Oracles(const Contender& exact, const Stage& stage);
  ~Oracles();
  Oracles(const Oracles&) = delete;
  Oracles& operator=(const Oracles&) = delete;

  /// @param slots fragments that the budget holds
  [[nodiscard]] OracleAnswer ask(experiment::Oracle oracle, std::uint64_t slots) const;

 private:
  struct Fragments;
  std::unique_ptr<Fragments> fragments_;
};

}  // namespace macula::tools
