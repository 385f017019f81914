// The module: the only file that includes OpenImageIO. It uses no other room, so that nothing of
// the program's is in it a second time.
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "engine/image/io_guard.h"
#include "engine/image/io_module.h"

namespace macula::image {

struct IoReader {
  std::unique_ptr<OIIO::ImageInput> input;
  OIIO::ImageSpec spec;
};

namespace {

/// OpenImageIO's names; with one it never tries the other formats that it knows.
const char* nameOf(IoFormat format) {
  return format == IoFormat::Png ? "png" : "openexr";
}

IoStatus noFormat(IoMessage* message) {
  return explained(IoStatus::NoFormat, OIIO::geterror(), message);
}

/// The library's words, with a stand-in where it has none. Fetching them also clears them;
/// uncollected ones would be printed when the reader is destroyed.
template <typename Source>
IoStatus failed(Source& source, IoMessage* message) {
  std::string text = source.geterror();
  if (text.empty()) text = "no reason given";
  while (!text.empty() && (text.back() == '\n' || text.back() == '.')) text.pop_back();
  return explained(IoStatus::Failed, text, message);
}

IoStatus open(IoFormat format, const char* path, IoReader** reader, IoHeader* header,
              IoMessage* message) {
  return guarded(message, [&] {
    auto opened = std::make_unique<IoReader>();
    opened->input = OIIO::ImageInput::create(nameOf(format));
    if (!opened->input) return noFormat(message);
    OIIO::ImageSpec wishes;
    wishes.attribute("oiio:UnassociatedAlpha", 1);  // PNG alpha stays out of the colours
    OIIO::ImageSpec& spec = opened->spec;
    if (!opened->input->open(path, spec, wishes)) return failed(*opened->input, message);
    *header = {spec.width, spec.height, spec.nchannels, !spec.deep && spec.depth <= 1};
    *reader = opened.release();
    return IoStatus::Done;
  });
}

/// Reads in the file's own integers and divides here: exact, and the same as the other codec's.
template <typename Integer>
bool readIntegers(const IoReader& reader, OIIO::TypeDesc type, float full, int channels,
                  float* pixels) {
  std::vector<Integer> stored(static_cast<std::size_t>(reader.spec.width) *
                              static_cast<std::size_t>(reader.spec.height) *
                              static_cast<std::size_t>(channels));
  if (!reader.input->read_image(0, 0, 0, channels, type, stored.data())) return false;
  std::transform(stored.begin(), stored.end(), pixels,
                 [full](Integer value) { return static_cast<float>(value) / full; });
  return true;
}

IoStatus read(IoReader* reader, std::int32_t channels, float* pixels, IoMessage* message) {
  return guarded(message, [&] {
    bool done = false;
    if (reader->spec.format == OIIO::TypeDesc::UINT8) {
      done = readIntegers<std::uint8_t>(*reader, OIIO::TypeDesc::UINT8, 255.0F, channels, pixels);
    } else if (reader->spec.format == OIIO::TypeDesc::UINT16) {
      done =
          readIntegers<std::uint16_t>(*reader, OIIO::TypeDesc::UINT16, 65535.0F, channels, pixels);
    } else {
      done = reader->input->read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, pixels);
    }
    return done ? IoStatus::Done : failed(*reader->input, message);
  });
}

void close(IoReader* reader) {
  delete reader;
}

OIIO::ImageSpec makeSpec(int width, int height, int channels, OIIO::TypeDesc type) {
  OIIO::ImageSpec spec(width, height, channels, type);
  // Values are written as they are, not divided by alpha first.
  spec.attribute("oiio:UnassociatedAlpha", 1);
  return spec;
}

IoStatus write(IoFormat format, const char* path, const OIIO::ImageSpec& spec, const void* pixels,
               IoMessage* message) {
  const auto output = OIIO::ImageOutput::create(nameOf(format));
  if (!output) return noFormat(message);
  if (!output->open(path, spec) || !output->write_image(spec.format, pixels) || !output->close()) {
    return failed(*output, message);
  }
  return IoStatus::Done;
}

IoStatus writePng(const char* path, std::int32_t width, std::int32_t height, std::int32_t channels,
                  const std::uint8_t* pixels, IoMessage* message) {
  return guarded(message, [&] {
    const OIIO::ImageSpec spec = makeSpec(width, height, channels, OIIO::TypeDesc::UINT8);
    return write(IoFormat::Png, path, spec, pixels, message);
  });
}

IoStatus writeExr(const char* path, std::int32_t width, std::int32_t height, std::int32_t channels,
                  const float* pixels, IoMessage* message) {
  return guarded(message, [&] {
    OIIO::ImageSpec spec = makeSpec(width, height, channels, OIIO::TypeDesc::FLOAT);
    spec.attribute("compression", "zip");
    // Left out, OpenImageIO writes the present time, and equal images would make unequal files.
    spec.attribute("DateTime", "1970:01:01 00:00:00");
    return write(IoFormat::Exr, path, spec, pixels, message);
  });
}

constexpr IoModule kModule{kIoModuleVersion, open, read, close, writePng, writeExr, true};

}  // namespace
}  // namespace macula::image

const macula::image::IoModule* maculaImageIoModule() {
  return &macula::image::kModule;
}
