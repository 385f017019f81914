// Errors weighted by how well the eye resolves the place where they are.
#pragma once

#include <glm/glm.hpp>

#include "engine/measure/filter.h"

namespace macula::measure {

/// Minimum angle of resolution, in degrees, at an eccentricity e in degrees: m e + w0 (Guenter,
/// Finch, Drucker, Tan & Snyder 2012, "Foveated 3D Graphics", section 3).
inline constexpr double kMarSlope = 0.022;
/// At the fovea: Guenter's 1/48 degree.
inline constexpr double kFovealMar = 1.0 / 48.0;

/// (w0 / MAR(e))^2: how many details of a solid angle are resolved there, relative to the fovea.
/// @param eccentricity degrees, >= 0
[[nodiscard]] double acuityWeight(double eccentricity);

/// The mean of a map of errors, weighted by acuityWeight() of each pixel's distance from the gaze.
/// Eccentricity is distance in pixels / pixelsPerDegree: small angles, a flat screen.
/// @param gaze 0..1 of the image from the top left; may lie outside
/// @param pixelsPerDegree of visual angle, > 0
[[nodiscard]] double gazeWeightedMean(const Plane& map, const glm::dvec2& gaze,
                                      double pixelsPerDegree);

}  // namespace macula::measure
