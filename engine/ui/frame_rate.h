// Frames a second as the viewer gets them, and how long a method takes to draw one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace macula::ui {

/// Frames a second from present to present: what waits for the display or is spent between two
/// frames counts, too.
class FrameRate {
 public:
  /// @param seconds when a frame was presented, of a clock that does not go back
  void presented(double seconds) {
    presents_.push_back(seconds);
    while (presents_.size() > 2 && seconds - presents_[1] >= kSpanSeconds) presents_.pop_front();
  }
  /// No frame was wanted for a while, as of a minimised window.
  void restart() { presents_.clear(); }

  /// The mean over the last frames that together took the span, at least one; none before the
  /// second frame.
  [[nodiscard]] std::optional<double> perSecond() const {
    if (presents_.size() < 2) return {};
    const double span = presents_.back() - presents_.front();
    if (span <= 0.0) return {};
    return static_cast<double>(presents_.size() - 1) / span;
  }

 private:
  static constexpr double kSpanSeconds = 1.0;  ///< steady to read, yet follows a change at once
  std::deque<double> presents_;
};

/// The median time of the last frames that one method drew.
class MethodTime {
 public:
  /// @param method another one than before begins again
  /// @param ms from begin to end of its frame, >= 0
  void add(std::string_view method, double ms) {
    if (method != method_) {
      method_ = method;
      times_.clear();
    }
    times_.push_back(ms);
    if (times_.size() > kFrames) times_.pop_front();
  }
  [[nodiscard]] const std::string& method() const { return method_; }
  /// Milliseconds, the upper one of two in the middle; 0 before the first frame.
  [[nodiscard]] double medianMs() const {
    if (times_.empty()) return 0.0;
    std::vector<double> sorted(times_.begin(), times_.end());
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return *middle;
  }

 private:
  static constexpr std::size_t kFrames = 240;  ///< as many as the plot of times has
  std::string method_;
  std::deque<double> times_;
};

}  // namespace macula::ui
