// Settings of the level of detail and of foveation.
#pragma once

#include <string>

#include "engine/gaze/display.h"
#include "engine/settings/registry.h"

namespace macula::passes {

/// How full-rate pixels come from low-rate samples.
enum class Reconstruction {
  Bilinear,  ///< tent weights alone: the baseline
  Yang2008,  ///< Eq. 1: tent times Gaussians of the difference in normal and depth
  Macula,    ///< tent times fit to the pixel's tangent plane and normal
};

/// What becomes of pixels that no low-rate sample fits.
enum class Holes {
  Shade,  ///< shaded at full rate
  Tap,    ///< the sample that fits best
};

/// Framebuffer level of detail (Yang, Sander & Lawrence 2008).
struct LodSettings {
  double resize = 1.0;  ///< r: width of the image over that of the shaded one, 1 to 8
  /// "shading", or some of "shadow", "ao" and "noise" joined by commas.
  std::string what = "shading";
  Reconstruction reconstruction = Reconstruction::Macula;
  Holes holes = Holes::Shade;
  bool demodulate = true;  ///< macula: surface colours stay at full rate, light is computed at 1/r
  double sigmaNormal = 0.2;   ///< of yang2008: length of the difference of normals over their z
  double sigmaDepth = 0.01;   ///< of yang2008: share of the pixel's own depth
  bool transparency = false;  ///< transparent surfaces at 1/r, too
};

/// Parts of the opaque shading that can be computed at a lower rate than the rest.
struct LodParts {
  bool shading = false;  ///< all of it; then none of the others
  bool shadow = false;
  bool occlusion = false;
  bool noise = false;

  bool operator==(const LodParts&) const = default;
};

/// @param what as in LodSettings::what
/// @throws InputError naming the part that is not known
[[nodiscard]] LodParts parseLodParts(const std::string& what);

/// Shading rate by eccentricity: a tile is shaded every 1, 2, 4 or 8 pixels, as the eye's minimum
/// angle of resolution MAR(e) = slope e + fovealMar allows (Guenter et al. 2012, section 3).
struct FoveationSettings {
  bool enabled = false;
  double slope = 0.022;           ///< degrees a degree of eccentricity
  double fovealMar = 1.0 / 48.0;  ///< degrees
  bool perCycle = true;           ///< MAR is of a cycle, so two samples go to it; else one
  double pixelsPerDegree = 0.0;   ///< of the image; 0: from the display's width and distance
  int coarsest = 8;               ///< texels of L a side: 1, 2, 4 or 8
  /// Registered elsewhere, under display.*; must outlive this. Null: the default display.
  const gaze::Display* display = nullptr;
};

/// `settings` must outlive the registry.
void registerSettings(settings::Registry& registry, LodSettings& settings);
void registerSettings(settings::Registry& registry, FoveationSettings& settings);

}  // namespace macula::passes
