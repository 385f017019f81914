#include "engine/measure/hazards.h"

#include <algorithm>
#include <stdexcept>

namespace macula::measure {

std::uint64_t countUnlikePixels(const image::Image8& a, const image::Image8& b) {
  if (a.width != b.width || a.height != b.height || a.channels != b.channels ||
      a.pixels.size() != b.pixels.size()) {
    throw std::invalid_argument("pixels are compared of images of one size");
  }
  std::uint64_t unlike = 0;
  for (auto left = a.pixels.begin(), right = b.pixels.begin(); left != a.pixels.end();) {
    unlike += std::equal(left, left + a.channels, right) ? 0U : 1U;
    left += a.channels;
    right += a.channels;
  }
  return unlike;
}

}  // namespace macula::measure
