// The level of a noisy quantity that may step: what one resizable pixel, or the rest, costs.
#pragma once

namespace macula::control {

/// Follows a positive quantity through noise, drift and steps. Small deviations move the level a
/// little, more so where several point the same way. A large one is an outlier while it is alone,
/// and a step when the next one agrees: then the level is there at once.
class WorkEstimate {
 public:
  enum class Outcome { First, Followed, Outlier, Stepped };

  /// @param value > 0
  Outcome observe(double value);

  /// All values to come are `factor` times as large. @param factor > 0
  void scale(double factor) {
    level_ *= factor;
    suspected_ = false;
  }

  [[nodiscard]] bool known() const { return known_; }
  [[nodiscard]] double level() const { return level_; }
  /// Standard deviation of the values over the level, without outliers.
  [[nodiscard]] double relativeSpread() const { return spread_; }

 private:
  bool known_ = false;
  bool suspected_ = false;
  double level_ = 0.0;
  double suspect_ = 0.0;
  double spread_ = 0.0;
  int sameSign_ = 0;  ///< length of the present run of deviations of one sign, negative below
};

}  // namespace macula::control
