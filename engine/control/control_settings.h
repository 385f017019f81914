// Settings of the control of the frame time.
#pragma once

#include <string>

#include "engine/control/law.h"
#include "engine/settings/registry.h"

namespace macula::control {

struct ControlSettings {
  std::string law = "off";          ///< or one of lawNames()
  double targetMs = 1000.0 / 60.0;  ///< of the GPU's part of a frame
  double expectedWorkMs = 20.0;     ///< LawOptions::expectedWorkMs
  double fixedResize = 1.0;         ///< of the law `fixed`
  double resizeStep = 0.0;          ///< r comes in multiples of it; 0: as it is
  double mostResize = 4.0;          ///< a sixteenth of the pixels; beyond, others take over
  double leastAim = kLeastAim;      ///< LawOptions::leastAim
  bool fovea = true;                ///< the fovea's slope may be moved
  bool layers = true;               ///< the layers' share may be moved

  bool operator==(const ControlSettings&) const = default;
};

[[nodiscard]] LawOptions lawOptionsOf(const ControlSettings& settings);

/// `settings` must outlive the registry.
void registerSettings(settings::Registry& registry, ControlSettings& settings);

}  // namespace macula::control
