#define STB_IMAGE_WRITE_STATIC  // other files hold copies of their own
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO

#include "engine/image/jpeg.h"

// The header defines more static functions than this file calls, and converts carelessly.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

#include <stdexcept>

namespace macula::image {

std::string encodeJpeg(const Image8& image, int quality) {
  const bool shape = image.width >= 1 && image.height >= 1 &&
                     (image.channels == 1 || image.channels == 3) &&
                     image.pixels.size() == static_cast<std::size_t>(image.width) *
                                                static_cast<std::size_t>(image.height) *
                                                static_cast<std::size_t>(image.channels);
  std::string bytes;
  const auto append = [](void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                               static_cast<std::size_t>(size));
  };
  if (!shape || quality < 1 || quality > 100 ||
      stbi_write_jpg_to_func(append, &bytes, image.width, image.height, image.channels,
                             image.pixels.data(), quality) == 0) {
    throw std::invalid_argument("an image or a quality that JPEG does not have");
  }
  return bytes;
}

}  // namespace macula::image
