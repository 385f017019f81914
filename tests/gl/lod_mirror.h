// Shading rates and reconstruction on the CPU: plain, in double, without the shaders' code. Only
// where samples lie is computed in float, because there a rounding moves a sample by a pixel.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "engine/scene/view.h"
#include "passes/lod/settings.h"

namespace macula::test {

/// Full-rate pixel of a cell, along one axis. @param pitch pixels a cell · @param size pixels
[[nodiscard]] int samplePixel(int cell, float pitch, int size);

struct RateMirror {
  glm::dvec2 size{0.0};    ///< of the image in pixels
  glm::dvec2 gaze{0.0};    ///< in pixels, from the bottom left
  double widened = 0.0;    ///< pixels around the gaze that count as looked at
  double viewer = 1.0;     ///< distance of the eyes in pixels
  double slope = 0.022;    ///< m of MAR(e) = m e + w0
  double fovealMar = 0.0;  ///< w0 in degrees
  double samples = 2.0;    ///< that go to a minimum angle of resolution
  double resize = 1.0;     ///< r
  int coarsest = 8;

  /// Pixels that may share a sample at a place.
  [[nodiscard]] double allowedPitch(glm::dvec2 place) const;
  /// log2 of the texels of L between samples in a tile.
  [[nodiscard]] int level(glm::ivec2 tile) const;
};

/// One sample of the resized image.
struct MirrorSample {
  glm::dvec3 value{0.0};
  double inverseDistance = 0.0;
  glm::dvec3 normal{0.0};
};

struct ReconstructionMirror {
  passes::Reconstruction filter = passes::Reconstruction::Macula;
  scene::View view;
  glm::ivec2 size{0};    ///< of the image
  glm::ivec2 texels{0};  ///< of L
  float resize = 1.0F;
  double sigmaNormal = 0.2;
  double sigmaDepth = 0.01;
  int samplesPerRow = 0;              ///< of `samples`
  std::vector<MirrorSample> samples;  ///< L in the corner of the image's size
  std::vector<float> depth;           ///< of the image, reversed, rows from the bottom
  std::vector<glm::dvec3> normal;     ///< of the image
  std::vector<int> levels;            ///< per tile of L; empty where shading is not foveated

  struct Outcome {
    glm::dvec3 value{0.0};
    double best = 0.0;  ///< the best fit; below 0.05 the pixel is a hole
  };
  [[nodiscard]] Outcome pixel(glm::ivec2 p) const;
  [[nodiscard]] double inverseDistance(float depthValue) const;

 private:
  struct Tap {
    MirrorSample sample;
    glm::ivec2 pixel{0};
    double tent = 0.0;
  };
  [[nodiscard]] std::array<Tap, 4> tapsAround(glm::ivec2 p) const;
  [[nodiscard]] int levelAt(glm::ivec2 texel) const;
  [[nodiscard]] double fitOf(const Tap& tap, glm::ivec2 p) const;
  [[nodiscard]] glm::dvec3 rayThrough(glm::ivec2 pixel) const;
};

}  // namespace macula::test
