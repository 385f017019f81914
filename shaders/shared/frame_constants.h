// Constants of one frame.
#ifndef MACULA_SHARED_FRAME_CONSTANTS_H
#define MACULA_SHARED_FRAME_CONSTANTS_H
#include "shared/cpp_glsl.h"
MACULA_SHARED_BEGIN

// std140: a vec2 begins at a multiple of 8 bytes, vec4 and mat4 at one of 16.
struct FrameConstants {
  mat4 viewProjection;
  mat4 inverseViewProjection;
  vec4 eye;          // xyz world position of the camera
  vec2 size;         // samples, or texels of reduced-rate transparency
  vec2 inverseSize;  // 1 / size
  vec2 gaze;         // point of interest in samples, from the bottom left
  float gazeSpread;  // samples by which the fovea is widened where the gaze is uncertain
  float padding0;
  vec4 background;  // linear rgb
  uint frameIndex;
  uint historyValid;  // 1 where the last frame's transparency can be read, else 0
  uint seed;
  uint padding1;
  uint pixelSlots;       // slots of a pixel where they are constant
  uint slots;            // of the pool
  uint sampledCellSide;  // pixels a side of a cell of which the search for the Lagrange multiplier
                         // looks at one
  uint occupancyWords;   // of a pixel's occupancy map
  float nearPlane;
  float farPlane;
  float sliceTile;  // samples a side that share depth slices
  float padding2;
  mat4 reprojection;  // clip space of this frame to that of the last
  vec4 right;         // xyz: from the middle of the view to its right edge, at distance 1
  vec4 up;            // the same to its upper edge
  vec4 ahead;         // unit length
  float depthScale;   // 1 / distance along `ahead` = depthScale * depth + depthOffset
  float depthOffset;
  float padding3;
  float padding4;
  float pitch;           // r: samples of the image a texel of the reduced-rate image
  float inversePitch;    // 1 / r
  float viewerDistance;  // in samples of the image
  float padding5;
  ivec2 lodTexels;      // of the reduced-rate image
  ivec2 lodTiles;       // of it
  float acuitySlope;    // m: degrees of MAR (minimum angle of resolution) per degree
  float fovealMar;      // w0, degrees
  float samplesPerMar;  // samples that go to a MAR
  float coarsestRate;
};

MACULA_SHARED_END
#endif
