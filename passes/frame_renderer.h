// Draws frames of one scene with one set of settings: what the tools talk to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "engine/frame/frame_list.h"
#include "engine/frame/frame_resources.h"
#include "engine/frame/pass_context.h"
#include "engine/scene/gpu_scene.h"
#include "passes/lod/plan.h"
#include "passes/machine.h"
#include "passes/oit/plan.h"
#include "passes/oit/statistics.h"
#include "passes/render_settings.h"
#include "shared/frame_constants.h"
#include "shared/oit_totals.h"

namespace macula::passes {

/// Fragments of one frame, at the rate at which transparency is drawn. generated = stored + merged
/// + lost.
struct FragmentCounts {
  std::uint64_t generated = 0;  ///< pass opaque depth, and alpha exceeds LEAST_ALPHA
  std::uint64_t stored = 0;
  std::uint64_t merged = 0;  ///< in a tail
  std::uint64_t lost = 0;
};

/// Layers over the covered samples; none where nothing is covered or nothing is stored.
struct LayerStatistics {
  std::uint32_t min = 0;
  std::uint32_t max = 0;
  double mean = 0.0;
};

/// Opaque pixels of one frame, and how many were really shaded.
struct ShadingCounts {
  std::uint64_t pixels = 0;  ///< of the image, in samples
  std::uint64_t shaded = 0;  ///< samples of what lod.what names, holes among them
  std::uint64_t holes = 0;   ///< pixels that no low-rate sample fits
};

struct FrameResult {
  double totalMs = 0.0;       ///< from glFinish to glFinish
  double resizeFactor = 1.0;  ///< r in use
  double resizableMs = 0.0;   ///< of the passes whose work follows, or would follow, 1 / r^2
  ShadingCounts shading;
  std::span<const frame::PassTime> passes;  ///< until the next frame
  std::optional<FragmentCounts> fragments;  ///< none where the method does not count
  std::optional<LayerStatistics> layers;
  std::uint32_t deepest = 0;    ///< largest number of fragments in a sample
  std::uint64_t tailSlots = 0;  ///< slots that hold tails
  std::uint32_t lockFailures = 0;
  bool exact = false;  ///< every transparent fragment reached the image in its place, at full rate
  int recaptures = 0;  ///< times the frame was drawn again with a larger pool
};

/// How often each thing was done to a renderer. Two renderers to which the same was done between
/// the same frames draw the same bits, so a recording that notes every step of these misses
/// nothing.
struct RendererSteps {
  std::uint64_t frames = 0;    ///< drawn to the end
  std::uint64_t resets = 0;    ///< history was given up: a new size, changed settings
  std::uint64_t scenes = 0;    ///< a scene was set, or its transparent surfaces shown or hidden
  std::uint64_t restarts = 0;  ///< everything that earlier frames left behind was given up
};

class FrameRenderer {
 public:
  FrameRenderer(const RenderSettings& settings, Machine& machine);

  /// The scene must outlive the renderer or the next call.
  void setScene(const scene::GpuScene& scene);
  /// Pixels of the image. Invalidates history.
  void resize(glm::ivec2 outputSize);
  /// Whether transparent surfaces are drawn (the default). Without them a frame holds what lies
  /// behind every transparent fragment. Invalidates history.
  void showTransparency(bool shown);
  /// To be called after a change of the settings given to the constructor.
  void settingsChanged();
  /// For the following frames. Changes no allocation and keeps history; the first frame that asks
  /// for less than full rate makes ready for it, until restart().
  void setLevers(const frame::Levers& levers);
  /// Whether setLevers() can have anything computed at 1/r, by the present settings and scene; true
  /// while there is none, for nothing is known of it.
  [[nodiscard]] bool canResize() const;
  /// How many times over the shading of the following frames is computed: a load to try a
  /// controller on. The image stays the same. @param times >= 1
  void setShadingLoad(int times);
  /// Gives up everything that earlier frames left behind, so that the next one is drawn as by a new
  /// renderer of the same scene and size. Images can be read again after that frame.
  void restart();

