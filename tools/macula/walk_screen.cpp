#include "walk_screen.h"

#include <algorithm>
#include <cstddef>

#include "engine/image/image.h"

namespace macula::tools {
namespace {

GLuint makeFramebuffer() {
  GLuint id = 0;
  glCreateFramebuffers(1, &id);
  gl::label(GL_FRAMEBUFFER, id, "shown image");
  return id;
}

}  // namespace

Screen::Screen() : source_(makeFramebuffer()) {}

void Screen::show(const gl::Texture& image) const {
  // Attached anew each time: after a resize another texture may bear the same name.
  glNamedFramebufferTexture(source_.id(), GL_COLOR_ATTACHMENT0, image.id(), 0);
  // The image was written by image stores.
  glMemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT);
  // The bytes are display values already, and all of them are wanted.
  glDisable(GL_FRAMEBUFFER_SRGB);
  glDisable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glBlitNamedFramebuffer(source_.id(), 0, 0, 0, image.width(), image.height(), 0, 0, image.width(),
                         image.height(), GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void writeScreenshot(const std::filesystem::path& file, glm::ivec2 size) {
  image::Image8 shot;
  shot.width = size.x;
  shot.height = size.y;
  shot.channels = 3;
  const std::size_t row = static_cast<std::size_t>(size.x) * 3;
  shot.pixels.resize(row * static_cast<std::size_t>(size.y));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  glReadBuffer(GL_BACK);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, size.x, size.y, GL_RGB, GL_UNSIGNED_BYTE, shot.pixels.data());
  for (auto top = shot.pixels.begin(), bottom = shot.pixels.end();
       bottom - top >= 2 * static_cast<std::ptrdiff_t>(row);
       top += static_cast<std::ptrdiff_t>(row)) {
    bottom -= static_cast<std::ptrdiff_t>(row);
    std::swap_ranges(top, top + static_cast<std::ptrdiff_t>(row), bottom);
  }
  image::writePng(file, shot);
}

}  // namespace macula::tools
