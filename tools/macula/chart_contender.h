// One variant of a batch while its frames are measured, and the reference beside it.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "chart_settings.h"
#include "engine/experiment/point.h"
#include "engine/image/image.h"
#include "engine/measure/flip.h"
#include "engine/recording/recording.h"
#include "passes/frame_renderer.h"

namespace macula::tools {

/// What a group draws: the scene in GPU memory, seen by one camera.
struct Stage {
  passes::DeviceContext& device;
  const scene::GpuScene& gpu;
  scene::Camera camera;
  glm::vec2 gaze{0.5F};
  glm::ivec2 size{0};
};

/// The exact image of a group.
struct Reference {
  image::Image8 shown;
  image::ImageF display;  ///< encoded, not rounded
  std::string file;       ///< "images/...", relative to the output folder
  glm::dvec2 gaze{0.5};   ///< where the viewer looks, 0..1 from the top left
  double pixelsPerDegree = measure::kDefaultPixelsPerDegree;
  std::uint64_t generated = 0;
  bool flipMaps = false;  ///< FLIP maps are written beside the difference maps
};

class Contender {
 public:
  /// @throws InputError where the machine refuses the settings
  Contender(std::unique_ptr<VariantSettings> settings, const Stage& stage);

  /// @throws InputError where the machine refuses the buffers
  void draw(bool measured);
  /// A frame beside those that count, on the history of the last one.
  /// @throws InputError where the machine refuses the buffers
  void drawFrom(const recording::Frame& frame);

  /// The images of the last frame.
  [[nodiscard]] image::Image8 shown() const;
  [[nodiscard]] image::ImageF display() const;

  /// Adds what was measured to a point: times, bytes, fragments, k, settings.
  void describe(experiment::Point& point) const;
  [[nodiscard]] const passes::FrameResult& result() const { return result_; }
  [[nodiscard]] const passes::FrameRenderer& renderer() const { return renderer_; }
  [[nodiscard]] const passes::RenderSettings& settings() const { return settings_->render; }

 private:
  std::unique_ptr<VariantSettings> settings_;
  const Stage& stage_;
  passes::FrameRenderer renderer_;
  passes::FrameResult result_;
  std::vector<measure::FrameRecord> rounds_;
};

/// Adds errors against the reference to a point, writes image and error maps and names them.
/// @param picture what is written: the image, or its heat map
void describeImage(experiment::Point& point, const image::Image8& picture,
                   const image::ImageF& display, const Reference& reference, double scale,
                   const std::filesystem::path& folder, const std::string& stem);

}  // namespace macula::tools
