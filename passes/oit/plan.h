// What the transparency passes of one frame agree on.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "engine/gl/program.h"
#include "passes/oit/methods.h"
#include "passes/oit/sync.h"

namespace macula::passes {

/// Settings of transparency, as a user means them.
struct OitSettings {
  std::string method = "kb-variable";
  double kAve = 4.0;       ///< slots per sample on average, > 0
  double memoryMiB = 0.0;  ///< 0: by kAve
  std::string sync = "auto";
};

/// Settings of the importance map (Vasilakis 2017, Eq. 3-6).
struct ImportanceSettings {
  double rangeBias = 0.35;     ///< alpha of Eq. 3
  double periphery = 3.0;      ///< d of Eq. 4
  double noise = 0.1;          ///< lambda of Eq. 6
  double layerLimit = 0.0;     ///< N_limit of Eq. 3; 0: the largest count seen so far
  bool noisePerFrame = false;  ///< a new xi every frame
};

/// Bytes of one stored fragment: 32-bit depth, 32-bit id, premultiplied RGBA16F.
inline constexpr std::uint64_t kFragmentBytes = 16;

/// What follows from settings, size and machine.
struct OitPlan {
  const Method* method = nullptr;
  SyncMode sync = SyncMode::Spinlock;
  std::uint32_t slots = 1;                        ///< of the fragment pool
  std::optional<std::uint64_t> budgetBytes = {};  ///< null for methods without a budget
  ImportanceSettings importance = {};
  float layerLimit = 1.0F;  ///< N_limit in use
  std::uint32_t seed = 1;
  bool factorMaps = false;          ///< importance factors are shown
  std::uint32_t largestLayers = 0;  ///< largest k(p) of the last frame

  /// Whether each pixel has a spin lock.
  [[nodiscard]] bool usesLocks() const {
    return method->insertion == Insertion::Sorted && sync == SyncMode::Spinlock;
  }
};

/// Slots and bytes for a budgeted method.
/// @param samples width times height of the frame in samples
/// @throws InputError where the budget holds no fragment
void planBudget(OitPlan& plan, const OitSettings& settings, std::uint64_t samples);

/// Defines that specialise the shaders of the plan's method.
[[nodiscard]] gl::Defines definesOf(const OitPlan& plan);

}  // namespace macula::passes
