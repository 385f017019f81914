// The only file that includes OpenImageIO.
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/image/codec.h"

namespace macula::image::codec {
namespace {

namespace fs = std::filesystem;

/// The library's words, with a stand-in where it has none. Fetching them also clears them;
/// uncollected ones would be printed when the reader is destroyed.
template <typename Source>
std::string reason(Source& source) {
  std::string text = source.geterror();
  if (text.empty()) text = "no reason given";
  while (!text.empty() && (text.back() == '\n' || text.back() == '.')) text.pop_back();
  return text;
}

[[noreturn]] void failDamaged(const fs::path& path, const std::string& why) {
  failInput("{}: is damaged or cut off ({}); write it again", path.string(), why);
}

/// Reads in the file's own integers and divides here: exact, and the same as the other codec's.
template <typename Integer>
void readIntegers(OIIO::ImageInput& input, OIIO::TypeDesc type, float full, const fs::path& path,
                  ImageF& image) {
  std::vector<Integer> stored(sampleCount(image));
  if (!input.read_image(0, 0, 0, image.channels, type, stored.data())) {
    failDamaged(path, reason(input));
  }
  image.pixels.resize(stored.size());
  std::transform(stored.begin(), stored.end(), image.pixels.begin(),
                 [full](Integer value) { return static_cast<float>(value) / full; });
}

OIIO::ImageSpec makeSpec(int width, int height, int channels, OIIO::TypeDesc type) {
  OIIO::ImageSpec spec(width, height, channels, type);
  // Values are written as they are, not divided by alpha first.
  spec.attribute("oiio:UnassociatedAlpha", 1);
  return spec;
}

void write(const char* format, const fs::path& temporary, const fs::path& path,
           const OIIO::ImageSpec& spec, OIIO::TypeDesc type, const void* pixels) {
  const auto output = OIIO::ImageOutput::create(format);
  if (!output) failInput("{}: OpenImageIO has no {}: {}", path.string(), format, OIIO::geterror());
  if (!output->open(temporary.string(), spec) || !output->write_image(type, pixels) ||
      !output->close()) {
    failInput("{}: cannot be written ({}); check the folder and the space left", path.string(),
              reason(*output));
  }
}

/// @param format by OpenImageIO's name, so that it never tries the other formats that it knows
ImageF read(const char* format, const fs::path& path, std::uintmax_t fileBytes) {
  const auto input = OIIO::ImageInput::create(format);
  if (!input) failInput("{}: OpenImageIO has no reader: {}", path.string(), OIIO::geterror());
  OIIO::ImageSpec wishes;
  wishes.attribute("oiio:UnassociatedAlpha", 1);  // PNG alpha stays out of the colours
  OIIO::ImageSpec spec;
  if (!input->open(path.string(), spec, wishes)) failDamaged(path, reason(*input));
  checkHeader(path, spec.width, spec.height, spec.nchannels, fileBytes);
  if (spec.deep || spec.depth > 1) {
    failInput("{}: is a deep or volume image; give a flat one", path.string());
  }
  ImageF image{spec.width, spec.height, std::min(spec.nchannels, 4), {}};
  if (spec.format == OIIO::TypeDesc::UINT8) {
    readIntegers<std::uint8_t>(*input, OIIO::TypeDesc::UINT8, 255.0F, path, image);
  } else if (spec.format == OIIO::TypeDesc::UINT16) {
    readIntegers<std::uint16_t>(*input, OIIO::TypeDesc::UINT16, 65535.0F, path, image);
  } else {
    image.pixels.resize(sampleCount(image));
    if (!input->read_image(0, 0, 0, image.channels, OIIO::TypeDesc::FLOAT, image.pixels.data())) {
      failDamaged(path, reason(*input));
    }
  }
  return image;
}

}  // namespace

ImageF readPng(const fs::path& path, std::uintmax_t fileBytes) {
  return read("png", path, fileBytes);
}

ImageF readExr(const fs::path& path, std::uintmax_t fileBytes) {
  return read("openexr", path, fileBytes);
}

void writePng(const fs::path& temporary, const fs::path& path, const Image8& image) {
  write("png", temporary, path,
        makeSpec(image.width, image.height, image.channels, OIIO::TypeDesc::UINT8),
        OIIO::TypeDesc::UINT8, image.pixels.data());
}

void writeExr(const fs::path& temporary, const fs::path& path, const ImageF& image) {
  OIIO::ImageSpec spec = makeSpec(image.width, image.height, image.channels, OIIO::TypeDesc::FLOAT);
  spec.attribute("compression", "zip");
  // Left out, OpenImageIO writes the present time, and equal images would make unequal files.
  spec.attribute("DateTime", "1970:01:01 00:00:00");
  write("openexr", temporary, path, spec, OIIO::TypeDesc::FLOAT, image.pixels.data());
}

}  // namespace macula::image::codec
