// Holds a frame time: a law for r, and controls for what r cannot give. No GL, no clock.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "engine/control/control_settings.h"
#include "engine/control/law.h"
#include "engine/control/quality_controls.h"
#include "engine/control/slow_controls.h"

namespace macula::control {

/// Whether a clock can be controlled by: work that is done four times must take longer than done
/// once. @returns why not, in one line; empty where it can
/// @param once, fourTimes ms of the same work, by the clock that is to be used
[[nodiscard]] std::string clockFault(double once, double fourTimes);

/// Chooses the controls of each frame. Call i of next() is about frame i; times name that index.
class Controller {
 public:
  /// @param settings may change at any time; must outlive the controller
  /// @param fault clockFault(): with one, nothing is ever controlled
  explicit Controller(const ControlSettings& settings, std::string fault = {});

  /// @param newest the latest frame whose times have arrived since the last call; null for none
  /// @param usedResize r of the frame before as it was really used; 1 for the first
  /// @param work what the controls have to work on in this frame
  /// @returns the controls of this frame; at rest where nothing is controlled, see active()
  const ControlValues& next(const FrameTimes* newest, double usedResize, const ControlWork& work);

  /// The image has another size from the next frame on: what is known is scaled, or forgotten by
  /// laws that cannot. @param pixelRatio after over before, > 0
  void resized(double pixelRatio);
  /// Another scene from the next frame on: starts over, with all controls at rest.
  void restart();

  /// Whether the controls are to be used: a law is chosen, and nothing has switched it off.
  [[nodiscard]] bool active() const { return active_; }
  [[nodiscard]] const ControlValues& controls() const { return values_; }
  /// The index of the frame that the next call is about.
  [[nodiscard]] std::uint64_t frame() const { return asked_; }
  /// One line on what it does or why it does nothing; empty where r alone holds the target.
  [[nodiscard]] std::string notice() const;

 private:
  void makeLaw();
  void observe(const FrameTimes& times);
  void moveResize(double wanted);
  [[nodiscard]] bool atEnd(double resize) const;
  [[nodiscard]] bool resizeHasWork(const ControlWork& work) const;

  const ControlSettings& settings_;
  ControlSettings made_;  ///< settings that the law was made from
  std::string fault_;
  std::unique_ptr<Law> law_;  ///< null: off
  SlowControls steps_;
  ControlValues values_;
  std::uint64_t asked_ = 0;
  std::uint64_t validFrom_ = 0;  ///< times of frames before it are of another size or scene
  std::uint64_t newest_ = 0;     ///< one after the newest frame whose times are known
  int workless_ = 0;             ///< times in a row that no resizable work took any
  double waitMs_ = 0.0;          ///< of the newest frame, for a display
  double intervalMs_ = 0.0;
  bool active_ = false;
  bool resizeWorks_ = true;
};

}  // namespace macula::control
