// What the passes of the level of detail agree on in one frame.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "engine/frame/frame_inputs.h"
#include "engine/gl/program.h"
#include "passes/lod/settings.h"

namespace macula::passes {

/// What follows from settings, scene and controls. The first part changes with settings and scene
/// only; the second from frame to frame, without any allocation.
struct LodPlan {
  /// Opaque surfaces may be shaded at a reduced rate: the passes have work.
  bool wanted = false;
  /// What is: `shading`, or those of the other parts that the scene has.
  LodParts parts = {};
  Reconstruction reconstruction = Reconstruction::Macula;
  Holes holes = Holes::Shade;
  glm::vec2 sigma{0.0F};     ///< of normals and of depth, for yang2008
  bool demodulates = false;  ///< samples hold light without the surface's colour
  bool foveated = false;
  /// Transparent surfaces may be drawn at 1/r, too. Foveation does not apply to them.
  bool transparency = false;
  /// What could be computed at 1/r if an r above 1 were asked for.
  bool canResizeShading = false;
  bool canResizeTransparency = false;

  double resize = 1.0;      ///< r; 1 at full rate
  glm::ivec2 size{0};       ///< samples of the image
  glm::ivec2 texels{0};     ///< of the reduced-rate image L
  glm::ivec2 tiles{0};      ///< of L
  glm::vec4 acuity{0.0F};   ///< slope, w0 in degrees, samples per minimum angle, coarsest rate
  float viewerSamples = 1;  ///< distance of the viewer in samples of the image
  int load = 1;             ///< times that the shading is computed

  /// Whether this frame shades every pixel, so that nothing is reconstructed.
  [[nodiscard]] bool fullRate() const { return resize == 1.0 && !foveated; }
  /// Whether this frame draws transparency at a reduced rate.
  [[nodiscard]] bool resizesTransparency() const { return transparency && texels != size; }
  /// Samples at which this frame draws transparency.
  [[nodiscard]] glm::ivec2 transparencySize() const { return transparency ? texels : size; }
  /// Whether pixels without a fitting sample are shaded.
  [[nodiscard]] bool shadesHoles() const {
    return holes == Holes::Shade && reconstruction != Reconstruction::Bilinear;
  }
};

/// Fills in the first part. @param mayResize a controller may ask for a reduced rate
void planLod(LodPlan& plan, const LodSettings& settings, const FoveationSettings& foveation,
             const scene::SceneFacts& facts, bool mayResize);

/// Fills in the second part.
/// @param samplesPerAxis supersampling
void planFrame(LodPlan& plan, const LodSettings& settings, const FoveationSettings& foveation,
               const frame::FrameInputs& inputs, int samplesPerAxis);

/// Texels of L for an image of this size: the pitch of samples is r, the last one may be narrower.
[[nodiscard]] glm::ivec2 resizedTexels(glm::ivec2 size, double resize);

/// Distance of the viewer's eyes in pixels of an image, from settings or display: an angle of one
/// degree at the middle spans pixelsPerDegree.
[[nodiscard]] double viewerDistance(const FoveationSettings& settings, int imageWidth);

}  // namespace macula::passes
