// What the context offers, read once.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/gl/limits.h"

namespace macula::gl {

/// Limits and extensions of the current context that Macula decides by.
struct Capabilities {
  std::string renderer;
  std::string version;
  std::string vendor;
  int major = 0;
  int minor = 0;
  Limits limits;
  int maxSamples = 0;
  /// Numbers of samples in which multisample integer, half-float and stencil targets all exist.
  std::vector<int> routableSamples = {};
  bool fragmentShaderInterlock = false;  ///< GL_ARB_fragment_shader_interlock
  bool parallelCompile = false;          ///< GL_KHR_parallel_shader_compile, or ARB
  bool timerQuery = false;
  /// Rasterisers known to draw a pixel's fragments in order on one thread; still to be confirmed by
  /// the synchronisation self-test.
  bool ordersFragmentsPerPixel = false;
  /// Shaders run on the processor that runs the program, a work-group on one of its cores.
  bool isSoftware = false;
  /// Loop iterations after which the device ends a shader's loops; 0 where it never does. Mesa's
  /// llvmpipe stops at 65,535 in all (LP_MAX_TGSI_LOOP_ITERATIONS).
  std::uint32_t maxLoopIterations = 0;
};

/// Whether the driver compiles programs aside and says when one is ready.
[[nodiscard]] bool compilesInParallel();

/// @throws InputError where the context is below OpenGL 4.5, naming what it offers.
[[nodiscard]] Capabilities readCapabilities();

}  // namespace macula::gl
