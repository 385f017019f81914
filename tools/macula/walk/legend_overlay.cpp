#include "walk/legend_overlay.h"

#include <algorithm>

namespace macula::tools {
namespace {

constexpr int kMargin = 6;  ///< pixels

}  // namespace

void LegendOverlay::Drawn::update(const std::optional<image::Legend>& wanted, glm::ivec2 size) {
  if (wanted == legend && size == window) return;
  legend = wanted;
  window = size;
  texture = {};
  if (!wanted) return;
  const image::Image8 drawn = image::drawLegend(*wanted, size.x, size.y);
  if (!drawn.pixels.empty()) texture = textureOf(drawn);
}

void LegendOverlay::show(const Screen& screen, const passes::FrameRenderer& first,
                         const SecondView& second, glm::ivec2 window) {
  const bool two = second.mode() == ViewMode::Split || second.mode() == ViewMode::SideBySide;
  const bool difference = second.mode() == ViewMode::Difference && second.shown();
  first_.update(difference ? second.differenceLegend() : first.legend(), window);
  const passes::FrameRenderer* other = two ? second.renderer() : nullptr;
  second_.update(other != nullptr ? other->legend() : std::nullopt, window);
  const auto put = [&](const gl::Texture& legend, int left) {
    if (!legend) return;
    const int column = std::clamp(left, 0, std::max(0, window.x - legend.width()));
    // GL counts rows from the bottom.
    screen.show(legend, {{0, 0}, {legend.width(), legend.height()}},
                {column, window.y - legend.height() - kMargin});
  };
  const int middle = window.x / 2;
  put(first_.texture,
      two ? middle - kMargin - first_.texture.width() : middle - first_.texture.width() / 2);
  put(second_.texture, middle + kMargin);
}

}  // namespace macula::tools
