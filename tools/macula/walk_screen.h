// The window's picture: the rendered image onto it, and the whole of it into a file.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>

#include "engine/gl/objects.h"

namespace macula::tools {

class Screen {
 public:
  Screen();
  /// Copies an image of the framebuffer's size to the default framebuffer. Both have their first
  /// row at the bottom.
  void show(const gl::Texture& image) const;

 private:
  gl::FramebufferId source_;
};

/// Writes what is in the back buffer, panels included, as PNG. To be called before the swap.
/// @throws InputError where the file cannot be written
void writeScreenshot(const std::filesystem::path& file, glm::ivec2 size);

}  // namespace macula::tools
