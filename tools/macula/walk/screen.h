// The window's picture: rendered images onto it, and the whole of it read back.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>

#include "engine/gl/objects.h"
#include "engine/image/image.h"

namespace macula::tools {

/// A rectangle of pixels, counted from the bottom left as GL does.
struct PixelRect {
  glm::ivec2 low{0};
  glm::ivec2 size{0};
};

class Screen {
 public:
  Screen();
  /// Fills the default framebuffer with one colour.
  void clear(glm::vec3 color) const;
  /// Fills a rectangle of it.
  void fill(const PixelRect& rect, glm::vec3 color) const;
  /// Copies part of an image to a place of the default framebuffer, without scaling. Both have
  /// their first row at the bottom.
  void show(const gl::Texture& image, const PixelRect& part, glm::ivec2 place) const;
  /// All of an image to the corner.
  void show(const gl::Texture& image) const;

 private:
  gl::FramebufferId source_;
};

/// What is in the back buffer; to be called before the swap.
[[nodiscard]] image::Image8 readScreen(glm::ivec2 size);

/// A texture that shows an image, rows from the top, by Screen::show().
/// @param image 3 channels
[[nodiscard]] gl::Texture textureOf(const image::Image8& image);

}  // namespace macula::tools
