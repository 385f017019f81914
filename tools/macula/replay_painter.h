// What every replay draws with: a renderer with its images, and what is compared with them.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <string_view>

#include "engine/core/output_folder.h"
#include "engine/image/image.h"
#include "engine/measure/flicker.h"
#include "engine/measure/run_record.h"
#include "engine/recording/recording.h"
#include "engine/scene/gpu_scene.h"
#include "passes/device_context.h"
#include "passes/frame_renderer.h"
#include "replay.h"

namespace macula::tools {

/// What a frame shows: its image, or the heat map with its legend.
/// @param display the image
[[nodiscard]] image::Image8 shownPicture(const passes::FrameRenderer& renderer,
                                         const image::Image8& display);

/// One renderer with the buffers that its images are read into.
class Painter {
 public:
  Painter(const passes::RenderSettings& settings, passes::DeviceContext& device,
          const scene::GpuScene& gpu, glm::ivec2 size)
      : renderer_(settings, device), linearOut_(settings.tonemap.linearOut) {
    resize(size);
    renderer_.setScene(gpu);
    display_.channels = linear_.channels = 3;
    linear_.linear = true;
  }

  /// Of the following frames only images are asked for.
  void wantImagesAlone() { renderer_.want({.times = false, .statistics = false}); }
  passes::FrameResult draw(const recording::Frame& frame) {
    return renderer_.render(frame.camera, frame.gaze, frame.cut);
  }
  void readBack() {
    renderer_.readDisplay(display_.pixels);
    if (linearOut_) renderer_.readLinear(linear_.pixels);
  }
  /// Writes FOLDER/STEM_INDEX.png or .exr. A PNG is of what is shown: with a heat map, that and its
  /// legend.
  void write(OutputFolder& folder, std::string_view stem, int index,
             const std::string& format) const;
  /// Pixels of the following frames. Invalidates history.
  void resize(glm::ivec2 size) {
    renderer_.resize(size);
    display_.width = linear_.width = size.x;
    display_.height = linear_.height = size.y;
  }
  void setScene(const scene::GpuScene& gpu) { renderer_.setScene(gpu); }
  void restart() { renderer_.restart(); }
  void setControls(const frame::QualityControls& controls) { renderer_.setControls(controls); }

  [[nodiscard]] const passes::FrameRenderer& renderer() const { return renderer_; }
  /// The image of the last frame, without a heat map: what hashes and errors are of.
  [[nodiscard]] const image::Image8& display() const { return display_; }
  [[nodiscard]] const image::ImageF& linear() const { return linear_; }

 private:
  passes::FrameRenderer renderer_;
  bool linearOut_;
  image::Image8 display_;
  image::ImageF linear_;
};

/// Fills in what does not change from frame to frame.
/// @param scene as the report names it
/// @param size of the images, pixels
void describeRun(measure::RunRecord& run, const std::string& scene, const ReplayOptions& options,
                 const passes::DeviceContext& device, const passes::FrameRenderer& renderer,
                 glm::ivec2 size);

/// Sets the metrics that compare a frame with its reference. Its gaze must be set.
void compareWithReference(measure::FrameRecord& record, const Painter& reference,
                          const Painter& test, const ReplayOptions& options,
                          measure::FlickerMeter& flicker);

}  // namespace macula::tools
