// Places of the samples of a coarser raster in the image.
#ifndef MACULA_RASTER_GLSL
#define MACULA_RASTER_GLSL

/// Pixel of an image at the middle of a cell of a coarser raster.
/// @param pitch pixels a cell · @param size pixels of the image
ivec2 pixelAt(ivec2 cell, vec2 pitch, ivec2 size) {
  return min(ivec2(floor((vec2(cell) + 0.5) * pitch)), size - 1);
}

#endif
