// Two methods in one window: side by side, with a line between them, or their difference.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/image/legend.h"
#include "engine/ui/frame_rate.h"
#include "engine/ui/settings_panel.h"
#include "passes/device_context.h"
#include "passes/frame_renderer.h"
#include "walk/frame_events.h"
#include "walk/screen.h"

namespace macula::tools {

enum class ViewMode { One, Split, SideBySide, Difference };

/// "one", "split", "side", "difference", in the order of ViewMode.
[[nodiscard]] const std::vector<std::string>& viewModeNames();

/// Method B: transparency settings of its own, everything else as method A has it. Holds GPU memory
/// only while it is shown.
class SecondView {
 public:
  /// @param first the settings of method A, which must outlive this object
  SecondView(const passes::RenderSettings& first, passes::DeviceContext& device);

  void setMode(ViewMode mode);
  [[nodiscard]] ViewMode mode() const { return mode_; }
  [[nodiscard]] bool shown() const { return mode_ != ViewMode::One; }
  /// Pixels that each method draws in a window of this size.
  [[nodiscard]] glm::ivec2 pictureSize(glm::ivec2 window) const;

  /// Draws method B. A change of its settings that the machine cannot take is taken back.
  /// @param firstChanged settings or size of method A changed
  /// @param wanted beside the picture
  /// @throws InputError where method B cannot be drawn at all
  void render(const FrameEvents& events, const scene::GpuScene& gpu, bool firstChanged,
              const passes::Wanted& wanted);
  /// Waits for the numbers of the last frame, where there is one.
  void waitForResult();
  /// Puts the picture together in the default framebuffer.
  void compose(const Screen& screen, const passes::FrameRenderer& first, glm::ivec2 window);
  /// The scene has gone.
  void forgetScene() { dropRenderer(); }

  /// Moves the line of the split view where the user drags it, and draws it with the names and the
  /// times of both methods. Between the frames of the UI.
  /// @param first the time of method A
  /// @param pointerFree whether no panel has the pointer
  /// @param top of the names, in the UI's coordinates
  void drawOverlay(const ui::MethodTime& first, bool pointerFree, float top);
  [[nodiscard]] bool dragging() const { return dragging_; }

  /// A difference of 1 / scale has the hottest colour; a power of two.
  [[nodiscard]] float differenceScale() const { return scale_; }
  void scaleDifference(bool up);
  /// What the colours of the difference mean.
  [[nodiscard]] image::Legend differenceLegend() const;

  [[nodiscard]] ui::SettingsPanel& panel() { return panel_; }
  [[nodiscard]] settings::Registry& registry() { return registry_; }
  [[nodiscard]] const passes::RenderSettings& settings() const { return settings_; }
  /// Null before the first frame.
  [[nodiscard]] const passes::FrameRenderer* renderer() const { return renderer_.get(); }
  /// The newest there is.
  [[nodiscard]] const passes::FrameResult& result() const { return result_; }
  [[nodiscard]] const ui::MethodTime& time() const { return time_; }

 private:
  void dropRenderer();
  void adoptResult(const passes::FrameResult& result);
  void makeRenderer(const FrameEvents& events, const scene::GpuScene& gpu);
  void drawDifference(const gl::Texture& first, const gl::Texture& second);

  const passes::RenderSettings& first_;
  passes::DeviceContext& device_;
  passes::RenderSettings settings_;
  settings::Registry registry_;
  ui::SettingsPanel panel_;
  std::unique_ptr<passes::FrameRenderer> renderer_;
  passes::FrameResult result_;
  ui::MethodTime time_;
  gl::Texture difference_;
  ViewMode mode_ = ViewMode::One;
  float split_ = 0.5F;  ///< share of the window's width left of the line
  float scale_;
  bool dragging_ = false;
};

}  // namespace macula::tools
