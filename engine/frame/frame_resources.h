// The memory behind the resource ids: allocated once, sized by rule, counted to the byte.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <initializer_list>
#include <span>
#include <vector>

#include "engine/frame/resource.h"
#include "engine/gl/objects.h"

namespace macula::frame {

/// Bytes by class, as the report states them.
struct ResourceBytes {
  std::uint64_t oit = 0;
  std::uint64_t overhead = 0;
  std::uint64_t gbuffer = 0;
  std::uint64_t other = 0;
};

/// Owns the textures and buffers of one frame list.
class FrameResources {
 public:
  void setFixedSize(Resource texture, glm::ivec2 size);
  void setBufferBytes(Resource buffer, std::size_t bytes);
  /// Samples of the textures whose size rule is DisplaySamples, >= 1.
  void setMultisamples(int samples) { multisamples_ = samples; }
  void setBackground(const glm::vec3& linear) { background_ = linear; }

  /// Makes what is listed and not there at the right size, and releases what is not listed.
  /// @param maxStorageBlockBytes a larger buffer is refused with an InputError
  void allocate(std::span<const Resource> needed, glm::ivec2 outputSize, glm::ivec2 displaySize,
                std::int64_t maxStorageBlockBytes);

  [[nodiscard]] const gl::Texture& texture(Resource r) const;
  [[nodiscard]] const gl::Buffer& buffer(Resource r) const;
  [[nodiscard]] bool has(Resource r) const;
  [[nodiscard]] ResourceBytes bytes() const;
  /// Bytes of one resource; 0 where it is not allocated.
  [[nodiscard]] std::uint64_t bytesOf(Resource r) const;

  /// The framebuffer with these attachments; made on first use.
  /// @param depth Resource::Count for none
  GLuint framebuffer(std::initializer_list<Resource> colors, Resource depth);

  /// Replaces the first bytes of a buffer. @param bytes at most the buffer's
  void upload(Resource buffer, const void* values, std::size_t bytes);

  /// Fills a resource with its clear value.
  void clear(Resource r) const;

 private:
  struct Cached {
    std::vector<Resource> colors;
    Resource depth;
    gl::FramebufferId id;
  };
  [[nodiscard]] glm::ivec2 sizeOf(const ResourceInfo& info, glm::ivec2 output,
                                  glm::ivec2 display) const;

  std::array<gl::Texture, kResourceCount> textures_;
  std::array<gl::Buffer, kResourceCount> buffers_;
  std::array<glm::ivec2, kResourceCount> fixedSizes_{};
  std::array<std::size_t, kResourceCount> bufferBytes_{};
  int multisamples_ = 1;
  std::vector<Cached> framebuffers_;
  glm::vec3 background_{0.0F};
};

}  // namespace macula::frame
