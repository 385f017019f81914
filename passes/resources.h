// Resources that passes of different rooms hand to one another. What only one room uses, it
// declares itself.
#pragma once

#include "engine/frame/resource.h"

namespace macula::passes {

/// Depth seen by the shadow-casting light.
inline constexpr frame::Resource kShadowMap{"shadow map", GL_DEPTH_COMPONENT32F,
                                            frame::SizeRule::Declared, frame::ByteClass::Other,
                                            frame::Initial::Undefined};
/// Opaque depth, reversed: 1 at the near plane, 0 at the far plane.
inline constexpr frame::Resource kDepth{"depth", GL_DEPTH_COMPONENT32F, frame::SizeRule::Display,
                                        frame::ByteClass::GBuffer, frame::Initial::Zero};
/// Octahedral world normal of the opaque surface.
inline constexpr frame::Resource kNormal{"normal", GL_RG16_SNORM, frame::SizeRule::Display,
                                         frame::ByteClass::GBuffer, frame::Initial::Undefined};
/// Base colour (sRGB-encoded) and metallic.
inline constexpr frame::Resource kBaseColor{"base colour", GL_SRGB8_ALPHA8,
                                            frame::SizeRule::Display, frame::ByteClass::GBuffer,
                                            frame::Initial::Undefined};
/// Roughness, occlusion, kind, geometric normal (lib/surface.glsl).
inline constexpr frame::Resource kSurface{"surface", GL_RGBA8, frame::SizeRule::Display,
                                          frame::ByteClass::GBuffer, frame::Initial::Undefined};
/// Linear emitted radiance.
inline constexpr frame::Resource kEmissive{"emissive", GL_R11F_G11F_B10F, frame::SizeRule::Display,
                                           frame::ByteClass::GBuffer, frame::Initial::Undefined};
/// Linear radiance of the image so far.
inline constexpr frame::Resource kHdrColor{"HDR colour", GL_RGBA16F, frame::SizeRule::Display,
                                           frame::ByteClass::Other, frame::Initial::Background};
/// Opaque depth of the texels at which reduced-rate transparency is drawn.
inline constexpr frame::Resource kReducedDepth{
    "reduced-rate depth", GL_DEPTH_COMPONENT32F, frame::SizeRule::DisplayOverR,
    frame::ByteClass::Overhead, frame::Initial::Undefined};
/// Reduced-rate transparency over nothing: premultiplied colour, coverage.
inline constexpr frame::Resource kReducedColor{
    "reduced-rate transparency", GL_RGBA16F, frame::SizeRule::DisplayOverR,
    frame::ByteClass::Overhead, frame::Initial::Undefined};
/// The image: RGBA8, encoded.
inline constexpr frame::Resource kDisplayColor{"display colour", GL_RGBA8, frame::SizeRule::Output,
                                               frame::ByteClass::Other, frame::Initial::Undefined};
/// Tone-mapped image before encoding, linear.
inline constexpr frame::Resource kLinearColor{"linear colour", GL_RGBA32F, frame::SizeRule::Output,
                                              frame::ByteClass::Other, frame::Initial::Undefined};

}  // namespace macula::passes
