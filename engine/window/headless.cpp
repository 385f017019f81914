#include "engine/window/headless.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <cstring>
#include <optional>

#include "engine/core/error.h"

namespace macula::window {
namespace {

constexpr int kMajor = 4;
constexpr int kMinor = 5;

bool has(const char* extensions, const char* name) {
  return extensions != nullptr && std::strstr(extensions, name) != nullptr;
}

/// libepoxy aborts on eglGetPlatformDisplay before a display exists; the EXT entry point is safe.
EGLDisplay platformDisplay(EGLenum platform, void* native) {
  const auto get = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      eglGetProcAddress("eglGetPlatformDisplayEXT"));
  return get == nullptr ? EGL_NO_DISPLAY : get(platform, native, nullptr);
}

std::optional<EGLContext> makeContext(EGLDisplay display, int major, int minor, bool debug) {
  const std::array<EGLint, 5> configAttributes{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                               EGL_SURFACE_TYPE, 0, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  eglChooseConfig(display, configAttributes.data(), &config, 1, &count);
  const std::array<EGLint, 9> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                         major,
                                         EGL_CONTEXT_MINOR_VERSION,
                                         minor,
                                         EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                         EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                         EGL_CONTEXT_OPENGL_DEBUG,
                                         debug ? EGL_TRUE : EGL_FALSE,
                                         EGL_NONE};
  EGLContext context =
      eglCreateContext(display, count > 0 ? config : nullptr, EGL_NO_CONTEXT, attributes.data());
  if (context == EGL_NO_CONTEXT) return std::nullopt;
  if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) != EGL_TRUE) {
    eglDestroyContext(display, context);
    return std::nullopt;
  }
  return context;
}

}  // namespace

struct HeadlessContext::Egl {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  std::string highestSeen;  ///< what a device without 4.5 offers, for the error

  bool open(EGLDisplay candidate, bool debug) {
    if (candidate == EGL_NO_DISPLAY || eglInitialize(candidate, nullptr, nullptr) != EGL_TRUE) {
      return false;
    }
    eglBindAPI(EGL_OPENGL_API);
    if (const auto made = makeContext(candidate, kMajor, kMinor, debug)) {
      display = candidate;
      context = *made;
      return true;
    }
    noteLowerVersion(candidate);
    eglTerminate(candidate);
    return false;
  }

  bool openDevice(bool debug, bool hardwareOnly, std::string& description) {
    const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (!has(client, "EGL_EXT_platform_device")) return false;
    const auto query =
        reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    const auto name = reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(
        eglGetProcAddress("eglQueryDeviceStringEXT"));
    if (query == nullptr || name == nullptr) return false;
    constexpr EGLint kMaxDevices = 16;
    std::array<EGLDeviceEXT, kMaxDevices> devices{};
    EGLint count = 0;
    if (query(kMaxDevices, devices.data(), &count) != EGL_TRUE) return false;
    for (EGLint i = 0; i < count; ++i) {
      EGLDeviceEXT device = devices[static_cast<std::size_t>(i)];
      if (hardwareOnly && has(name(device, EGL_EXTENSIONS), "EGL_MESA_device_software")) continue;
      if (open(platformDisplay(EGL_PLATFORM_DEVICE_EXT, device), debug)) {
        description = fmt::format("device {}", i);
        return true;
      }
    }
    return false;
  }

  bool openSurfaceless(bool debug, std::string& description) {
    if (!has(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), "EGL_MESA_platform_surfaceless")) {
      return false;
    }
    description = "surfaceless";
    return open(platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY), debug);
  }

 private:
  void noteLowerVersion(EGLDisplay candidate) {
    constexpr int kLowMajor = 3;
    constexpr int kLowMinor = 3;
    const auto low = makeContext(candidate, kLowMajor, kLowMinor, false);
    if (!low) return;
    const auto text = [](GLenum key) {
      const GLubyte* value = glGetString(key);
      return value == nullptr ? "?" : reinterpret_cast<const char*>(value);
    };
    highestSeen = fmt::format("{} offers OpenGL {}", text(GL_RENDERER), text(GL_VERSION));
    eglMakeCurrent(candidate, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(candidate, *low);
  }
};

HeadlessContext::HeadlessContext(EglPlatform platform, bool debug) : egl_(std::make_unique<Egl>()) {
  bool open = false;
  if (platform == EglPlatform::Auto) {
    open = egl_->openDevice(debug, true, description_) ||
           egl_->openSurfaceless(debug, description_) ||
           egl_->openDevice(debug, false, description_);
  } else if (platform == EglPlatform::Surfaceless) {
    open = egl_->openSurfaceless(debug, description_);
  } else {
    open = egl_->openDevice(debug, false, description_);
  }
  if (!open) {
    failInput(
        "no OpenGL 4.5 core context without a window{}{}; install a driver that offers one (Mesa's "
        "llvmpipe does), and unset GALLIUM_DRIVER where it asks for another",
        egl_->highestSeen.empty() ? "" : ": ", egl_->highestSeen);
  }
}

HeadlessContext::~HeadlessContext() {
  if (egl_->display == EGL_NO_DISPLAY) return;
  eglMakeCurrent(egl_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(egl_->display, egl_->context);
  eglTerminate(egl_->display);
}

}  // namespace macula::window
