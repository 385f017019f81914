// An experiment expanded to the points that it measures.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/experiment/experiment.h"

namespace macula::experiment {

/// What decides a result beside the experiment file.
struct Fingerprint {
  std::string program;                       ///< commit, program and shaders, machine
  std::map<std::string, std::string> files;  ///< hashes of scene, camera and gaze files, by name
};

/// One variant at one budget or at one value of its sweep.
struct PointPlan {
  std::size_t variant = 0;  ///< index into Experiment::variants
  std::optional<Budget> budget;
  std::optional<double> value;  ///< of the variant's sweep
  /// 16 hexadecimal digits: equal where, and only where, everything that decides the numbers is
  /// equal, the other variants of the batch among it, because ratios are taken within one.
  std::string key;
  std::string stem;  ///< of its image files: readable, and unique by the key
};

/// Renderers that live at the same time unless a study's `compare` asks for more: at 1024x1024
/// about 2 GiB.
inline constexpr std::size_t kMostTogether = 16;

/// Points whose frames are interleaved, or the oracles of a group (without time). Only times of one
/// batch may be divided by each other: whatever else the machine does falls on all of it alike.
struct Batch {
  bool oracles = false;
  std::vector<PointPlan> points;

  /// Names the batch in its points.
  [[nodiscard]] const std::string& key() const { return points.front().key; }
};

/// What shares a loaded scene and a reference.
struct Group {
  std::size_t study = 0;  ///< index into Experiment::studies
  std::string scene;
  Size size;
  std::int64_t seed = 0;
  std::string light;
  std::string stem;  ///< of the reference's image file
  std::vector<Batch> batches;
  bool optional = false;  ///< its scene is a file that need not be there

  /// "smoke 384x384", and what of seed and light is not the usual.
  [[nodiscard]] std::string label() const;
};

/// All variants of a `compare` list are interleaved at all budgets. Where a study has none, all of
/// its points are interleaved if they are at most kMostTogether, else those of each budget, and
/// variants without one are interleaved with the first budget. A sweep has no budgets, so a curve
/// is in one batch with all that it is compared with. Order from the slowest: studies, scenes,
/// lights, sizes, seeds.
[[nodiscard]] std::vector<Group> expand(const Experiment& experiment,
                                        const Fingerprint& fingerprint);

}  // namespace macula::experiment
