// An OpenGL 4.5 core context without a window, through EGL.
#pragma once

#include <memory>
#include <string>

namespace macula::window {

/// Where EGL finds the device.
enum class EglPlatform {
  Auto,         ///< the first hardware device that offers OpenGL 4.5, else surfaceless
  Surfaceless,  ///< Mesa's EGL_PLATFORM_SURFACELESS_MESA
  Device,       ///< EGL_EXT_platform_device: the first device that offers OpenGL 4.5
};

/// Makes the context current on construction; it goes with the object.
class HeadlessContext {
 public:
  /// @param debug ask for a debug context, whose errors are reported (slower)
  /// @throws InputError where no device offers OpenGL 4.5 core, naming what is there
  explicit HeadlessContext(EglPlatform platform = EglPlatform::Auto, bool debug = false);
  ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;
  /// "surfaceless" or "device N", for reports.
  [[nodiscard]] const std::string& description() const { return description_; }

 private:
  struct Egl;
  std::unique_ptr<Egl> egl_;
  std::string description_;
};

}  // namespace macula::window
