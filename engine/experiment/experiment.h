// An experiment as its TOML file states it: which variants are measured on which scenes, and what
// the results are held against.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/measure/flip.h"
#include "engine/settings/toml.h"

namespace macula::experiment {

/// Rounds that are drawn before the measured ones.
inline constexpr int kWarmUpRounds = 3;
/// Bytes of one stored fragment by which a share is turned into bytes: those of the exact methods.
inline constexpr double kBytesPerFragment = 16.0;
/// The value of scene.lighting that leaves a scene as it is.
inline constexpr const char* kOwnLight = "own";

/// What a variant with a budget may store.
struct Budget {
  enum class Kind : std::uint8_t {
    KAve,   ///< fragments a sample on average: oit.kAve
    MiB,    ///< oit.memoryMiB
    Share,  ///< of the bytes of all fragments of the scene; becomes oit.memoryMiB
  };
  Kind kind = Kind::KAve;
  double value = 0.0;               ///< > 0
  std::vector<std::string> scenes;  ///< it applies to; empty: all of the study

  [[nodiscard]] bool appliesTo(const std::string& scene) const;
  /// "k_ave 2", "35 MiB", "share 0.3": how results and targets name it.
  [[nodiscard]] std::string label() const;
  /// Bytes it stands for. @param samples of the image @param generated fragments of the scene
  [[nodiscard]] double bytes(std::uint64_t samples, std::uint64_t generated) const;
};

/// What an image is drawn with. An oracle draws nothing: it chooses k from all fragments, and says
/// what the best choice would reach.
enum class Oracle : std::uint8_t { None, OptimalK, LeastRmse, LeastRmseTail };
[[nodiscard]] std::string_view nameOf(Oracle oracle);

/// One setting at several values: a variant that has a sweep is a curve, one point a value.
struct Sweep {
  std::string setting;         ///< key or short name of a number
  std::vector<double> values;  ///< finite, each once, in the file's order
  std::string place;           ///< "file:line", for messages

  /// "r=2": the setting's name after its last dot, and the value.
  [[nodiscard]] std::string label(double value) const;
  [[nodiscard]] bool holds(double value) const;
};

/// One way to draw.
struct Variant {
  std::string id;
  std::string label;                      ///< for people; the id where none was given
  const toml::table* settings = nullptr;  ///< in Experiment::document; may be null
  Oracle oracle = Oracle::None;
  bool budgets = false;        ///< measured once at each budget of the study
  std::optional<Sweep> sweep;  ///< measured once at each of its values; not beside budgets
  std::string place;           ///< "file:line", for messages

  /// For people: the label, and at which value of the sweep.
  [[nodiscard]] std::string labelAt(const std::optional<double>& value) const;
};

struct Size {
  int width = 0;
  int height = 0;
  bool operator==(const Size&) const = default;
};

/// A part of an experiment: some variants on some scenes. What it does not say, the experiment's
/// top level says.
struct Study {
  std::string id;
  std::string title;
  std::vector<std::string> scenes;          ///< the optional ones last
  std::vector<std::string> optionalScenes;  ///< of these, files that need not be there
  std::vector<Size> sizes;
  std::vector<std::int64_t> seeds;
  std::vector<std::string> lights;    ///< values of scene.lighting
  std::vector<std::string> variants;  ///< ids
  std::vector<Budget> budgets;
  /// Variants whose frames are interleaved; see expand(). Complete: every variant stands in one
  /// list.
  std::vector<std::vector<std::string>> compare;
  bool comparesByList = false;  ///< the experiment names the lists
  std::string camera = "auto";
  std::string gaze = "center";
  /// The variant that speed-ups are over; empty: none. It is interleaved with every swept variant.
  std::string base;
  int frames = 9;  ///< measured rounds
  /// Drawn along the camera's path after the measured rounds, without times; 0: none.
  int pathFrames = 0;
  double pathFps = 15.0;  ///< of these, frames a second
  bool flipMaps = false;  ///< a FLIP map is kept beside every difference map
  /// Of the viewer who judges the images: for FLIP and its weights around the gaze.
  double pixelsPerDegree = measure::kDefaultPixelsPerDegree;
  /// Of all variants, in Experiment::document: the experiment's, then the study's.
  std::vector<const toml::table*> settings;
  std::string place;

  [[nodiscard]] bool isOptional(std::string_view scene) const;
};

/// What the results are held against.
struct Target {
  enum class Kind : std::uint8_t {
    Ratio,  ///< metric of one variant over the least of others
    Order,  ///< metric falls strictly along a list of variants
    Value,  ///< metric of one variant
    Curve,  ///< metric of one swept variant minus that of another at equal speed-up
    Mean,   ///< the mean of a ratio over scenes
  };
  /// How a number is held against the limit.
  enum class Bound : std::uint8_t { AtMost, AtLeast, Above };
  /// Which number of all differences between two curves.
  enum class Statistic : std::uint8_t { Least, Mean };
  std::string name;
  std::string papers;  ///< what the papers say; may be empty
  Kind kind = Kind::Value;
  std::string metric;                ///< see metricOf()
  std::string of;                    ///< variant (all but order)
  std::vector<std::string> against;  ///< variants (ratio, mean, order), one (curve)
  std::string againstMetric;         ///< that a ratio divides by; empty: metric
  std::optional<double> at;          ///< of a swept variant, only the point of this value
  std::optional<double> againstAt;   ///< the same of `against`; none: the value of `of`
  std::string cost = "ms.total";     ///< metric whose quotient is the speed-up (curve)
  Statistic statistic = Statistic::Least;
  Bound bound = Bound::AtMost;
  double limit = 0.0;                ///< unused by order
  bool unlessAllStored = false;      ///< not where the budget could hold every fragment
  std::vector<std::string> studies;  ///< empty: any; likewise below
  std::vector<std::string> scenes;
  std::vector<std::string> lights;
  std::vector<std::string> budgets;  ///< labels

  /// Whether a number is within the limit.
  [[nodiscard]] bool admits(double value) const;
  /// Whether a metric of one variant is divided by that of others.
  [[nodiscard]] bool divides() const { return kind == Kind::Ratio || kind == Kind::Mean; }
  [[nodiscard]] std::string limitText() const;
};

struct Experiment {
  std::string title;
  std::string description;
  std::string name;  ///< of the file, for messages
  std::string text;  ///< the file
  /// The parsed file: settings stay in it, because a copied table forgets its lines.
  std::shared_ptr<const toml::table> document;
  double differenceScale = 0.0;  ///< of the difference maps; 0: each by its 99th percentile
  int reportPixels = 512;        ///< longest side of the report's pictures
  std::vector<Variant> variants;
  std::vector<Study> studies;
  std::vector<Target> targets;

  [[nodiscard]] const Variant& variant(std::string_view id) const;
  [[nodiscard]] const Study& study(std::string_view id) const;
};

/// Parses an experiment file; the tables of its keys are in README.md of this folder.
/// @param name what to call the text in messages, usually its path
/// @throws InputError "name:line: ..." for a key that is not known (naming the nearest), a wrong
///   type, a name that nothing bears, and a study without work. Settings are checked where they
///   are applied.
[[nodiscard]] Experiment parseExperiment(const std::string& text, const std::string& name);

}  // namespace macula::experiment
