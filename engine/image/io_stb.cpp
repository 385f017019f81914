// The image module without OpenImageIO: PNG through stb, no EXR. Builds without OpenImageIO have it
// in the program; others make a module of it that needs no library, for tools/bundle.sh.
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
#include <cerrno>
#include <cstring>
#include <fstream>
#include <limits>
#include <memory>
#include <sstream>
#include <string>

#include "engine/image/io_guard.h"
#include "engine/image/io_module.h"

namespace macula::image {

struct IoReader {
  std::string bytes;
  int width = 0;
  int height = 0;
  int channels = 0;

  [[nodiscard]] const stbi_uc* data() const {
    return reinterpret_cast<const stbi_uc*>(bytes.data());
  }
  [[nodiscard]] int length() const { return static_cast<int>(bytes.size()); }
};

namespace {

IoStatus failed(const char* why, IoMessage* message) {
  return explained(IoStatus::Failed, why == nullptr ? "no reason given" : why, message);
}

IoStatus noExr(IoMessage* message) {
  return explained(IoStatus::NoFormat, "it has PNG alone", message);
}

IoStatus open(IoFormat format, const char* path, IoReader** reader, IoHeader* header,
              IoMessage* message) {
  return guarded(message, [&] {
    if (format != IoFormat::Png) return noExr(message);
    std::ifstream in(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << in.rdbuf();
    if (!in) return failed(std::strerror(errno), message);
    auto opened = std::make_unique<IoReader>();
    opened->bytes = std::move(bytes).str();
    if (opened->bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
      return failed("larger than 2 GiB", message);
    }
    if (stbi_info_from_memory(opened->data(), opened->length(), &opened->width, &opened->height,
                              &opened->channels) == 0) {
      return failed(stbi_failure_reason(), message);
    }
    *header = {opened->width, opened->height, opened->channels, true};
    *reader = opened.release();
    return IoStatus::Done;
  });
}

struct Free {
  void operator()(void* pixels) const { stbi_image_free(pixels); }
};

/// Divides what stb decoded, `stored` channels a pixel, by `full`.
template <typename Sample>
IoStatus take(Sample* decoded, float full, const IoReader& reader, int channels, float* pixels,
              IoMessage* message) {
  const std::unique_ptr<Sample, Free> owner(decoded);
  if (!owner) return failed(stbi_failure_reason(), message);
  const auto count = static_cast<std::size_t>(reader.width) *
                     static_cast<std::size_t>(reader.height) * static_cast<std::size_t>(channels);
  std::transform(decoded, decoded + count, pixels,
                 [full](Sample value) { return static_cast<float>(value) / full; });
  return IoStatus::Done;
}

IoStatus read(IoReader* reader, std::int32_t channels, float* pixels, IoMessage* message) {
  return guarded(message, [&] {
    int width = 0;
    int height = 0;
    int stored = 0;
    if (stbi_is_16_bit_from_memory(reader->data(), reader->length()) != 0) {
      return take(stbi_load_16_from_memory(reader->data(), reader->length(), &width, &height,
                                           &stored, channels),
                  65535.0F, *reader, channels, pixels, message);
    }
    return take(
        stbi_load_from_memory(reader->data(), reader->length(), &width, &height, &stored, channels),
        255.0F, *reader, channels, pixels, message);
  });
}

void close(IoReader* reader) {
  delete reader;
}

IoStatus writePng(const char* path, std::int32_t width, std::int32_t height, std::int32_t channels,
                  const std::uint8_t* pixels, IoMessage* message) {
  return guarded(message, [&] {
    std::string png;
    const auto append = [](void* context, void* data, int size) {
      static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                                 static_cast<std::size_t>(size));
    };
    if (stbi_write_png_to_func(append, &png, width, height, channels, pixels, width * channels) ==
        0) {
      return failed("it cannot be encoded", message);
    }
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    out.write(png.data(), static_cast<std::streamsize>(png.size()));
    out.close();
    return out ? IoStatus::Done : failed(std::strerror(errno), message);
  });
}

IoStatus writeExr(const char* /*path*/, std::int32_t /*width*/, std::int32_t /*height*/,
                  std::int32_t /*channels*/, const float* /*pixels*/, IoMessage* message) {
  return noExr(message);
}

constexpr IoModule kModule{kIoModuleVersion, open, read, close, writePng, writeExr, false};

}  // namespace
}  // namespace macula::image

const macula::image::IoModule* maculaImageIoModule() {
  return &macula::image::kModule;
}
