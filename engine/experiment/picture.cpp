#include "engine/experiment/picture.h"

#include <openssl/evp.h>

#include <algorithm>
#include <cmath>

#include "engine/image/jpeg.h"

namespace macula::experiment {
namespace {

/// Above 90 the encoder keeps colours at full resolution; differences of a few steps stay visible.
constexpr int kJpegQuality = 92;

std::size_t indexOf(const image::Image8& image, int x, int y, int channel) {
  return (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
          static_cast<std::size_t>(x)) *
             static_cast<std::size_t>(image.channels) +
         static_cast<std::size_t>(channel);
}

/// The mean of image[x0, x1) x [y0, y1), with parts of pixels at the borders.
double areaMean(const image::Image8& image, double x0, double x1, double y0, double y1,
                int channel) {
  double sum = 0.0;
  double area = 0.0;
  for (int y = static_cast<int>(y0); y < image.height && y < y1; ++y) {
    const double height = std::min(y1, y + 1.0) - std::max(y0, static_cast<double>(y));
    for (int x = static_cast<int>(x0); x < image.width && x < x1; ++x) {
      const double part = height * (std::min(x1, x + 1.0) - std::max(x0, static_cast<double>(x)));
      sum += part * image.pixels[indexOf(image, x, y, channel)];
      area += part;
    }
  }
  return area > 0.0 ? sum / area : 0.0;
}

}  // namespace

image::Image8 shrink(const image::Image8& image, int longest) {
  const int side = std::max(image.width, image.height);
  if (side <= longest) return image;
  const double factor = static_cast<double>(side) / longest;
  image::Image8 small{std::max(1, static_cast<int>(std::lround(image.width / factor))),
                      std::max(1, static_cast<int>(std::lround(image.height / factor))),
                      image.channels,
                      {}};
  const double stepX = static_cast<double>(image.width) / small.width;
  const double stepY = static_cast<double>(image.height) / small.height;
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      for (int c = 0; c < image.channels; ++c) {
        const double mean =
            areaMean(image, x * stepX, (x + 1) * stepX, y * stepY, (y + 1) * stepY, c);
        small.pixels.push_back(static_cast<std::uint8_t>(std::lround(mean)));
      }
    }
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
