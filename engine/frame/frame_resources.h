// The memory behind the resources: allocated once, sized by rule, counted to the byte.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <unordered_map>
#include <vector>

#include "engine/frame/barriers.h"
#include "engine/frame/resource.h"
#include "engine/frame/transient.h"
#include "engine/gl/objects.h"

namespace macula::frame {

/// Bytes as the report states them: of each class, the largest sum alive at once in a frame.
struct ResourceBytes {
  std::uint64_t oit = 0;
  std::uint64_t overhead = 0;  ///< oit + overhead: the largest sum of both classes alive at once
  std::uint64_t gbuffer = 0;
  std::uint64_t other = 0;
  std::uint64_t total = 0;  ///< allocated: less than the sum where classes share memory
};

/// What a frame needs of one resource.
struct Demand {
  const Resource* resource = nullptr;
  std::size_t bytes = 0;   ///< of a buffer
  glm::ivec2 size{0};      ///< texels of a texture
  int samples = 0;         ///< of a multisample texture; 0: none
  Lifetime life;           ///< where transient
  bool transient = false;  ///< a buffer whose memory others may use outside of its life
};

/// The part of a buffer that holds one resource.
class BufferRange {
 public:
  BufferRange(const gl::Buffer& buffer, std::size_t offset, std::size_t bytes)
      : buffer_(&buffer), offset_(offset), bytes_(bytes) {}
  [[nodiscard]] GLuint id() const { return buffer_->id(); }
  [[nodiscard]] std::size_t offset() const { return offset_; }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  /// Reads bytes from the start of the range, behind a barrier; waits for the GPU.
  void download(void* values, std::size_t bytes) const;

 private:
  const gl::Buffer* buffer_;
  std::size_t offset_;
  std::size_t bytes_;
};

/// Owns the textures and buffers of one frame list. A slot is the number of a resource in it, from
/// one allocation to the next.
class FrameResources {
 public:
  static constexpr std::uint32_t kNoSlot = ~0U;
  static constexpr std::size_t kMostTargets = 8;  ///< colours; every GPU has as many

  void setBackground(const glm::vec3& linear) { background_ = linear; }

  /// Makes what is asked for and not there at the right size, and releases everything else.
  /// @param maxStorageBlockBytes a larger buffer is refused with an InputError
  void allocate(std::span<const Demand> demands, std::int64_t maxStorageBlockBytes);

  [[nodiscard]] std::uint32_t slotOf(const Resource& r) const;
  [[nodiscard]] const Resource& resourceAt(std::uint32_t slot) const {
    return *slots_[slot].resource;
  }
  [[nodiscard]] const gl::Texture& textureAt(std::uint32_t slot) const;
  [[nodiscard]] BufferRange bufferAt(std::uint32_t slot) const;
  [[nodiscard]] std::uint32_t slots() const { return static_cast<std::uint32_t>(slots_.size()); }
  /// Where each slot lies.
  [[nodiscard]] std::vector<MemoryRange> memory() const;

  [[nodiscard]] bool has(const Resource& r) const { return slotOf(r) != kNoSlot; }
  [[nodiscard]] const gl::Texture& texture(const Resource& r) const { return textureAt(slotOf(r)); }
  [[nodiscard]] BufferRange buffer(const Resource& r) const { return bufferAt(slotOf(r)); }

  /// What there is, by slot.
  [[nodiscard]] std::vector<const Resource*> list() const;
  [[nodiscard]] ResourceBytes bytes() const { return bytes_; }
  /// Bytes of one resource while it is alive; 0 where it is not allocated.
  [[nodiscard]] std::uint64_t bytesOf(const Resource& r) const;

  /// The framebuffer with these attachments; made on first use.
  /// @param colors slots by output location, kNoSlot: none · @param depth kNoSlot: none
  /// @throws InputError where the device does not draw to them together
  GLuint framebuffer(const std::array<std::uint32_t, kMostTargets>& colors, std::uint32_t depth);

  /// Replaces the first bytes of a buffer. @param bytes at most the buffer's
  void upload(const Resource& buffer, const void* values, std::size_t bytes);
  /// Fills a resource with its initial contents.
  void clear(std::uint32_t slot) const;
  /// Fills a buffer, or a R32UI texture, with one word.
  void fill(std::uint32_t slot, std::uint32_t word) const;

  // Readers of what a frame left behind. They put the barriers that they need.

  /// Texels of a texture, rows from the bottom. @param format, type as of glGetTextureImage
  template <typename T>
  [[nodiscard]] std::vector<T> readTexture(const Resource& r, GLenum format, GLenum type) const {
    const gl::Texture& t = texture(r);
    std::vector<T> texels(static_cast<std::size_t>(t.width()) *
                          static_cast<std::size_t>(t.height()));
    read(r, format, type, texels.size() * sizeof(T), texels.data());
    return texels;
  }
  template <typename T>
  [[nodiscard]] std::vector<T> readBuffer(const Resource& r) const {
    const BufferRange range = buffer(r);
    std::vector<T> values(range.bytes() / sizeof(T));
    range.download(values.data(), values.size() * sizeof(T));
    return values;
  }
  void read(const Resource& r, GLenum format, GLenum type, std::size_t bytes, void* texels) const;
  /// A texture for GL commands after the frame. @param use their bit of glMemoryBarrier
  [[nodiscard]] const gl::Texture& textureFor(const Resource& r, GLbitfield use) const;

 private:
  struct Slot {
    const Resource* resource = nullptr;
    gl::Texture texture;
    gl::Buffer buffer;           ///< of its own, where it is not transient
    TransientPlan::Place place;  ///< else
    std::size_t bytes = 0;       ///< of a buffer
    bool transient = false;
    Lifetime life;
  };
  struct Framebuffer {
    std::array<std::uint32_t, kMostTargets> colors;
    std::uint32_t depth;
    gl::FramebufferId id;
  };
  [[noreturn]] void refuseTargets(const std::array<std::uint32_t, kMostTargets>& colors,
                                  std::uint32_t depth, GLenum status) const;
  /// @returns whether the texture is new
  bool makeTexture(Slot& slot, const Demand& demand);
  void makeBuffer(Slot& slot, const Demand& demand);
  void placeTransients(std::span<const Demand> demands, std::int64_t maxStorageBlockBytes);
  void countBytes();

  std::vector<Slot> slots_;
  std::unordered_map<const Resource*, std::uint32_t> slotByResource_;
  TransientPlan transients_;
  std::vector<gl::Buffer> blocks_;  ///< of transient buffers
  std::vector<Framebuffer> framebuffers_;
  ResourceBytes bytes_;
  glm::vec3 background_{0.0F};
};

}  // namespace macula::frame
