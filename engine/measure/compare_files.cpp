#include "engine/measure/compare_files.h"

#include <utility>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/measure/error_maps.h"

namespace macula::measure {
namespace {

image::ImageF load(const std::filesystem::path& path, bool hdr) {
  image::ImageF image = image::readImage(path);
  if (hdr && !image.linear) {
    failInput("{}: holds display values, which --hdr cannot compare; give EXR or leave --hdr out",
              path.string());
  }
  return image.linear && !hdr ? toDisplay(image) : std::move(image);
}

/// Two images, loaded, and how they compare.
struct Loaded {
  image::ImageF reference;
  image::ImageF test;
  Comparison comparison;
};

Loaded compareLoaded(const std::filesystem::path& reference, const std::filesystem::path& test,
                     const CompareOptions& options) {
  Loaded loaded{load(reference, options.hdr), load(test, options.hdr), {}};
  try {
    loaded.comparison = compareWithMap(loaded.reference, loaded.test, options);
  } catch (const InputError& error) {
    failInput("{} and {}: {}", reference.string(), test.string(), error.what());
  }
  return loaded;
}

}  // namespace

ImageError compareFiles(const std::filesystem::path& reference, const std::filesystem::path& test,
                        const CompareOptions& options) {
  return compareLoaded(reference, test, options).comparison.error;
}

std::pair<ImageError, MapFiles> compareFilesToMaps(const std::filesystem::path& reference,
                                                   const std::filesystem::path& test,
                                                   const std::string& prefix,
                                                   const CompareOptions& options) {
  CompareOptions withFlip = options;
  withFlip.flip = true;
  const Loaded loaded = compareLoaded(reference, test, withFlip);
  const DifferenceMap difference = differenceMap(loaded.reference, loaded.test);
  MapFiles files{prefix + "_difference.png", difference.scale, difference.white,
                 prefix + "_flip.png", prefix + "_scale.svg"};
  image::writePng(files.difference, difference.image);
  image::writePng(files.flip, flipImage(loaded.comparison.flipMap.value()));
  writeFileAtomically(
      files.bars, colourBars(difference.white, options.hdr ? "linear" : "display values, 0 to 1"));
  return {loaded.comparison.error, files};
}

}  // namespace macula::measure
