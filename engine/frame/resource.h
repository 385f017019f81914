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
  Surface,            ///< roughness, occlusion, kind, geometric normal (lib/surface.glsl)
  Emissive,           ///< linear emitted radiance
  ShadingRate,        ///< levels of a tile of the resized image and its eight neighbours,
                      ///< two bits each: samples are 2^level texels apart
  LodTiles,           ///< numbers of the tiles of each rate
  LodTotals,          ///< indirect dispatches and counts: see shaders/shared/lod_totals.h
  LodSamples,         ///< low-rate samples: what was shaded, distance, normal
  LodHoles,           ///< pixels that no sample fits
  ShadingParts,       ///< shadow, ambient occlusion, noise of each pixel
  HdrColor,           ///< linear radiance of the image so far
  ResizedDepth,       ///< opaque depth of the texels at which resized transparency is drawn
  ResizedColor,       ///< resized transparency over nothing: premultiplied colour, coverage
  FragmentCount,      ///< transparent fragments per pixel that pass opaque depth
  PredictedCount,     ///< the same as the last frame lets expect
  FrontNormal,        ///< normal of the nearest transparent fragment; kept as history
  Importance,         ///< importance of each pixel, fixed point, 1/65536 per unit
  ImportanceFactors,  ///< periphery, depth complexity, Fresnel, total; for heat maps only
  FragmentRange,      ///< x: first slot of the pixel, y: number of its slots, k(p)
  FragmentFill,       ///< slots in use
  FragmentLock,       ///< one spin lock a pixel
  FragmentKeys,       ///< per slot: depth key, id; or a whole packed fragment
  FragmentColors,     ///< per slot: premultiplied RGBA16F
  FragmentLinks,      ///< per slot of a list: number of the next one plus one
  TailSums,           ///< sum of tau c, sum of tau of what was left out or weighted
  RoutedKeys,         ///< per multisample slot: depth key, id
  RoutedColors,       ///< per multisample slot: premultiplied RGBA16F
  RoutedStencil,      ///< opaque depth and the stencil that routes
  PeelDepth,          ///< depth of the layer being peeled
  PeelIds,            ///< least id at that depth
  PeelColor,          ///< the layer's colour
  PeelLast,           ///< key of the last layer
  PeelSum,            ///< layers so far: colour, transmittance
  WeightedColors,     ///< weighted sums of wboit
  SliceSums,          ///< per tile and depth slice: count, optical depth, colour
  TileDepth,          ///< farthest opaque depth of a tile
  CountBins,          ///< how many pixels have 1, 2, ... fragments
  StripSums,          ///< per strip: what an allocation sums
  CoveredTiles,       ///< places of the tiles that transparent fragments cover
  CoveredSamples,     ///< places of those pixels of a sample that they cover
  SlotBids,           ///< slots that a pixel takes at the high and the low price
  DepthRange,         ///< nearest and farthest transparent depth of a pixel
  Occupancy,          ///< per pixel: which depth intervals hold a fragment
  CullDepth,          ///< opaque depth, or behind the k-th occupied interval if that is nearer
  ColorSums,          ///< sum of the premultiplied colours of a pixel's fragments
  NearestColor,       ///< bits of the nearest fragment's depth, the last eight its colour
  NetworkOutput,      ///< what it says of each tile: see shaders/lib/network_output.glsl
  OitTotals,          ///< sums over the image: see shaders/shared/oit_totals.h
  LinearColor,        ///< tone-mapped image before encoding, linear
  DisplayColor,       ///< the image: RGBA8, encoded
  HeatmapColor,       ///< what is shown in its place: a quantity as colours over it
  Count
};

inline constexpr std::size_t kResourceCount = static_cast<std::size_t>(Resource::Count);

/// How large a texture is.
enum class SizeRule : std::uint8_t {
  Output,          ///< the window or image
  Display,         ///< samples: the output times supersampling
  DisplayOverR,    ///< display / r; allocated at full size, so that a change of r moves viewports
                   ///< only
  Fixed,           ///< set by FrameResources::setFixedSize
  DisplaySamples,  ///< a multisample texture, see FrameResources::setMultisamples
  Bytes,           ///< a buffer, set by FrameResources::setBufferBytes
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
