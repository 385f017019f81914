// The interface of an image module (OpenImageIO's, or stb's for PNG alone): plain data and
// functions only. No exception, allocation or C++ type crosses, so that neither side depends on how
// the other was compiled or on which symbols the loader merges.
#pragma once

#include <cstddef>
#include <cstdint>

namespace macula::image {

/// Changes whenever anything in this file does: a module of another build is refused.
inline constexpr std::uint32_t kIoModuleVersion = 2;
/// Its file, and the function of the type IoModuleEntry that it exports.
inline constexpr const char* kIoModuleFile = "macula-image-io.so";
inline constexpr const char* kIoModuleEntry = "maculaImageIoModule";

enum class IoFormat : std::int32_t { Png, Exr };

enum class IoStatus : std::int32_t {
  Done,
  NoFormat,     ///< the library was built without the format
  Failed,       ///< the file is damaged or cannot be written
  OutOfMemory,  ///< std::bad_alloc
  Fault,        ///< any other exception
};

/// Why a call was not Done, in the library's words: UTF-8 that ends with a zero, cut off where it
/// is longer.
struct IoMessage {
  char text[1024];
};

/// The header of a file, unchecked.
struct IoHeader {
  std::int64_t width;
  std::int64_t height;
  std::int64_t channels;
  bool flat;  ///< neither a deep image nor a volume
};

struct IoReader;  ///< a file that is open for reading

struct IoModule {
  std::uint32_t version;  ///< kIoModuleVersion; stands first in every version
  /// Reads the header only. @param reader set where Done; ends with close()
  IoStatus (*open)(IoFormat format, const char* path, IoReader** reader, IoHeader* header,
                   IoMessage* message);
  /// @param channels how many, from the first on @param pixels width * height * channels floats:
  /// integers of 8 and 16 bits as k/255 and k/65535, alpha not multiplied in
  IoStatus (*read)(IoReader* reader, std::int32_t channels, float* pixels, IoMessage* message);
  void (*close)(IoReader* reader);
  /// Pixels are interleaved, rows from the top.
  IoStatus (*writePng)(const char* path, std::int32_t width, std::int32_t height,
                       std::int32_t channels, const std::uint8_t* pixels, IoMessage* message);
  IoStatus (*writeExr)(const char* path, std::int32_t width, std::int32_t height,
                       std::int32_t channels, const float* pixels, IoMessage* message);
  bool exr;  ///< it reads and writes EXR; without, those calls give NoFormat
};

using IoModuleEntry = const IoModule* (*)();

}  // namespace macula::image

/// The one symbol of a module; kIoModuleEntry names it.
extern "C" __attribute__((visibility("default"))) const macula::image::IoModule*
maculaImageIoModule();
