#include "engine/gl/capabilities.h"

#include <algorithm>
#include <initializer_list>

#include "engine/core/error.h"
#include "engine/gl/gl.h"

namespace macula::gl {
namespace {

std::string text(GLenum name) {
  const GLubyte* value = glGetString(name);
  return value == nullptr ? std::string() : reinterpret_cast<const char*>(value);
}

int integer(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

/// Numbers of samples that a format can really have: a number in between is rounded up.
std::vector<int> samplesOf(GLenum format) {
  GLint count = 0;
  glGetInternalformativ(GL_TEXTURE_2D_MULTISAMPLE, format, GL_NUM_SAMPLE_COUNTS, 1, &count);
  std::vector<int> samples(static_cast<std::size_t>(count));
  glGetInternalformativ(GL_TEXTURE_2D_MULTISAMPLE, format, GL_SAMPLES, count, samples.data());
  std::sort(samples.begin(), samples.end());
  return samples;
}

std::vector<int> samplesOfAll(std::initializer_list<GLenum> formats) {
  std::vector<int> common = samplesOf(*formats.begin());
  for (const GLenum format : formats) {
    const std::vector<int> own = samplesOf(format);
    std::erase_if(common, [&](int n) { return !std::binary_search(own.begin(), own.end(), n); });
  }
  return common;
}

}  // namespace

bool compilesInParallel() {
  return epoxy_has_gl_extension("GL_KHR_parallel_shader_compile") ||
         epoxy_has_gl_extension("GL_ARB_parallel_shader_compile");
}

Capabilities readCapabilities() {
  constexpr int kNeededVersion = 45;
  Capabilities c;
  c.renderer = text(GL_RENDERER);
  c.version = text(GL_VERSION);
  c.vendor = text(GL_VENDOR);
  if (epoxy_gl_version() < kNeededVersion) {
    failInput("{}: offers OpenGL {}, and Macula needs 4.5; use a newer driver or another device",
              c.renderer, c.version);
  }
  c.major = integer(GL_MAJOR_VERSION);
  c.minor = integer(GL_MINOR_VERSION);
  c.limits = readLimits();
  c.maxSamples = integer(GL_MAX_SAMPLES);
  c.routableSamples = samplesOfAll({GL_RG32UI, GL_RGBA16F, GL_DEPTH32F_STENCIL8});
  c.fragmentShaderInterlock = epoxy_has_gl_extension("GL_ARB_fragment_shader_interlock");
  c.parallelCompile = compilesInParallel();
  c.timerQuery = true;  // core since 3.3; whether it tells the truth is for the time-source check
  if (c.renderer.starts_with("llvmpipe")) {
    constexpr std::uint32_t kLlvmpipeLoopIterations = 65535;
    c.ordersFragmentsPerPixel = true;
    c.isSoftware = true;
    c.maxLoopIterations = kLlvmpipeLoopIterations;
  }
  return c;
}

}  // namespace macula::gl
