// PNG through stb, for builds without OpenImageIO.
#define STB_IMAGE_STATIC  // tinygltf may bring a copy of its own
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#define STBI_NO_STDIO
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO

// Both headers define more static functions than this file calls.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

#include <algorithm>
#include <fstream>
#include <memory>
#include <string>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/image/codec.h"

namespace macula::image::codec {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void failDamaged(const fs::path& path) {
  const char* why = stbi_failure_reason();
  failInput("{}: is damaged or cut off ({}); write it again", path.string(),
            why == nullptr ? "no reason given" : why);
}

struct Free {
  void operator()(void* pixels) const { stbi_image_free(pixels); }
};

/// Takes what stb decoded, divided by `full`.
template <typename Sample>
void take(Sample* decoded, float full, const fs::path& path, ImageF& image) {
  const std::unique_ptr<Sample, Free> owner(decoded);
  if (!owner) failDamaged(path);
  image.pixels.resize(sampleCount(image));
  std::transform(decoded, decoded + image.pixels.size(), image.pixels.begin(),
                 [full](Sample value) { return static_cast<float>(value) / full; });
}

}  // namespace

ImageF readExr(const fs::path& path, std::uintmax_t) {
  failInput("{}: this build reads no EXR; build with MACULA_IMAGE_IO=ON or give a PNG or HDR",
            path.string());
}

ImageF readPng(const fs::path& path, std::uintmax_t fileBytes) {
  const std::string text = readTextFile(path);
  if (text.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    failInput("{}: is larger than 2 GiB; give a smaller image", path.string());
  }
  const auto* bytes = reinterpret_cast<const stbi_uc*>(text.data());
  const int length = static_cast<int>(text.size());
  ImageF image;
  if (stbi_info_from_memory(bytes, length, &image.width, &image.height, &image.channels) == 0) {
    failDamaged(path);
  }
  checkHeader(path, image.width, image.height, image.channels, fileBytes);
  int width = 0;
  int height = 0;
  int stored = 0;
  const int channels = image.channels;
  if (stbi_is_16_bit_from_memory(bytes, length) != 0) {
    take(stbi_load_16_from_memory(bytes, length, &width, &height, &stored, channels), 65535.0F,
         path, image);
  } else {
    take(stbi_load_from_memory(bytes, length, &width, &height, &stored, channels), 255.0F, path,
         image);
  }
  return image;
}

void writePng(const fs::path& temporary, const fs::path& path, const Image8& image) {
  std::string png;
  const auto append = [](void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                               static_cast<std::size_t>(size));
  };
  const int encoded =
      stbi_write_png_to_func(append, &png, image.width, image.height, image.channels,
                             image.pixels.data(), image.width * image.channels);
  std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
  out.write(png.data(), static_cast<std::streamsize>(png.size()));
  out.close();
  if (encoded == 0 || !out) {
    failInput("{}: cannot be written; check the folder and the space left", path.string());
  }
}

void writeExr(const fs::path&, const fs::path& path, const ImageF&) {
  failInput("{}: this build writes no EXR; build with MACULA_IMAGE_IO=ON or write PNG",
            path.string());
}

}  // namespace macula::image::codec
