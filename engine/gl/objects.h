// OpenGL objects that own their name: move-only, made with direct state access, labelled.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string_view>
#include <utility>

#include "engine/gl/gl.h"

namespace macula::gl {

/// Owns one GL object name; the Traits say how it is deleted.
template <typename Traits>
class Object {
 public:
  Object() = default;
  explicit Object(GLuint id) : id_(id) {}
  Object(Object&& old) noexcept : id_(std::exchange(old.id_, 0)) {}
  Object& operator=(Object&& old) noexcept {
    if (this != &old) {
      reset();
      id_ = std::exchange(old.id_, 0);
    }
    return *this;
  }
  Object(const Object&) = delete;
  Object& operator=(const Object&) = delete;
  ~Object() { reset(); }

  [[nodiscard]] GLuint id() const { return id_; }
  explicit operator bool() const { return id_ != 0; }
  void reset() {
    if (id_ != 0) Traits::remove(std::exchange(id_, 0));
  }

 private:
  GLuint id_ = 0;
};

struct BufferTraits {
  static void remove(GLuint id);
};
struct TextureTraits {
  static void remove(GLuint id);
};
struct SamplerTraits {
  static void remove(GLuint id);
};
struct FramebufferTraits {
  static void remove(GLuint id);
};
struct VertexArrayTraits {
  static void remove(GLuint id);
};
struct ProgramTraits {
  static void remove(GLuint id);
};
struct QueryTraits {
  static void remove(GLuint id);
};

using SamplerId = Object<SamplerTraits>;
using FramebufferId = Object<FramebufferTraits>;
using VertexArrayId = Object<VertexArrayTraits>;
using ProgramId = Object<ProgramTraits>;
using QueryId = Object<QueryTraits>;

/// An immutable buffer (glNamedBufferStorage).
class Buffer {
 public:
  Buffer() = default;
  /// @param bytes size, > 0 · @param data initial contents or nullptr
  /// @throws InputError where the GPU has no memory for it
  Buffer(std::string_view label, std::size_t bytes, const void* data = nullptr);
  template <typename T>
  static Buffer of(std::string_view label, std::span<const T> values) {
    return Buffer(label, values.size_bytes(), values.data());
  }
  [[nodiscard]] GLuint id() const { return object_.id(); }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  explicit operator bool() const { return static_cast<bool>(object_); }
  /// Replaces bytes [offset, offset + size of values).
  void upload(const void* values, std::size_t bytes, std::size_t offset = 0);
  /// Reads bytes [offset, offset + bytes), behind a barrier; waits for the GPU.
  void download(void* values, std::size_t bytes, std::size_t offset = 0) const;

 private:
  Object<BufferTraits> object_;
  std::size_t bytes_ = 0;
};

/// An immutable 2D texture (glTextureStorage2D).
class Texture {
 public:
  Texture() = default;
  /// @param format sized internal format · @param levels mip levels, >= 1
  Texture(std::string_view label, GLenum format, int width, int height, int levels = 1);
  /// glTextureStorage2DMultisample with fixed sample places. @param samples >= 1
  static Texture multisample(std::string_view label, GLenum format, glm::ivec2 size, int samples);
  [[nodiscard]] GLuint id() const { return object_.id(); }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] int levels() const { return levels_; }
  [[nodiscard]] GLenum format() const { return format_; }
  [[nodiscard]] int samples() const { return samples_; }  ///< 0: no multisample texture
  [[nodiscard]] std::size_t bytes() const;  ///< of all levels, by the format's texel size
  explicit operator bool() const { return static_cast<bool>(object_); }

 private:
  Object<TextureTraits> object_;
  GLenum format_ = 0;
  int width_ = 0;
  int height_ = 0;
  int levels_ = 0;
  int samples_ = 0;
};

/// Bytes of one texel of the sized formats that Macula uses.
[[nodiscard]] std::size_t texelBytes(GLenum format);

/// Names an object in debuggers and in debug messages (KHR_debug).
void label(GLenum kind, GLuint id, std::string_view text);

}  // namespace macula::gl
