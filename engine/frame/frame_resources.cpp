#include "engine/frame/frame_resources.h"

#include <algorithm>
#include <cassert>
#include <glm/gtc/type_ptr.hpp>

#include "engine/core/error.h"

namespace macula::frame {
namespace {

std::size_t indexOf(Resource r) {
  return static_cast<std::size_t>(r);
}

bool isInteger(GLenum format) {
  return format == GL_R32UI || format == GL_RG32UI || format == GL_RGBA32UI;
}

}  // namespace

void FrameResources::setFixedSize(Resource texture, glm::ivec2 size) {
  fixedSizes_[indexOf(texture)] = size;
}

void FrameResources::setBufferBytes(Resource buffer, std::size_t bytes) {
  bufferBytes_[indexOf(buffer)] = bytes;
}

glm::ivec2 FrameResources::sizeOf(const ResourceInfo& info, glm::ivec2 output,
                                  glm::ivec2 display) const {
  switch (info.size) {
    case SizeRule::Output:
      return output;
    case SizeRule::Display:
    case SizeRule::DisplayOverR:
    case SizeRule::DisplaySamples:
      return display;
    case SizeRule::Fixed:
      return fixedSizes_[indexOf(info.id)];
    case SizeRule::Bytes:
      break;
  }
  return {0, 0};
}

void FrameResources::allocate(std::span<const Resource> needed, glm::ivec2 outputSize,
                              glm::ivec2 displaySize, std::int64_t maxStorageBlockBytes) {
  bool changed = false;
  for (std::size_t i = 0; i < kResourceCount; ++i) {
    const auto resource = static_cast<Resource>(i);
    const ResourceInfo& info = infoOf(resource);
    gl::Texture& texture = textures_[i];
    gl::Buffer& buffer = buffers_[i];
    if (std::find(needed.begin(), needed.end(), resource) == needed.end()) {
      changed = changed || texture || buffer;
      texture = {};
      buffer = {};
      continue;
    }
    if (info.size == SizeRule::Bytes) {
      const std::size_t bytes = bufferBytes_[i];
      if (static_cast<std::int64_t>(bytes) > maxStorageBlockBytes) {
        failInput(
            "{} needs {} bytes, and this GPU takes {} in one buffer; lower --k-ave or "
            "--oit-memory, or --size",
            info.name, bytes, maxStorageBlockBytes);
      }
      if (buffer.bytes() == bytes) continue;
      buffer = {};
      buffer = gl::Buffer(info.name, bytes);
      clear(resource);
    } else {
      const glm::ivec2 size = sizeOf(info, outputSize, displaySize);
      const int samples = info.size == SizeRule::DisplaySamples ? multisamples_ : 0;
      if (texture.width() == size.x && texture.height() == size.y && texture.samples() == samples) {
        continue;
      }
      texture = {};
      texture = samples > 0 ? gl::Texture::multisample(info.name, info.format, size, samples)
                            : gl::Texture(info.name, info.format, size.x, size.y);
      if (info.clear != ClearKind::Never) clear(resource);
    }
    changed = true;
  }
  if (changed) framebuffers_.clear();
}

bool FrameResources::has(Resource r) const {
  return static_cast<bool>(textures_[indexOf(r)]) || static_cast<bool>(buffers_[indexOf(r)]);
}

const gl::Texture& FrameResources::texture(Resource r) const {
  assert(textures_[indexOf(r)] && "declared resources are allocated");
  return textures_[indexOf(r)];
}

const gl::Buffer& FrameResources::buffer(Resource r) const {
  assert(buffers_[indexOf(r)] && "declared resources are allocated");
  return buffers_[indexOf(r)];
}

void FrameResources::upload(Resource r, const void* values, std::size_t bytes) {
  assert(bytes <= buffer(r).bytes());
  buffers_[indexOf(r)].upload(values, bytes);
}

std::uint64_t FrameResources::bytesOf(Resource r) const {
  const std::size_t i = indexOf(r);
  return textures_[i] ? textures_[i].bytes() : buffers_[i].bytes();
}

ResourceBytes FrameResources::bytes() const {
  ResourceBytes sum;
  for (std::size_t i = 0; i < kResourceCount; ++i) {
    const auto resource = static_cast<Resource>(i);
    const std::uint64_t bytes = bytesOf(resource);
    switch (infoOf(resource).bytes) {
      case ByteClass::Oit:
        sum.oit += bytes;
        break;
      case ByteClass::Overhead:
        sum.overhead += bytes;
        break;
      case ByteClass::GBuffer:
        sum.gbuffer += bytes;
        break;
      case ByteClass::Other:
        sum.other += bytes;
        break;
    }
  }
  return sum;
}

GLuint FrameResources::framebuffer(std::initializer_list<Resource> colors, Resource depth) {
  for (const Cached& cached : framebuffers_) {
    if (cached.depth == depth &&
        std::equal(cached.colors.begin(), cached.colors.end(), colors.begin(), colors.end())) {
      return cached.id.id();
    }
  }
  GLuint id = 0;
  glCreateFramebuffers(1, &id);
  gl::FramebufferId owner(id);
  std::vector<GLenum> buffers;
  for (const Resource color : colors) {
    const GLenum attachment = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size());
    glNamedFramebufferTexture(id, attachment, texture(color).id(), 0);
    buffers.push_back(attachment);
  }
  glNamedFramebufferDrawBuffers(id, static_cast<GLsizei>(buffers.size()), buffers.data());
  if (depth != Resource::Count) {
    const bool stencil = texture(depth).format() == GL_DEPTH32F_STENCIL8;
    glNamedFramebufferTexture(id, stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
                              texture(depth).id(), 0);
  }
  assert(glCheckNamedFramebufferStatus(id, GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
  framebuffers_.push_back({colors, depth, std::move(owner)});
  return id;
}

void FrameResources::clear(Resource r) const {
  const ResourceInfo& info = infoOf(r);
  if (info.size == SizeRule::Bytes) {
    glClearNamedBufferData(buffer(r).id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
  } else if (info.clear == ClearKind::Background) {
    const glm::vec4 value(background_, 1.0F);
    glClearTexImage(texture(r).id(), 0, GL_RGBA, GL_FLOAT, glm::value_ptr(value));
  } else if (info.format == GL_DEPTH_COMPONENT32F) {
    glClearTexImage(texture(r).id(), 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
  } else if (isInteger(info.format)) {
    const GLenum channels = info.format == GL_RGBA32UI ? GL_RGBA_INTEGER
                            : info.format == GL_RG32UI ? GL_RG_INTEGER
                                                       : GL_RED_INTEGER;
    glClearTexImage(texture(r).id(), 0, channels, GL_UNSIGNED_INT, nullptr);
  } else {
    glClearTexImage(texture(r).id(), 0, GL_RGBA, GL_FLOAT, nullptr);
  }
}

}  // namespace macula::frame
