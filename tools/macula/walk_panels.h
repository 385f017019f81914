// The panels of a walk: what is drawn where, from the settings and the numbers of the last frame.
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "engine/ui/settings_panel.h"
#include "engine/ui/timings_panel.h"
#include "passes/frame_renderer.h"

namespace macula::tools {

class WalkPanels {
 public:
  WalkPanels(settings::Registry& registry, const passes::RenderSettings& settings,
             std::string sceneName);

  /// Takes the times of a frame that was drawn.
  void add(const passes::FrameResult& result);
  /// Draws all panels and the ring. To be called between the frames of the UI.
  /// @param gaze 0..1 of the window from the top left
  void draw(const passes::FrameRenderer& renderer, const passes::FrameResult& result,
            glm::vec2 gaze);

  [[nodiscard]] ui::SettingsPanel& settings() { return panel_; }

 private:
  void drawView(const passes::FrameRenderer& renderer);
  void drawNumbers(const passes::FrameRenderer& renderer, const passes::FrameResult& result);
  void drawLegend(const passes::FrameRenderer& renderer) const;

  const passes::RenderSettings& renderSettings_;
  std::string sceneName_;
  ui::SettingsPanel panel_;
  ui::TimingsPanel timings_;
};

}  // namespace macula::tools
