// Limits of a context, in one table: those that decide whether a pass fits the device.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "engine/gl/gl.h"

namespace macula::gl {

enum class Limit : std::uint8_t {
  StorageBindings,
  VertexStorageBlocks,
  FragmentStorageBlocks,
  ComputeStorageBlocks,
  CombinedStorageBlocks,
  StorageBlockBytes,
  ImageUnits,
  FragmentImages,
  ComputeImages,
  CombinedImages,
  CombinedOutputs,
  FragmentTextures,
  ComputeTextures,
  TextureUnits,
  ColorAttachments,
  DrawBuffers,
  TextureSide,
  FramebufferWidth,
  FramebufferHeight,
  UniformBindings,
  UniformBlockBytes,
  GroupThreads,
  GroupBytes,
};
inline constexpr std::size_t kLimits = static_cast<std::size_t>(Limit::GroupBytes) + 1;

struct LimitRow {
  Limit limit;
  GLenum query;
  std::string_view name;    ///< GL's, with GL_
  std::string_view what;    ///< is limited, in the plural
  std::int64_t guaranteed;  ///< what every device has (OpenGL 4.5, chapter 23)
};

/// One row for each limit, in the order of the enumeration.
[[nodiscard]] std::span<const LimitRow> limitRows();
[[nodiscard]] inline const LimitRow& rowOf(Limit limit) {
  return limitRows()[static_cast<std::size_t>(limit)];
}

/// What one device offers.
class Limits {
 public:
  [[nodiscard]] std::int64_t& operator[](Limit limit) {
    return values_[static_cast<std::size_t>(limit)];
  }
  [[nodiscard]] std::int64_t operator[](Limit limit) const {
    return values_[static_cast<std::size_t>(limit)];
  }

 private:
  std::array<std::int64_t, kLimits> values_{};
};

/// Of the current context.
[[nodiscard]] Limits readLimits();
/// The least that OpenGL 4.5 lets a device have.
[[nodiscard]] Limits guaranteedLimits();

}  // namespace macula::gl
