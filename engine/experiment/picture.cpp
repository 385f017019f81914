#define STB_IMAGE_RESIZE_STATIC
#define STB_IMAGE_RESIZE_IMPLEMENTATION

#include "engine/experiment/picture.h"

#include <openssl/evp.h>

// The header defines more static functions than this file calls.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image_resize.h>
#pragma GCC diagnostic pop

#include <algorithm>
#include <cmath>
#include <new>

#include "engine/image/jpeg.h"

namespace macula::experiment {
namespace {

/// Above 90 the encoder keeps colours at full resolution; differences of a few steps stay visible.
constexpr int kJpegQuality = 92;

}  // namespace

image::Image8 shrink(const image::Image8& image, int longest) {
  const int side = std::max(image.width, image.height);
  if (side <= longest) return image;
  const double factor = static_cast<double>(side) / longest;
  image::Image8 small{std::max(1, static_cast<int>(std::lround(image.width / factor))),
                      std::max(1, static_cast<int>(std::lround(image.height / factor))),
                      image.channels,
                      {}};
  small.pixels.resize(static_cast<std::size_t>(small.width) *
                      static_cast<std::size_t>(small.height) *
                      static_cast<std::size_t>(small.channels));
  // Smaller by any factor, its box filter takes the mean of the area, with parts of pixels.
  if (stbir_resize_uint8_generic(image.pixels.data(), image.width, image.height, 0,
                                 small.pixels.data(), small.width, small.height, 0, small.channels,
                                 STBIR_ALPHA_CHANNEL_NONE, 0, STBIR_EDGE_CLAMP, STBIR_FILTER_BOX,
                                 STBIR_COLORSPACE_LINEAR, nullptr) == 0) {
    throw std::bad_alloc();
  }
  return small;
}

std::string base64(std::string_view bytes) {
  std::string text((bytes.size() + 2) / 3 * 4 + 1, '\0');  // OpenSSL ends it with a zero
  const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                                     reinterpret_cast<const unsigned char*>(bytes.data()),
                                     static_cast<int>(bytes.size()));
  text.resize(static_cast<std::size_t>(length));
  return text;
}

std::string pictureUri(const std::filesystem::path& png, int longest) {
  const image::Image8 small = shrink(image::toImage8(image::readImage(png)), longest);
  return "data:image/jpeg;base64," + base64(image::encodeJpeg(small, kJpegQuality));
}

}  // namespace macula::experiment
