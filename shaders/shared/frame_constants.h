// Constants of one frame.
#ifndef MACULA_SHARED_FRAME_CONSTANTS_H
#define MACULA_SHARED_FRAME_CONSTANTS_H
#include "shared/cpp_glsl.h"
MACULA_SHARED_BEGIN

struct FrameConstants {
  mat4 viewProjection;
  mat4 inverseViewProjection;
  vec4 eye;         // xyz world position of the camera
  vec4 size;        // samples: width, height, 1 / width, 1 / height
  vec4 gaze;        // xy: point of interest in samples, from the bottom left; z: by how many
                    // samples the fovea is widened where the gaze is uncertain
  vec4 background;  // linear rgb
  uvec4 frame;      // x: frame index, y: 1 where history is valid, z: seed
  uvec4 oit;        // x: slots of a pixel where they are constant, y: slots of the pool, z: stride
                    // of the pixels in which the price of a slot is searched for, w: words of a
                    // pixel's occupancy map
  vec4 slices;      // x, y: near and far plane; z: samples a side that share depth slices
  mat4 reprojection;  // clip space of this frame to that of the last
  vec4 right;         // xyz: from the middle of the view to its right edge, at distance 1
  vec4 up;            // the same to its upper edge
  vec4 ahead;         // unit length
  vec4 depth;         // 1 / distance along `ahead` = x * depth + y
  vec4 resize;        // x: r, y: 1 / r; z: distance of the viewer in samples of the image
  ivec4 lodSize;      // texels of the resized image, tiles of it
  vec4 acuity;        // slope m, w0 in degrees, samples that go to a minimum angle of resolution,
                      // coarsest rate
};

MACULA_SHARED_END
#endif
