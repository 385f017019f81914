// PNG and EXR through an image module, opened at the first image: OpenImageIO's libraries take some
// 120 MB and a tenth of a second, which a command without images does not pay. A build without
// OpenImageIO has its module in the program.
#include <dlfcn.h>

#include <algorithm>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/image/codec.h"
#include "engine/image/io_module.h"

namespace macula::image::codec {
namespace {

namespace fs = std::filesystem;

/// @throws InputError where it is of another version
const IoModule& checked(const IoModule* module, const std::string& file) {
  if (module == nullptr || module->version != kIoModuleVersion) {
    failInput("{}: belongs to another version of Macula; install the program and its modules again",
              file);
  }
  return *module;
}

#if MACULA_IMAGE_IO
const IoModule& openModule() {
  const std::string file = moduleFile(kIoModuleFile).string();
  // Local, so that none of its libraries takes the place of one that the program or the GL driver
  // uses. Never closed: OpenImageIO keeps threads.
  void* handle = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    const char* why = ::dlerror();
    failInput("{}: cannot be loaded ({}); install OpenImageIO 2.4 or rebuild Macula", file,
              why == nullptr ? "no reason given" : why);
  }
  const auto entry = reinterpret_cast<IoModuleEntry>(::dlsym(handle, kIoModuleEntry));
  return checked(entry == nullptr ? nullptr : entry(), file);
}
#else
const IoModule& openModule() {
  return checked(maculaImageIoModule(), "this program");
}
#endif

/// @throws InputError at every call until the module can be opened
const IoModule& module() {
  static const IoModule& opened = openModule();
  return opened;
}

/// False where the file is at fault; the caller words the message.
/// @param file for messages
/// @throws whatever else went wrong
bool succeeded(IoStatus status, const IoMessage& message, const fs::path& file) {
  switch (status) {
    case IoStatus::Done:
      return true;
    case IoStatus::Failed:
      return false;
    case IoStatus::NoFormat:
      failInput(
          "{}: the image module here lacks the format ({}); use PNG, or a build with "
          "MACULA_IMAGE_IO=ON",
          file.string(), message.text);
    case IoStatus::OutOfMemory:
      throw std::bad_alloc();
    case IoStatus::Fault:
      break;
  }
  throw std::runtime_error(file.string() + ": " + message.text);
}

[[noreturn]] void failDamaged(const fs::path& path, const IoMessage& message) {
  failInput("{}: is damaged or cut off ({}); write it again", path.string(), message.text);
}

[[noreturn]] void failUnwritable(const fs::path& path, const IoMessage& message) {
  failInput("{}: cannot be written ({}); check the folder and the space left", path.string(),
            message.text);
}

ImageF read(IoFormat format, const fs::path& path, std::uintmax_t fileBytes) {
  IoMessage message{};
  IoReader* opened = nullptr;
  IoHeader header{};
  if (!succeeded(module().open(format, path.c_str(), &opened, &header, &message), message, path)) {
    failDamaged(path, message);
  }
  const std::unique_ptr<IoReader, void (*)(IoReader*)> reader(opened, module().close);
  checkHeader(path, header.width, header.height, header.channels, fileBytes);
  if (!header.flat) failInput("{}: is a deep or volume image; give a flat one", path.string());
  ImageF image{static_cast<int>(header.width),
               static_cast<int>(header.height),
               static_cast<int>(std::min<std::int64_t>(header.channels, kMaxChannels)),
               {}};
  image.pixels.resize(sampleCount(image));
  const IoStatus status =
      module().read(reader.get(), image.channels, image.pixels.data(), &message);
  if (!succeeded(status, message, path)) failDamaged(path, message);
  return image;
}

}  // namespace

ImageF readPng(const fs::path& path, std::uintmax_t fileBytes) {
  return read(IoFormat::Png, path, fileBytes);
}

ImageF readExr(const fs::path& path, std::uintmax_t fileBytes) {
  return read(IoFormat::Exr, path, fileBytes);
}

void writePng(const fs::path& temporary, const fs::path& path, const Image8& image) {
  IoMessage message{};
  const IoStatus status = module().writePng(temporary.c_str(), image.width, image.height,
                                            image.channels, image.pixels.data(), &message);
  if (!succeeded(status, message, path)) failUnwritable(path, message);
}

void writeExr(const fs::path& temporary, const fs::path& path, const ImageF& image) {
  IoMessage message{};
  const IoStatus status = module().writeExr(temporary.c_str(), image.width, image.height,
                                            image.channels, image.pixels.data(), &message);
  if (!succeeded(status, message, path)) failUnwritable(path, message);
}

}  // namespace macula::image::codec

bool macula::image::hasExr() {
  return codec::module().exr;
}
