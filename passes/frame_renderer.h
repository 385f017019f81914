// Draws frames of one scene with one set of settings: the tools' interface to everything below.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/frame/frame_list.h"
#include "engine/frame/frame_resources.h"
#include "engine/frame/pass_context.h"
#include "engine/scene/gpu_scene.h"
#include "passes/device_context.h"
#include "passes/frame_constants.h"
#include "passes/frame_numbers.h"
#include "passes/frame_result.h"
#include "passes/lod/plan.h"
#include "passes/oit/plan.h"
#include "passes/render_settings.h"

namespace macula::passes {

class FrameRenderer {
 public:
  FrameRenderer(const RenderSettings& settings, DeviceContext& device);

  /// The scene must outlive the renderer or the next call.
  void setScene(const scene::GpuScene& scene);
  /// Pixels of the image. Invalidates history.
  void resize(glm::ivec2 outputSize);
  /// Whether transparent surfaces are drawn (the default). Without them a frame holds what lies
  /// behind every transparent fragment. Invalidates history.
  void showTransparency(bool shown);
  /// To be called after a change of the settings given to the constructor.
  void settingsChanged();
  /// The quality controls of the following frames. They change no allocation and keep history; the
  /// first frame that asks for less than full rate prepares passes for it, until restart().
  void setControls(const frame::QualityControls& controls);
  /// Whether setControls() can have anything computed at 1/r, by the present settings and scene;
  /// true while there is no scene.
  [[nodiscard]] bool canResize() const;
  /// How many times over the shading of the following frames is computed: a load to test a
  /// controller with. The image stays the same. @param times >= 1
  void setShadingLoad(int times);
  /// Gives up everything that earlier frames left behind, so that the next one is drawn as by a new
  /// renderer of the same scene and size. Until then there is no image to read.
  void restart();

  /// What is asked for beside the images of the following frames; all of it at first.
  void want(const Wanted& wanted) { wanted_ = wanted; }

  /// Draws a frame and waits for its numbers. Two renderers to which the same is done give the same
  /// bits. Where a pool was too small, the frame is drawn again.
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

  /// Draws a frame and waits for nothing: its numbers come later, by takeResult(). What follows
  /// from them (N_limit, the size of a pool, the range of a heat map) follows that much later, too.
  void draw(const scene::Camera& camera, const gaze::PointOfInterest& gaze, bool cut = false);
  /// The numbers of the newest frame of draw() whose numbers have arrived since the last call; none
  /// where none have. Never waits. Frames are left out where more are on their way than can be
  /// followed, and where a larger pool, another size or other settings came between.
  [[nodiscard]] std::optional<FrameResult> takeResult();
  /// Waits for the numbers of the frame that was drawn last, statistics among them.
  [[nodiscard]] FrameResult waitForResult();

  /// RGB8 of the last frame, rows from the top, 3 bytes a pixel: the image, without a heat map.
  /// Measurements and comparisons use it.
  void readDisplay(std::vector<std::uint8_t>& rgb) const;
  /// The same of what is shown: the heat map where there is one, or else the image.
  void readShown(std::vector<std::uint8_t>& rgb) const;
  /// To be sampled, or blitted to a window.
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
  /// Whether every buffer is as the frame left it; else only what is documented to stay.
  [[nodiscard]] bool readBack() const { return settings_.readBack; }
  [[nodiscard]] glm::ivec2 outputSize() const { return inputs_.outputSize; }
  /// What the last frame was drawn from.
  [[nodiscard]] const frame::FrameInputs& inputs() const { return inputs_; }
  /// Whether the last frame was drawn as one after a cut.
  [[nodiscard]] bool wasCut() const { return cut_; }
  [[nodiscard]] const RendererSteps& steps() const { return steps_; }
  /// Whether the result may depend on the timing of threads.
  [[nodiscard]] bool isRacy() const { return plan_.sorted() && plan_.sync == SyncMode::None; }
  [[nodiscard]] std::vector<frame::PassReport> report() const { return list_.report(inputs_); }

  /// What the last frame left on the GPU, for readers that dispatch shaders of their own.
  [[nodiscard]] frame::PassContext passContext();

 private:
  /// What the last frame leaves to the next.
  struct History {
    std::optional<scene::Camera> camera;
    glm::mat4 viewProjection{1.0F};
    glm::ivec2 transparencySize{0};
    bool usable = false;
  };

  // frame_renderer.cpp: what follows from settings, scene, size
  void prepareForReducedRate();
  void prepare();
  void allocate();
  void enlargePool(std::uint32_t asked);
  void forgetNumbers();
  // frame_renderer_draw.cpp: one frame
  void beginFrame(const scene::Camera& camera, const gaze::PointOfInterest& gaze, bool cut);
  void run(gl::FrameTimer* timer);
  void runInto(std::size_t slot);
  void sumUp(IssuedFrame& frame);
  void leaveHistory(const scene::Camera& camera);
  // frame_renderer_result.cpp: what is told about it
  void describe(IssuedFrame& frame) const;
  [[nodiscard]] bool statisticsWanted() const;
  [[nodiscard]] FrameResult resultOf(std::size_t slot);
  void noteOverflow(IssuedFrame& frame, std::uint32_t asked);
  void setTimes(FrameResult& result, std::size_t slot);
  void setFragments(FrameResult& result, const IssuedFrame& frame, const FrameSums& sums);
  [[nodiscard]] bool isResizable(std::string_view pass) const;

  const RenderSettings& settings_;
  DeviceContext& device_;
  OitPlan plan_;
  LoadedNetwork network_;
  LodPlan lod_;
  frame::FrameInputs inputs_;
  frame::FrameResources resources_;
  frame::FrameList list_;
  FrameNumbers numbers_;
  std::size_t lastSlot_ = FrameNumbers::kNoSlot;  ///< of the last frame
  std::vector<frame::PassTime> passTimes_;        ///< of the last result
  Wanted wanted_;
  FrameConstantBuffers constants_;
  History history_;
  std::uint32_t deepestSeen_ = 0;
  std::uint32_t askedSlots_ = 0;  ///< of a pool that was too small for a frame of draw()
  std::uint64_t overflows_ = 0;
  double heatmapRange_ = 1.0;  ///< of the last frame; its counts are for the next one
  int shadingLoad_ = 1;
  bool mayReduce_ = false;  ///< less than full rate was asked for since restart()
  bool prepared_ = false;
  bool transparencyShown_ = true;
  bool cut_ = false;
  bool unfinished_ = false;  ///< the last frame ended with an exception
  RendererSteps steps_;
};

}  // namespace macula::passes
