#include "walk/error_check.h"

#include <fmt/format.h>

#include <utility>

#include "engine/measure/error_maps.h"
#include "walk/screen.h"

namespace macula::tools {
namespace {

image::ImageF toFloat(const image::Image8& image) {
  constexpr float kMost = 255.0F;
  image::ImageF result{image.width, image.height, image.channels, {}, false};
  result.pixels.reserve(image.pixels.size());
  for (const std::uint8_t value : image.pixels) {
    result.pixels.push_back(static_cast<float>(value) / kMost);
  }
  return result;
}

ErrorCheck::Result measurePair(const PicturePair& pair) {
  const image::ImageF reference = toFloat(pair.reference);
  const image::ImageF test = toFloat(pair.test);
  measure::Comparison comparison = measure::compareWithMap(reference, test);
  measure::DifferenceMap difference = measure::differenceMap(reference, test);
  ErrorCheck::Result result{.referenceName = pair.referenceName,
                            .testName = pair.testName,
                            .scene = pair.scene,
                            .frame = pair.frame,
                            .error = comparison.error,
                            .difference = std::move(difference.image),
                            .differenceScale = difference.scale,
                            .flip = {}};
  if (comparison.flipMap) result.flip = measure::flipImage(*comparison.flipMap);
  return result;
}

}  // namespace

const std::vector<std::string>& mapNames() {
  static const std::vector<std::string> names{"none", "difference", "flip"};
  return names;
}

void ErrorCheck::start(PicturePair pair) {
  show(Map::None);
  job_.start([pair = std::move(pair)] { return measurePair(pair); });
}

bool ErrorCheck::poll() {
  if (!job_.ready()) return false;
  result_ = job_.take();
  return true;
}

std::string ErrorCheck::title(std::string_view scene) const {
  if (!result_) return {};
  return fmt::format("{} against {}, at frame {}{}", result_->testName, result_->referenceName,
                     result_->frame, result_->scene == scene ? "" : " of " + result_->scene);
}

void ErrorCheck::show(Map map) {
  map_ = result_ ? map : Map::None;
  texture_ = {};
  if (map_ == Map::None) return;
  texture_ = textureOf(map_ == Map::Flip ? result_->flip : result_->difference);
}

const gl::Texture* ErrorCheck::texture() const {
  return map_ == Map::None ? nullptr : &texture_;
}

}  // namespace macula::tools
