// How far an image is from its reference.
#pragma once

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
  std::optional<double> flip;    ///< mean FLIP, 0..1; none where it was not asked for or is not
                                 ///< defined (linear values)
};

struct CompareOptions {
  /// Compares linear values. The peak of the PSNR stays 1.0, whatever the images hold, so that
  /// numbers of different scenes share one scale; FLIP is left out.
  bool hdr = false;
  bool flip = true;                                  ///< FLIP costs most of the time
  double pixelsPerDegree = kDefaultPixelsPerDegree;  ///< of FLIP
};

/// Compares values as they stand: display values 0..1, or linear ones with options.hdr. Grey images
/// count as three equal channels. Sums run in double, in pixel order, so that they repeat exactly.
/// @throws InputError where sizes differ or a value is not finite.
[[nodiscard]] ImageError compareImages(const image::ImageF& reference, const image::ImageF& test,
                                       const CompareOptions& options = {});

/// Clamps linear R, G, B to 0..1 and encodes them as sRGB; alpha stays. NaN stays NaN, so that
/// compareImages() can refuse it.
[[nodiscard]] image::ImageF toDisplay(const image::ImageF& linear);

/// {"rmse", "psnr_db", "max", "flip"}, null for what does not apply.
[[nodiscard]] nlohmann::json toJson(const ImageError& error);

}  // namespace macula::measure
