// The resources of a frame: typed ids, and one table that says what each of them is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "engine/gl/gl.h"

namespace macula::frame {

/// Everything that one pass hands to another.
enum class Resource : std::uint8_t {
  ShadowMap,          ///< depth seen by the shadow-casting light
  Depth,              ///< opaque depth, reversed: 1 at the near plane, 0 at the far plane
  Normal,             ///< octahedral world normal of the opaque surface
  BaseColor,          ///< base colour (sRGB-encoded) and metallic
  Surface,            ///< roughness, occlusion, flags
  Emissive,           ///< linear emitted radiance
  HdrColor,           ///< linear radiance of the image so far
  FragmentCount,      ///< transparent fragments per pixel that pass opaque depth
  FrontNormal,        ///< normal of the nearest transparent fragment; kept as history
  Importance,         ///< importance of each pixel, fixed point, 1/65536 per unit
  ImportanceFactors,  ///< periphery, depth complexity, Fresnel, total; for heat maps only
  FragmentRange,      ///< x: first slot of the pixel, y: number of its slots, k(p)
  FragmentFill,       ///< slots in use
  FragmentLock,       ///< one spin lock a pixel
  FragmentKeys,       ///< per slot: depth key, id
  FragmentColors,     ///< per slot: premultiplied RGBA16F
  OitTotals,          ///< sums over the image: see shaders/shared/oit_totals.h
  LinearColor,        ///< tone-mapped image before encoding, linear
  DisplayColor,       ///< the image that is shown: RGBA8, encoded
  Count
};

inline constexpr std::size_t kResourceCount = static_cast<std::size_t>(Resource::Count);

/// How large a texture is.
enum class SizeRule : std::uint8_t {
  Output,        ///< the window or image
  Display,       ///< samples: the output times supersampling
  DisplayOverR,  ///< display / r; allocated at full size, so that a change of r moves viewports
                 ///< only
  Fixed,         ///< set by FrameResources::setFixedSize
  Bytes,         ///< a buffer, set by FrameResources::setBufferBytes
};

/// Which line of the report a resource's bytes belong to.
enum class ByteClass : std::uint8_t {
  Oit,       ///< fragment storage: what a budget limits
  Overhead,  ///< what else transparency needs
  GBuffer,
  Other,
};

/// What a resource holds where no pass of this frame wrote it.
enum class ClearKind : std::uint8_t {
  Zero,
  Background,  ///< the background colour of the settings
  Never,       ///< contents persist, or are never read unwritten
};

struct ResourceInfo {
  Resource id;
  std::string_view name;
  GLenum format;  ///< 0 for buffers
  SizeRule size;
  ByteClass bytes;
  ClearKind clear;
};

[[nodiscard]] const ResourceInfo& infoOf(Resource resource);
[[nodiscard]] std::string_view nameOf(Resource resource);

}  // namespace macula::frame
