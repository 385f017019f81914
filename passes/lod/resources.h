// Resources of the level of detail. All are allocated for full rate, so that a change of r
// allocates nothing.
#pragma once

#include "engine/frame/resource.h"

namespace macula::passes {

/// Per tile of the reduced-rate image L: levels of the tile and its eight neighbours, two bits
/// each; samples are 2^level texels apart.
inline constexpr frame::Resource kShadingRate{"shading rate", GL_R32UI, frame::SizeRule::Declared,
                                              frame::ByteClass::Other, frame::Initial::Undefined};
/// Numbers of the tiles of each rate.
inline constexpr frame::Resource kLodTiles{"level-of-detail tiles", 0, frame::SizeRule::Declared,
                                           frame::ByteClass::Other, frame::Initial::Undefined};
/// Indirect dispatches and counts: see shaders/shared/lod_totals.h.
inline constexpr frame::Resource kLodTotals{"level-of-detail totals", 0, frame::SizeRule::Declared,
                                            frame::ByteClass::Other, frame::Initial::Undefined};
/// Low-rate samples: what was shaded, distance, normal.
inline constexpr frame::Resource kLodSamples{"level-of-detail samples", GL_RGBA32UI,
                                             frame::SizeRule::DisplayOverR, frame::ByteClass::Other,
                                             frame::Initial::Undefined};
/// Pixels at which the reconstruction fails: no sample fits them.
inline constexpr frame::Resource kLodHoles{"level-of-detail holes", 0, frame::SizeRule::Declared,
                                           frame::ByteClass::Other, frame::Initial::Undefined};
/// Shadow, ambient occlusion and noise of each pixel, where these alone are computed at 1/r.
inline constexpr frame::Resource kShadingParts{"shading parts", GL_RGBA8, frame::SizeRule::Display,
                                               frame::ByteClass::Other, frame::Initial::Undefined};

}  // namespace macula::passes
