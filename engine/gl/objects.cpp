#include "engine/gl/objects.h"

#include <algorithm>
#include <cassert>

#include "engine/core/error.h"
#include "engine/gl/blocking.h"

namespace macula::gl {

void BufferTraits::remove(GLuint id) {
  glDeleteBuffers(1, &id);
}
void TextureTraits::remove(GLuint id) {
  glDeleteTextures(1, &id);
}
void SamplerTraits::remove(GLuint id) {
  glDeleteSamplers(1, &id);
}
void FramebufferTraits::remove(GLuint id) {
  glDeleteFramebuffers(1, &id);
}
void VertexArrayTraits::remove(GLuint id) {
  glDeleteVertexArrays(1, &id);
}
void ProgramTraits::remove(GLuint id) {
  glDeleteProgram(id);
}
void QueryTraits::remove(GLuint id) {
  glDeleteQueries(1, &id);
}

namespace {

void failIfOutOfMemory(std::string_view what, std::size_t bytes) {
  if (glGetError() == GL_OUT_OF_MEMORY) {
    constexpr double kMebi = 1024.0 * 1024.0;
    failInput("the GPU has no memory for {} ({:.1f} MiB); use a smaller --size or --oit-memory",
              what, static_cast<double>(bytes) / kMebi);
  }
}

}  // namespace

Buffer::Buffer(std::string_view name, std::size_t bytes, const void* data) : bytes_(bytes) {
  GLuint id = 0;
  glCreateBuffers(1, &id);
  object_ = Object<BufferTraits>(id);
  glNamedBufferStorage(id, static_cast<GLsizeiptr>(bytes), data, GL_DYNAMIC_STORAGE_BIT);
  failIfOutOfMemory(name, bytes);
  label(GL_BUFFER, id, name);
}

void Buffer::upload(const void* values, std::size_t bytes, std::size_t offset) {
  assert(offset + bytes <= bytes_);
  glNamedBufferSubData(id(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes), values);
}

void Buffer::download(void* values, std::size_t bytes, std::size_t offset) const {
  assert(offset + bytes <= bytes_);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  readBuffer(id(), offset, bytes, values);
}

Texture::Texture(std::string_view name, GLenum format, int width, int height, int levels)
    : format_(format), width_(width), height_(height), levels_(levels) {
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &id);
  object_ = Object<TextureTraits>(id);
  glTextureStorage2D(id, levels, format, width, height);
  failIfOutOfMemory(name, bytes());
  const GLint filter = levels > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST;
  glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, filter);
  glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, levels > 1 ? GL_LINEAR : GL_NEAREST);
  glTextureParameteri(id, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  label(GL_TEXTURE, id, name);
}

Texture Texture::multisample(std::string_view name, GLenum format, glm::ivec2 size, int samples) {
  Texture texture;
  texture.format_ = format;
  texture.width_ = size.x;
  texture.height_ = size.y;
  texture.levels_ = 1;
  texture.samples_ = samples;
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_2D_MULTISAMPLE, 1, &id);
  texture.object_ = Object<TextureTraits>(id);
  glTextureStorage2DMultisample(id, samples, format, size.x, size.y, GL_TRUE);
  failIfOutOfMemory(name, texture.bytes());
  label(GL_TEXTURE, id, name);
  return texture;
}

std::size_t Texture::bytes() const {
  std::size_t sum = 0;
  for (int level = 0; level < levels_; ++level) {
    sum += texelBytes(format_) * static_cast<std::size_t>(std::max(1, width_ >> level)) *
           static_cast<std::size_t>(std::max(1, height_ >> level));
  }
  return sum * static_cast<std::size_t>(std::max(1, samples_));
}

std::size_t texelBytes(GLenum format) {
  switch (format) {
    case GL_R8:
      return 1;
    case GL_R16F:
    case GL_RG8:
      return 2;
    case GL_R32F:
    case GL_R32UI:
    case GL_RGBA8:
    case GL_SRGB8_ALPHA8:
    case GL_RGBA8_SNORM:
    case GL_RG16_SNORM:
    case GL_R11F_G11F_B10F:
    case GL_DEPTH_COMPONENT32F:
      return 4;
    case GL_RG32UI:
    case GL_RG32F:
    case GL_RGBA16F:
    case GL_DEPTH32F_STENCIL8:
      return 8;
    case GL_RGBA32F:
    case GL_RGBA32UI:
      return 16;
    default:
      assert(false && "a format without a stated size");
      return 0;
  }
}

void label(GLenum kind, GLuint id, std::string_view text) {
  glObjectLabel(kind, id, static_cast<GLsizei>(text.size()), text.data());
}

}  // namespace macula::gl
