// Resources that features of transparency hand to one another. What one feature uses alone, such as
// its scratch memory, it declares in its own file.
#pragma once

#include "engine/frame/resource.h"

namespace macula::passes {

/// Transparent fragments per pixel that pass opaque depth. 32-bit, because 16-bit floats stop
/// counting at 2,048.
inline constexpr frame::Resource kFragmentCount{"fragment count", GL_R32F, frame::SizeRule::Display,
                                                frame::ByteClass::Overhead, frame::Initial::Zero};
/// The same, reprojected from the last frame.
inline constexpr frame::Resource kPredictedCount{
    "predicted count", GL_R32F, frame::SizeRule::Display, frame::ByteClass::Overhead,
    frame::Initial::Undefined};
/// Nearest and farthest transparent depth of a pixel.
inline constexpr frame::Resource kDepthRange{"depth range", GL_RG32F, frame::SizeRule::Display,
                                             frame::ByteClass::Overhead, frame::Initial::Undefined};
/// Normal of the nearest transparent fragment; read as history.
inline constexpr frame::Resource kFrontNormal{"front normal", GL_RGBA8_SNORM,
                                              frame::SizeRule::Display, frame::ByteClass::Overhead,
                                              frame::Initial::Zero};
/// Importance of each pixel, fixed point, 1/65536 per unit.
inline constexpr frame::Resource kImportance{"importance", GL_R32UI, frame::SizeRule::Display,
                                             frame::ByteClass::Overhead, frame::Initial::Zero};
/// Periphery, depth complexity, Fresnel, total; for heat maps only.
inline constexpr frame::Resource kImportanceFactors{
    "importance factors", GL_RGBA16F, frame::SizeRule::Display, frame::ByteClass::Overhead,
    frame::Initial::Zero};
/// x: first slot of the pixel, y: number of its slots, k(p).
inline constexpr frame::Resource kFragmentRange{"fragment range", GL_RG32UI,
                                                frame::SizeRule::Display,
                                                frame::ByteClass::Overhead, frame::Initial::Zero};
/// Slots in use.
inline constexpr frame::Resource kFragmentFill{"fragment fill", GL_R32UI, frame::SizeRule::Display,
                                               frame::ByteClass::Overhead, frame::Initial::Zero};
/// Per slot: depth key, id; or a whole packed fragment.
inline constexpr frame::Resource kFragmentKeys{"fragment keys", 0, frame::SizeRule::Declared,
                                               frame::ByteClass::Oit, frame::Initial::Undefined};
/// Per slot: premultiplied RGBA16F.
inline constexpr frame::Resource kFragmentColors{"fragment colours", 0, frame::SizeRule::Declared,
                                                 frame::ByteClass::Oit, frame::Initial::Undefined};
/// Per slot of a list: number of the next one plus one.
inline constexpr frame::Resource kFragmentLinks{"fragment links", 0, frame::SizeRule::Declared,
                                                frame::ByteClass::Oit, frame::Initial::Undefined};
/// Sum of tau c, sum of tau of what was left out or weighted.
inline constexpr frame::Resource kTailSums{"tail sums", GL_RGBA32F, frame::SizeRule::Display,
                                           frame::ByteClass::Oit, frame::Initial::Undefined};
/// Per tile and depth slice: count, optical depth, colour.
inline constexpr frame::Resource kSliceSums{"slice sums", 0, frame::SizeRule::Declared,
                                            frame::ByteClass::Overhead, frame::Initial::Zero};
/// Places of the tiles that transparent fragments cover.
inline constexpr frame::Resource kCoveredTiles{"covered tiles", 0, frame::SizeRule::Declared,
                                               frame::ByteClass::Overhead,
                                               frame::Initial::Undefined};
/// Opaque depth, or behind the k-th occupied interval if that is nearer.
inline constexpr frame::Resource kCullDepth{"cull depth", GL_DEPTH_COMPONENT32F,
                                            frame::SizeRule::Display, frame::ByteClass::Overhead,
                                            frame::Initial::Undefined};
/// What a network predicts for each tile: see shaders/lib/network_output.glsl.
inline constexpr frame::Resource kNetworkOutput{"network output", GL_RGBA32UI,
                                                frame::SizeRule::Declared,
                                                frame::ByteClass::Overhead, frame::Initial::Zero};
/// Sum of the premultiplied colours of a pixel's fragments.
inline constexpr frame::Resource kColorSums{"colour sums", GL_RGBA32F, frame::SizeRule::Display,
                                            frame::ByteClass::Overhead, frame::Initial::Undefined};
/// Bits of the nearest fragment's depth, the last eight its colour.
inline constexpr frame::Resource kNearestColor{"nearest colour", GL_RGBA32F,
                                               frame::SizeRule::Display, frame::ByteClass::Overhead,
                                               frame::Initial::Undefined};
/// Per multisample slot: depth key, id.
inline constexpr frame::Resource kRoutedKeys{"routed keys", GL_RG32UI,
                                             frame::SizeRule::DisplaySamples, frame::ByteClass::Oit,
                                             frame::Initial::Undefined};
/// Per multisample slot: premultiplied RGBA16F.
inline constexpr frame::Resource kRoutedColors{"routed colours", GL_RGBA16F,
                                               frame::SizeRule::DisplaySamples,
                                               frame::ByteClass::Oit, frame::Initial::Undefined};
/// Sums over the image: see shaders/shared/oit_totals.h.
inline constexpr frame::Resource kOitTotals{"transparency totals", 0, frame::SizeRule::Declared,
                                            frame::ByteClass::Overhead, frame::Initial::Zero};
/// Transparent fragments per pixel for the report, where no pass of the frame counts them.
inline constexpr frame::Resource kReportCount{"report's fragment count", GL_R32F,
                                              frame::SizeRule::Display, frame::ByteClass::Report,
                                              frame::Initial::Undefined};
/// What a frame did with its fragments: see shaders/shared/oit_totals.h.
inline constexpr frame::Resource kOitStatistics{"transparency statistics", 0,
                                                frame::SizeRule::Declared, frame::ByteClass::Report,
                                                frame::Initial::Undefined};

}  // namespace macula::passes
