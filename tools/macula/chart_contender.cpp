#include "chart_contender.h"

#include "engine/measure/error_maps.h"
#include "engine/measure/image_error.h"
#include "frame_record.h"

namespace macula::tools {

using experiment::Point;

Contender::Contender(std::unique_ptr<VariantSettings> settings, const Stage& stage)
    : settings_(std::move(settings)), stage_(stage), renderer_(settings_->render, stage.device) {
  renderer_.resize(stage.size);
  renderer_.setScene(stage.gpu);
}

void Contender::draw(bool measured) {
  result_ = renderer_.render(stage_.camera, stage_.gaze);
  if (measured) rounds_.push_back(recordOf(renderer_, result_));
}

void Contender::drawFrom(const recording::Frame& frame) {
  // The place alone counts, as in the measured rounds: a chart is of methods, not of trackers.
  result_ = renderer_.render(frame.camera, frame.gaze.position, frame.cut);
}

image::Image8 Contender::shown() const {
  image::Image8 image{stage_.size.x, stage_.size.y, 3, {}};
  renderer_.readDisplay(image.pixels);
  return image;
}

image::ImageF Contender::display() const {
  image::ImageF linear{stage_.size.x, stage_.size.y, 3, {}, true};
  renderer_.readLinear(linear.pixels);
  return measure::toDisplay(linear);
}

void Contender::describe(Point& point) const {
  const passes::OitPlan& plan = renderer_.plan();
  point["sync"] = plan.sorted() ? Point(passes::nameOf(plan.sync)) : Point(nullptr);
  experiment::addRounds(point, rounds_);
  point["bytes"]["buffers"] = Point::object();
  for (const auto& [name, bytes] : transparencyBytes(renderer_)) {
    point["bytes"]["buffers"][name] = bytes;
  }
  point["settings"] = settings_->registry.toJson();
}

void describeImage(Point& point, const image::Image8& picture, const image::ImageF& display,
                   const Reference& reference, double scale, const std::filesystem::path& folder,
                   const std::string& stem) {
  const std::string image = "images/" + stem + ".png";
  image::writePng(folder / image, picture);
  point["images"] = {{"image", image}};
  if (reference.file.empty()) {
    point["error"] = nullptr;
    return;
  }
  const std::string difference = "images/" + stem + "_difference.png";
  const measure::DifferenceMap map = measure::differenceMap(
      reference.display, display, scale > 0.0 ? std::optional<double>(scale) : std::nullopt);
  image::writePng(folder / difference, map.image);
  point["difference_white"] = map.white;
  point["images"]["difference"] = difference;
  point["images"]["reference"] = reference.file;
  measure::CompareOptions viewer;
  viewer.pixelsPerDegree = reference.pixelsPerDegree;
  viewer.gaze = reference.gaze;
  const measure::Comparison compared = measure::compareWithMap(reference.display, display, viewer);
  measure::FrameRecord errors;
  measure::setError(errors, compared.error);
  measure::addTo(point, errors, measure::kPoint, measure::None::Omit);
  if (!reference.flipMaps || !compared.flipMap) return;
  const std::string flip = "images/" + stem + "_flip.png";
  image::writePng(folder / flip, measure::flipImage(*compared.flipMap));
  point["images"]["flip"] = flip;
}

}  // namespace macula::tools
