// What a controller may move, and in which order: r first, then what is missed more.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "engine/control/law.h"

namespace macula::control {

enum class QualityControl : std::size_t { Resize, FoveaSlope, LayerShare };
inline constexpr std::size_t kControlCount = 3;

/// The range of a control, from rest to its end, and a slow control's step.
struct ControlInfo {
  QualityControl control;
  std::string_view name;   ///< for files
  std::string_view title;  ///< for people
  double rest;
  double end;
  double step;  ///< factor of one step; 0: moved by the law, without steps
  /// Frame time before one step over the time after it, at the most: that of a frame which is
  /// nothing but this control's work.
  double mostGain;
};

/// The order in which controls come into play; they are released from the end. Least error for each
/// millisecond saved goes first, which `macula chart` measures. r takes detail everywhere and gives
/// time in proportion to the pixels. The fovea's slope takes what the eye resolves least, and gives
/// less. Fewer layers take whole surfaces out of the transparent depth.
///
/// A step changes a slow control by a quarter: less is lost in the noise, more is seen. Layers cost
/// in proportion to their number; foveated samples to the inverse square of the slope. Ends: four
/// times the slope of Guenter et al. 2012 shades coarser than anything they found acceptable; with
/// a quarter of the layers, k-buffers of 4 layers are down to 1.
inline constexpr std::array<ControlInfo, kControlCount> kControlOrder{{
    {QualityControl::Resize, "resize", "r", kLeastResize, kMostResize, 0.0, 1.0},
    {QualityControl::FoveaSlope, "fovea_slope", "fovea's slope", 1.0, 4.0, 1.25, 1.25 * 1.25},
    {QualityControl::LayerShare, "layer_share", "share of the layers", 1.0, 0.25, 0.8, 1.25},
}};

/// Where the controls stand. As built: all at rest.
struct ControlValues {
  std::array<double, kControlCount> at{1.0, 1.0, 1.0};

  [[nodiscard]] double operator[](QualityControl control) const {
    return at[static_cast<std::size_t>(control)];
  }
  [[nodiscard]] double& operator[](QualityControl control) {
    return at[static_cast<std::size_t>(control)];
  }
  bool operator==(const ControlValues&) const = default;
};

/// Whether each control has anything to work on in the present frame.
struct ControlWork {
  bool resize = true;   ///< something is computed at 1/r
  bool fovea = false;   ///< shading is foveated
  bool layers = false;  ///< a k-buffer stores transparent surfaces within a budget

  [[nodiscard]] bool operator[](QualityControl control) const {
    return control == QualityControl::Resize       ? resize
           : control == QualityControl::FoveaSlope ? fovea
                                                   : layers;
  }
};

}  // namespace macula::control
