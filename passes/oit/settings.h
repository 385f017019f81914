// Settings of transparency, as a user means them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace macula::passes {

/// The core of a pixel are the fragments that get slots of their own, the tail are all others
/// behind them (hybrid transparency, Maule et al. 2013).
enum class Tail : std::uint8_t {
  None,  ///< the tail is lost
  Mean,  ///< one layer behind the core: mean colour by optical depth, exact transmittance
};

/// What the number of layers of a pixel of kb-variable follows.
enum class Predictor : std::uint8_t {
  Published,      ///< the importance map of Vasilakis 2017, Eq. 3-6
  Transmittance,  ///< a slot's utility is the transmittance of the slots before it
  Error,          ///< a slot's utility is how much it lowers the predicted error of the image
  Learned,        ///< the same, the prediction corrected by a network
};

enum class Cull : std::uint8_t {
  None,
  Occupancy,  ///< early depth rejection behind the k-th occupied interval (Vasilakis 2015)
};

/// Where the number of fragments of a pixel comes from.
enum class CountSource : std::uint8_t {
  Drawn,      ///< a geometry pass before the capture
  Predicted,  ///< the last frame's capture, reprojected; the first frame and cuts draw
};

struct OitSettings {
  std::string method = "kb-variable";
  double kAve = 4.0;       ///< slots per sample on average, > 0
  double memoryMiB = 0.0;  ///< 0: by kAve
  std::string sync = "auto";
  int layers = 8;  ///< slots a pixel of ab-array, passes of peel
  bool fill = false;
  Tail tail = Tail::None;
  Predictor importance = Predictor::Published;
  Cull cull = Cull::None;
  int cullWords = 32;      ///< d of Vasilakis 2015: 32 d intervals a pixel
  int fragmentBytes = 16;  ///< of a stored fragment of a sorted k-buffer: 16 or 8
  CountSource count = CountSource::Drawn;
  std::filesystem::path network = {};  ///< weights; empty: those that come with Macula
};

/// Settings of the importance map (Vasilakis 2017, Eq. 3-6) and of the predictors.
struct ImportanceSettings {
  double rangeBias = 0.35;     ///< alpha of Eq. 3
  double periphery = 3.0;      ///< d of Eq. 4
  double noise = 0.1;          ///< lambda of Eq. 6
  double layerLimit = 0.0;     ///< N_limit of Eq. 3; 0: the largest count seen so far
  bool noisePerFrame = false;  ///< a new xi every frame
  int slices = 4;              ///< depth slices a predictor sums; a network has its own
  int tile = 1;                ///< samples a side that share their slices
  int networkTile = 4;         ///< samples a side for which a network is evaluated once
  double gazeWeight = 0.0;     ///< 0: errors count alike everywhere; 1: by I_per of Eq. 4
};

/// @throws InputError where options contradict one another or the method, with the reason
void checkCombination(const OitSettings& settings);

}  // namespace macula::passes
