// HDR-FLIP: the worst that LDR-FLIP shows over the exposures at which an image may be looked at.
//
// This work is based on: P. Andersson, J. Nilsson, P. Shirley, T. Akenine-Moller, "Visualizing
// Errors in Rendered High Dynamic Range Images", Eurographics 2021 (short papers), and P.
// Andersson, J. Nilsson, T. Akenine-Moller, "Visualizing and Communicating Errors in Rendered
// Images", Ray Tracing Gems II, 2021, chapter 19.
#pragma once

#include "engine/image/image.h"
#include "engine/measure/flip.h"

namespace macula::measure {

/// Exposures in stops: start, start + (stop - start) / (count - 1), ..., stop.
struct Exposures {
  double start = 0.0;
  double stop = 0.0;
  int count = 1;
};

/// From the exposure that brings the reference's brightest luminance to 0.85 of the display's range
/// to the one that brings its median there, about a stop apart. The paper leaves a median of 0
/// open: then that of the pixels that are not black counts. A black reference is looked at as it
/// is.
[[nodiscard]] Exposures exposuresOf(const image::ImageF& reference);

/// The ACES curve in Narkowicz's fit (2015), without the fit's exposure of 0.6; 0..1.
[[nodiscard]] float toneMapAces(float linear);

/// At each pixel the largest LDR-FLIP over exposuresOf(reference), 0..1. Values are linear, 0 and
/// above; negative ones count as 0.
/// @throws InputError as flipMap()
[[nodiscard]] Plane hdrFlipMap(const image::ImageF& reference, const image::ImageF& test,
                               double pixelsPerDegree = kDefaultPixelsPerDegree);

}  // namespace macula::measure
