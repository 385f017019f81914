#include "walk/screen.h"

#include <algorithm>
#include <cstddef>

#include "engine/gl/blocking.h"

namespace macula::tools {
namespace {

constexpr int kChannels = 3;

GLuint makeFramebuffer() {
  GLuint id = 0;
  glCreateFramebuffers(1, &id);
  gl::label(GL_FRAMEBUFFER, id, "shown image");
  return id;
}

/// GL counts rows from the bottom.
void mirrorRows(image::Image8& image) {
  const auto row = static_cast<std::ptrdiff_t>(image.width) * image.channels;
  for (std::ptrdiff_t y = 0; y < image.height / 2; ++y) {
    const auto top = image.pixels.begin() + y * row;
    std::swap_ranges(top, top + row, image.pixels.begin() + (image.height - 1 - y) * row);
  }
}

}  // namespace

Screen::Screen() : source_(makeFramebuffer()) {}

void Screen::clear(glm::vec3 color) const {
  glDisable(GL_FRAMEBUFFER_SRGB);
  glDisable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  const GLfloat values[] = {color.r, color.g, color.b, 1.0F};
  glClearNamedFramebufferfv(0, GL_COLOR, 0, values);
}

void Screen::fill(const PixelRect& rect, glm::vec3 color) const {
  glEnable(GL_SCISSOR_TEST);
  glScissor(rect.low.x, rect.low.y, rect.size.x, rect.size.y);
  const GLfloat values[] = {color.r, color.g, color.b, 1.0F};
  glClearNamedFramebufferfv(0, GL_COLOR, 0, values);
  glDisable(GL_SCISSOR_TEST);
}

void Screen::show(const gl::Texture& image, const PixelRect& part, glm::ivec2 place) const {
  // Attached again each time: after a resize another texture may bear the same name.
  glNamedFramebufferTexture(source_.id(), GL_COLOR_ATTACHMENT0, image.id(), 0);
  // The image was written by image stores.
  glMemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT);
  // The bytes are display values already, and all of them are wanted.
  glDisable(GL_FRAMEBUFFER_SRGB);
  glDisable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  const glm::ivec2 high = part.low + part.size;
  const glm::ivec2 end = place + part.size;
  glBlitNamedFramebuffer(source_.id(), 0, part.low.x, part.low.y, high.x, high.y, place.x, place.y,
                         end.x, end.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void Screen::show(const gl::Texture& image) const {
  show(image, {{0, 0}, {image.width(), image.height()}}, {0, 0});
}

image::Image8 readScreen(glm::ivec2 size) {
  image::Image8 shot{size.x, size.y, kChannels, {}};
  shot.pixels.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                     kChannels);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  glReadBuffer(GL_BACK);
  gl::readPixels(size, {GL_RGB, GL_UNSIGNED_BYTE}, shot.pixels.data());
  mirrorRows(shot);
  return shot;
}

gl::Texture textureOf(const image::Image8& image) {
  image::Image8 mirrored = image;
  mirrorRows(mirrored);
  gl::Texture texture("map", GL_RGBA8, image.width, image.height);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(texture.id(), 0, 0, 0, image.width, image.height, GL_RGB, GL_UNSIGNED_BYTE,
                      mirrored.pixels.data());
  return texture;
}

}  // namespace macula::tools
