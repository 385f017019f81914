// Legends over the picture of a walk, so that pictures that are taken of it have them, too.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "engine/image/legend.h"
#include "passes/frame_renderer.h"
#include "walk/screen.h"
#include "walk/second_view.h"

namespace macula::tools {

class LegendOverlay {
 public:
  /// Draws those of the heat maps, or that of the difference, at the top in the middle of the
  /// window, where no panel reaches.
  void show(const Screen& screen, const passes::FrameRenderer& first, const SecondView& second,
            glm::ivec2 window);

 private:
  /// A legend as it was drawn last; drawn again where it changes.
  struct Drawn {
    std::optional<image::Legend> legend;
    glm::ivec2 window{0};
    gl::Texture texture;

    void update(const std::optional<image::Legend>& wanted, glm::ivec2 size);
  };

  Drawn first_;
  Drawn second_;
};

}  // namespace macula::tools
