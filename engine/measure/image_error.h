// How far an image is from its reference.
#pragma once

#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "engine/image/image.h"
#include "engine/measure/flip.h"

namespace macula::measure {

/// Errors over the R, G and B of all pixels; alpha is left out.
struct ImageError {
  double rmse = 0.0;             ///< root of the mean squared difference
  std::optional<double> psnrDb;  ///< 10 log10(1 / mean square), peak 1.0; none for identical images
  double max = 0.0;              ///< largest absolute difference of one channel
  std::optional<double> flip;    ///< mean FLIP, 0..1, HDR-FLIP of linear values; none where it was
                                 ///< not asked for
  std::optional<double> flipGaze;  ///< the same map weighted by acuity; none without a gaze
};

struct CompareOptions {
  /// Compares linear values. The peak of the PSNR stays 1.0, whatever the images hold, so that
  /// numbers of different scenes share one scale; FLIP is HDR-FLIP, one FLIP for every stop between
  /// the reference's median and its maximum.
  bool hdr = false;
  bool flip = true;                                  ///< FLIP costs most of the time
  double pixelsPerDegree = kDefaultPixelsPerDegree;  ///< of FLIP
  std::optional<glm::dvec2> gaze = {};               ///< 0..1 from the top left; asks for flipGaze
};

/// Numbers, and the map that the two FLIP means are of.
struct Comparison {
  ImageError error;
  std::optional<Plane> flipMap;  ///< none where FLIP was not asked for
};

/// Compares values as they stand: display values 0..1, or linear ones with options.hdr. Grey images
/// count as three equal channels. Sums run in double, in pixel order, so that they repeat exactly.
/// @throws InputError where sizes differ or a value is not finite.
[[nodiscard]] Comparison compareWithMap(const image::ImageF& reference, const image::ImageF& test,
                                        const CompareOptions& options = {});

/// compareWithMap() without the map.
[[nodiscard]] ImageError compareImages(const image::ImageF& reference, const image::ImageF& test,
                                       const CompareOptions& options = {});

/// Clamps linear R, G, B to 0..1 and encodes them as sRGB; alpha stays. NaN stays NaN, so that
/// compareImages() can refuse it.
[[nodiscard]] image::ImageF toDisplay(const image::ImageF& linear);

/// {"rmse", "psnr_db", "max", "flip"}, null for what does not apply, and "flip_gaze" where there is
/// one.
[[nodiscard]] nlohmann::json toJson(const ImageError& error);

}  // namespace macula::measure
