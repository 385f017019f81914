// Two image files and how far they are apart.
#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "engine/measure/image_error.h"

namespace macula::measure {

/// Reads and compares two files on display values: PNG as stored, EXR and HDR clamped to 0..1 and
/// sRGB-encoded first; with options.hdr on linear values, for which a PNG is refused.
/// @throws InputError naming a file, see readImage() and compareImages().
[[nodiscard]] ImageError compareFiles(const std::filesystem::path& reference,
                                      const std::filesystem::path& test,
                                      const CompareOptions& options = {});

/// Where the maps of two files went.
struct MapFiles {
  std::filesystem::path difference;  ///< PREFIX_difference.png, see differenceMap()
  double differenceScale = 1.0;
  double differenceWhite = 0.0;  ///< 0: the images are equal
  std::filesystem::path flip;    ///< PREFIX_flip.png, see flipImage()
  std::filesystem::path bars;    ///< PREFIX_scale.svg, see colourBars()
};

/// compareFiles() that also writes maps.
/// @param prefix begins the paths of both files
/// @throws InputError also where they cannot be written
[[nodiscard]] std::pair<ImageError, MapFiles> compareFilesToMaps(
    const std::filesystem::path& reference, const std::filesystem::path& test,
    const std::string& prefix, const CompareOptions& options = {});

}  // namespace macula::measure
