// Pass times as a table with bars, and the frame time over the last frames as a plot.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace macula::ui {

/// The time of one pass in one frame.
struct TimeRow {
  std::string_view name;
  double ms = 0.0;  ///< >= 0
};

class TimingsPanel {
 public:
  /// Takes the times of one frame. @param totalMs of the whole frame, >= 0
  void add(std::span<const TimeRow> passes, double totalMs);
  /// Draws into the current window, over its width.
  void draw() const;

  /// Over the frames of the plot; 0 before the first.
  [[nodiscard]] double medianMs() const;

 private:
  void drawPlot() const;
  void drawTable() const;

  struct Smoothed {
    std::string name;
    double ms = 0.0;
  };
  /// Frames in the plot: two seconds at 60 frames a second.
  static constexpr std::size_t kHistory = 120;

  std::vector<Smoothed> passes_;
  std::array<float, kHistory> totals_{};  ///< a ring; the oldest is at next_ once it is full
  std::size_t next_ = 0;
  std::size_t count_ = 0;
};

}  // namespace macula::ui