  /// A frame that ends with an exception leaves nothing behind: the next one begins with restart().
  /// @param gaze its place steers importance; a radius beyond gaze::kFoveaRadius widens what counts
  ///   as looked at
  /// @param cut the camera jumped; history is invalid
  FrameResult render(const scene::Camera& camera, const gaze::PointOfInterest& gaze,
                     bool cut = false);
  /// The same for a place that is known exactly.
  /// @param gaze 0..1 of the window from the top left
  FrameResult render(const scene::Camera& camera, glm::vec2 gaze, bool cut = false) {
    return render(camera, gaze::exactPoint(gaze), cut);
  }

  /// RGB8 of the last frame, rows from the top, 3 bytes a pixel: the image, without a heat map.
  /// What is measured or compared is this.
  void readDisplay(std::vector<std::uint8_t>& rgb) const;
  /// The same of what is shown: the heat map where there is one, or else the image.
  void readShown(std::vector<std::uint8_t>& rgb) const;
  [[nodiscard]] const gl::Texture& shownTexture() const;
  /// What the colours of the last frame's heat map mean; none where it has none.
  [[nodiscard]] std::optional<image::Legend> legend() const;
  /// Linear RGB of the last frame after the tone curve, rows from the top; needs
  /// settings.tonemap.linearOut.
  void readLinear(std::vector<float>& rgb) const;

  [[nodiscard]] const OitPlan& plan() const { return plan_; }
  [[nodiscard]] const LodPlan& lod() const { return lod_; }
  [[nodiscard]] frame::ResourceBytes bytes() const { return resources_.bytes(); }
  [[nodiscard]] const frame::FrameResources& resources() const { return resources_; }
  [[nodiscard]] glm::ivec2 outputSize() const { return inputs_.outputSize; }
  /// What the last frame was drawn from.
  [[nodiscard]] const frame::FrameInputs& inputs() const { return inputs_; }
  /// Whether the last frame was drawn as one after a cut.
  [[nodiscard]] bool wasCut() const { return cut_; }
  [[nodiscard]] const RendererSteps& steps() const { return steps_; }
  /// Whether a fragment's place among those of its pixel may depend on how threads met.
  [[nodiscard]] bool isRacy() const { return plan_.sorted() && plan_.sync == SyncMode::None; }
  [[nodiscard]] std::vector<frame::PassReport> report() const { return list_.report(inputs_); }

  /// What the last frame left on the GPU, for those who read more of it back.
  [[nodiscard]] frame::PassContext passContext();

 private:
  void readyForLevers();
  void prepare();
  void planMethod(std::uint64_t samples);
  void planRoutedSamples();
  void planNetwork();
  void sizePool(std::uint32_t slots);
  void allocate();
  void planTransparency();
  void uploadConstants();
  [[nodiscard]] shader::FrameConstants constantsFor(glm::ivec2 samples) const;
  [[nodiscard]] shader::OitTotals runOnce();
  [[nodiscard]] FrameResult resultOf(const shader::OitTotals& totals);
  void describeLod(shader::FrameConstants& constants) const;
  [[nodiscard]] bool isResizable(std::string_view pass) const;
  void countShading(FrameResult& result) const;
  void countFragments(const shader::OitTotals& totals, FrameResult& result);

  const RenderSettings& settings_;
  Machine& machine_;
  OitPlan plan_;
  std::optional<network::Network> network_;  ///< of networkFile_
  std::filesystem::path networkFile_;
  LodPlan lod_;
  OitStatisticsCounter statistics_;
  frame::FrameInputs inputs_;
  frame::FrameResources resources_;
  frame::FrameList list_;
  gl::FrameTimer timer_;
  gl::Buffer constants_;
  gl::Buffer resizedConstants_;  ///< the same in texels of resized transparency
  std::optional<scene::Camera> lastCamera_;
  std::uint32_t deepestSeen_ = 0;
  double extraMs_ = 0.0;
  double heatmapRange_ = 1.0;  ///< of the last frame; what it counted is for the next
  int shadingLoad_ = 1;
  glm::mat4 lastViewProjection_{1.0F};
  glm::ivec2 lastTransparencySize_{0};
  bool mayResize_ = false;  ///< a lever has asked for less than full rate since restart()
  bool prepared_ = false;
  bool historyUsable_ = false;
  bool transparencyShown_ = true;
  bool cut_ = false;
  bool unfinished_ = false;  ///< the last frame ended with an exception
  RendererSteps steps_;
};

}  // namespace macula::passes
