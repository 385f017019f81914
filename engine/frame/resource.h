// A resource of a frame: what one texture or buffer is, stated once by the room that owns it.
#pragma once

#include <cstdint>
#include <string_view>

#include "engine/gl/gl.h"

namespace macula::frame {

/// Where the size of a resource comes from.
enum class SizeRule : std::uint8_t {
  Output,          ///< texture: pixels of the window or image
  Display,         ///< texture: samples, which are the output's pixels times supersampling
  DisplayOverR,    ///< texture: display / r; allocated at full size, so that a change of r moves
                   ///< viewports only
  DisplaySamples,  ///< multisample texture of the display's size; a declaration states its samples
  Declared,        ///< texture or buffer: a declaration states its extent or its bytes
};

/// Which line of the report a resource's bytes belong to.
enum class ByteClass : std::uint8_t {
  Oit,       ///< fragment storage: what a budget limits
  Overhead,  ///< what else transparency needs
  GBuffer,
  Other,
  Report,  ///< none: a frame that reports nothing does without it
};

/// What a resource holds when a pass reads it and no pass of this frame has written it.
enum class Initial : std::uint8_t {
  Zero,
  Background,  ///< the background colour of the settings
  Undefined,   ///< a read without an earlier write is an error of the frame
};

/// Description of a texture or buffer. Its identity is its address: each is one constant, declared
/// by the feature that owns it, and never copied. Memory belongs to FrameResources.
class Resource {
 public:
  /// @param internalFormat of a texture; 0 for a buffer
  constexpr Resource(std::string_view uniqueName, GLenum internalFormat, SizeRule sizeRule,
                     ByteClass byteClass, Initial initialContents)
      : name(uniqueName),
        format(internalFormat),
        size(sizeRule),
        bytes(byteClass),
        initial(initialContents) {}
  Resource(const Resource&) = delete;
  Resource& operator=(const Resource&) = delete;

  [[nodiscard]] constexpr bool isBuffer() const { return format == 0; }
  [[nodiscard]] bool operator==(const Resource& other) const { return this == &other; }

  std::string_view name;  ///< in reports, errors and debuggers; unique
  GLenum format;          ///< 0 for a buffer
  SizeRule size;
  ByteClass bytes;
  Initial initial;
};

}  // namespace macula::frame
