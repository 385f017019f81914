#include "replay_painter.h"

#include <fmt/format.h>

#include "engine/measure/image_error.h"
#include "frame_record.h"
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

void describeRun(measure::RunRecord& run, const std::string& scene, const ReplayOptions& options,
                 const passes::DeviceContext& device, const passes::FrameRenderer& renderer,
                 glm::ivec2 size) {
  run.commit = MACULA_COMMIT;
  run.scene = scene;
  run.width = size.x;
  run.height = size.y;
  run.renderer = device.capabilities.renderer;
  run.version = device.capabilities.version;
  run.timeSource = gl::nameOf(device.time.source);
  run.method = options.settings.oit.method;
  if (renderer.plan().sorted()) {
    run.sync = passes::nameOf(renderer.plan().sync);
  }
  run.settings = options.registry.toJson();
  run.transparencyBytes = transparencyBytes(renderer);
}

void compareWithReference(measure::FrameRecord& record, const Painter& reference,
                          const Painter& test, const ReplayOptions& options,
                          measure::FlickerMeter& flicker) {
  measure::CompareOptions compare;
  compare.hdr = options.hdr;
  compare.pixelsPerDegree = options.pixelsPerDegree;
  compare.gaze = glm::dvec2(record.number("gaze.x").value(), record.number("gaze.y").value());
  const image::ImageF wanted = measure::toDisplay(reference.linear());
  const image::ImageF got = measure::toDisplay(test.linear());
  measure::setError(record, options.hdr
                                ? measure::compareImages(reference.linear(), test.linear(), compare)
                                : measure::compareImages(wanted, got, compare));
  record.set("flicker", flicker.next(wanted, got));
}

}  // namespace macula::tools
