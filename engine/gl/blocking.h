// Every call by which the CPU may wait for the GPU: nothing else in Macula does, and each is
// counted here.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "engine/gl/gl.h"

namespace macula::gl {

enum class Blocking : std::uint8_t {
  Finish,       ///< glFinish
  QueryResult,  ///< a query's result, whether it is there or not
  BufferRead,   ///< glGetNamedBufferSubData
  TextureRead,  ///< glGetTextureImage, glGetTextureSubImage
  PixelRead,    ///< glReadPixels
  FenceWait,    ///< glClientWaitSync with a time-out
};
inline constexpr std::size_t kBlockingKinds = 6;

/// Calls so far, and how long they took.
struct BlockingCount {
  std::array<std::uint64_t, kBlockingKinds> calls{};
  double waitedMs = 0.0;  ///< the sum, in milliseconds

  [[nodiscard]] std::uint64_t of(Blocking kind) const {
    return calls[static_cast<std::size_t>(kind)];
  }
  [[nodiscard]] std::uint64_t total() const;
};

/// Of the calling thread, since it began.
[[nodiscard]] const BlockingCount& blockingCount();

// The calls. Those that read put no memory barriers.

void finish();
/// Waits until the result of a query is there.
[[nodiscard]] std::uint64_t queryResult(GLuint query);
/// Reads bytes [offset, offset + bytes) of a buffer.
void readBuffer(GLuint buffer, std::size_t offset, std::size_t bytes, void* into);
/// What is read of a texture or a framebuffer, as glGetTextureImage takes it.
struct PixelLayout {
  GLenum format;
  GLenum type;
};
/// Reads level 0, rows from the bottom and without gaps. @param bytes room in `into`
void readTexture(GLuint texture, PixelLayout layout, std::size_t bytes, void* into);
/// The same of a rectangle. @param low, extent texels
void readTexture(GLuint texture, glm::ivec2 low, glm::ivec2 extent, PixelLayout layout,
                 std::size_t bytes, void* into);
/// Reads the lower left corner of the bound framebuffer.
void readPixels(glm::ivec2 size, PixelLayout layout, void* into);
/// Waits until the GPU has reached a fence.
void waitFor(GLsync fence);

// What never waits, and thus is not counted.

/// The result of a query where it is there.
[[nodiscard]] std::optional<std::uint64_t> resultIfThere(GLuint query);
/// Whether the GPU has reached a fence; commands before it are submitted.
[[nodiscard]] bool isReached(GLsync fence);

}  // namespace macula::gl
