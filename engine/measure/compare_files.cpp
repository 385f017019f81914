#include "engine/measure/compare_files.h"

#include <utility>

#include "engine/core/error.h"

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

}  // namespace

ImageError compareFiles(const std::filesystem::path& reference, const std::filesystem::path& test,
                        const CompareOptions& options) {
  const image::ImageF wanted = load(reference, options.hdr);
  const image::ImageF got = load(test, options.hdr);
  try {
    return compareImages(wanted, got, options);
  } catch (const InputError& error) {
    failInput("{} and {}: {}", reference.string(), test.string(), error.what());
  }
}

}  // namespace macula::measure
