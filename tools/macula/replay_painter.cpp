#include "replay_painter.h"

#include <fmt/format.h>

#include "engine/measure/image_error.h"
#include "macula_version.h"

namespace macula::tools {

image::Image8 shownPicture(const passes::FrameRenderer& renderer, const image::Image8& display) {
  image::Image8 picture = display;
  if (const std::optional<image::Legend> legend = renderer.legend()) {
    renderer.readShown(picture.pixels);
    image::putLegend(picture, *legend);
  }
  return picture;
}

void Painter::write(OutputFolder& folder, std::string_view stem, int index,
                    const std::string& format) const {
  const auto path = folder.file(fmt::format("{}_{:05}.{}", stem, index, format));
  if (format == "png") image::writePng(path, shownPicture(renderer_, display_));
  if (format == "exr") image::writeExr(path, linear_);
}

measure::FrameRecord recordOf(const passes::FrameResult& result,
                              const gaze::PointOfInterest& point) {
  measure::FrameRecord record;
  record.gazeX = point.position.x;
  record.gazeY = point.position.y;
  record.rawX = point.raw.x;
  record.rawY = point.raw.y;
  record.gazeState = gaze::stateName(point.state);
  record.gazeAgeSeconds = point.ageSeconds;
  record.gazeRadius = point.radius;
  record.gazeSaccade = point.saccade;
  record.resizeFactor = result.resizeFactor;
  record.shading =
      measure::ShadingNumbers{result.shading.pixels, result.shading.shaded, result.shading.holes};
  record.totalMs = result.totalMs;
  for (const frame::PassTime& pass : result.passes) {
    record.passMs.emplace_back(pass.name, pass.ms);
  }
  if (result.fragments) {
    record.fragments =
        measure::FragmentNumbers{result.fragments->generated, result.fragments->stored,
                                 result.fragments->merged, result.fragments->lost};
  }
  if (result.layers) {
    record.layers =
        measure::LayerNumbers{result.layers->min, result.layers->max, result.layers->mean};
  }
  record.exact = result.exact;
  return record;
}

void describeRun(measure::RunRecord& run, const std::string& scene, const ReplayOptions& options,
                 const passes::Machine& machine, const passes::FrameRenderer& renderer,
                 glm::ivec2 size) {
  run.commit = MACULA_COMMIT;
  run.scene = scene;
  run.width = size.x;
  run.height = size.y;
  run.renderer = machine.capabilities.renderer;
  run.version = machine.capabilities.version;
  run.timeSource = gl::nameOf(machine.time.source);
  run.method = options.settings.oit.method;
  if (renderer.plan().sorted()) {
    run.sync = passes::nameOf(renderer.plan().sync);
  }
  run.settings = options.registry.toJson();
  const frame::ResourceBytes bytes = renderer.bytes();
  run.oitBytes = bytes.oit;
  run.budgetBytes = renderer.plan().budgetBytes;
  run.overheadBytes = bytes.overhead;
  run.gbufferBytes = bytes.gbuffer;
  for (const frame::Resource* resource : renderer.resources().list()) {
    const frame::ByteClass kind = resource->bytes;
    if (kind != frame::ByteClass::Oit && kind != frame::ByteClass::Overhead) continue;
    run.transparencyBytes.emplace_back(resource->name, renderer.resources().bytesOf(*resource));
  }
}

/// Fills in what compares a frame with its reference.
void compareWithReference(measure::FrameRecord& record, const Painter& reference,
                          const Painter& test, const ReplayOptions& options,
                          measure::FlickerMeter& flicker) {
  measure::CompareOptions compare;
  compare.hdr = options.hdr;
  compare.pixelsPerDegree = options.pixelsPerDegree;
  compare.gaze = glm::dvec2(record.gazeX, record.gazeY);
  const image::ImageF wanted = measure::toDisplay(reference.linear());
  const image::ImageF got = measure::toDisplay(test.linear());
  record.error = options.hdr ? measure::compareImages(reference.linear(), test.linear(), compare)
                             : measure::compareImages(wanted, got, compare);
  record.flicker = flicker.next(wanted, got);
}

}  // namespace macula::tools
