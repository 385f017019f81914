#include "chart_contender.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/measure/error_maps.h"
#include "engine/measure/image_error.h"

namespace macula::tools {
namespace {

using experiment::Point;

template <typename T>
Point orNull(const std::optional<T>& value) {
  return value ? Point(*value) : Point(nullptr);
}

}  // namespace

Contender::Contender(std::unique_ptr<VariantSettings> settings, const Stage& stage)
    : settings_(std::move(settings)), stage_(stage), renderer_(settings_->render, stage.machine) {
  renderer_.resize(stage.size);
  renderer_.setScene(stage.gpu);
}

void Contender::draw(bool measured) {
  result_ = renderer_.render(stage_.camera, stage_.gaze);
  if (!measured) return;
  totalMs_.push_back(result_.totalMs);
  double transparency = 0.0;
  double shading = 0.0;
  for (const frame::PassTime& pass : result_.passes) {
    auto known = std::find_if(passes_.begin(), passes_.end(),
                              [&](const PassSamples& p) { return p.name == pass.name; });
    if (known == passes_.end()) known = passes_.insert(known, {std::string(pass.name), {}});
    known->ms.push_back(pass.ms);
    if (pass.name.starts_with("oit.")) transparency += pass.ms;
    if (pass.name == "lighting" || pass.name.starts_with("lod.")) shading += pass.ms;
  }
  transparencyMs_.push_back(transparency);
  shadingMs_.push_back(shading);
}

void Contender::drawFrom(const scene::Camera& camera, glm::vec2 gaze, bool cut) {
  result_ = renderer_.render(camera, gaze, cut);
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

Point Contender::bytes() const {
  const frame::ResourceBytes sum = renderer_.bytes();
  Point buffers = Point::object();
  for (const frame::Resource* resource : renderer_.resources().list()) {
    const frame::ByteClass kind = resource->bytes;
    if (kind != frame::ByteClass::Oit && kind != frame::ByteClass::Overhead) continue;
    buffers[std::string(resource->name)] = renderer_.resources().bytesOf(*resource);
  }
  return {{"transparency", sum.oit + sum.overhead},
          {"oit", sum.oit},
          {"budget", orNull(renderer_.plan().budgetBytes)},
          {"overhead", sum.overhead},
          {"gbuffer", sum.gbuffer},
          {"buffers", buffers}};
}

/// What of the budget holds fragments or tails, in slots or in a dense target beside them.
std::optional<double> Contender::budgetUsed() const {
  const passes::OitPlan& plan = renderer_.plan();
  if (!plan.budgetBytes || *plan.budgetBytes == 0 || !result_.fragments) return std::nullopt;
  const std::uint64_t oit = renderer_.bytes().oit;
  const std::uint64_t dense = oit - std::min(oit, plan.slots * plan.fragmentBytes());
  const std::uint64_t slots = result_.fragments->stored + result_.tailSlots;
  const std::uint64_t used = dense + slots * plan.fragmentBytes();
  return static_cast<double>(used) / static_cast<double>(*plan.budgetBytes);
}

/// Which share of the opaque pixels was shaded, and which no low-rate sample fits.
Point Contender::shading() const {
  const passes::ShadingCounts& counts = result_.shading;
  if (counts.pixels == 0) return nullptr;
  const auto share = [&](std::uint64_t part) {
    return static_cast<double>(part) / static_cast<double>(counts.pixels);
  };
  return {{"pixels", counts.pixels},
          {"shaded", counts.shaded},
          {"holes", counts.holes},
          {"shaded_share", share(counts.shaded)},
          {"holes_share", share(counts.holes)}};
}

void Contender::describe(Point& point) const {
  Point passes = Point::object();
  for (const PassSamples& pass : passes_) passes[pass.name] = experiment::spreadOf(pass.ms);
  point["sync"] =
      renderer_.plan().sorted() ? Point(passes::nameOf(renderer_.plan().sync)) : Point(nullptr);
  point["exact"] = result_.exact;
  point["rounds"] = totalMs_.size();
  point["ms"] = {{"total", experiment::spreadOf(totalMs_)},
                 {"transparency", experiment::spreadOf(transparencyMs_)},
                 {"shading", experiment::spreadOf(shadingMs_)},
                 {"passes", passes}};
  point["shading"] = shading();
  point["bytes"] = bytes();
  point["budget_used"] = orNull(budgetUsed());
  point["fragments"] = nullptr;
  if (const auto& f = result_.fragments) {
    const double loss =
        f->generated > 0 ? static_cast<double>(f->lost) / static_cast<double>(f->generated) : 0.0;
    point["fragments"] = {{"generated", f->generated},
                          {"stored", f->stored},
                          {"merged", f->merged},
                          {"lost", f->lost},
                          {"loss", loss}};
  }
  point["k"] = nullptr;
  if (const auto& k = result_.layers) {
    point["k"] = {{"min", k->min}, {"max", k->max}, {"mean", k->mean}};
  }
  point["deepest"] = result_.deepest > 0 ? Point(result_.deepest) : Point(nullptr);
  point["recaptures"] = result_.recaptures;
  point["lock_failures"] = result_.lockFailures;
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
  point["error"] = measure::toJson(compared.error);
  if (!reference.flipMaps || !compared.flipMap) return;
  const std::string flip = "images/" + stem + "_flip.png";
  image::writePng(folder / flip, measure::flipImage(*compared.flipMap));
  point["images"]["flip"] = flip;
}

}  // namespace macula::tools
