// Frame times of the last frames with their passes stacked, and the layers that were stored.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
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

/// Layers a sample, where a method stores any.
struct LayerRow {
  float mean = 0.0F;
  float most = 0.0F;
  std::optional<float> budget;  ///< layers a sample that the memory budget pays for
};

/// A ring of frames. Once every pass was seen, taking and drawing frames allocates nothing.
class Timeline {
 public:
  /// Takes the times of one frame.
  /// @param totalMs of the whole frame, >= 0
  void add(std::span<const TimeRow> passes, double totalMs, const std::optional<LayerRow>& layers);
  /// Draws the plots and the table of passes into the current window, over its width.
  void draw() const;

 private:
  /// Frames in the plot: four seconds at 60 frames a second.
  static constexpr std::size_t kHistory = 240;
  /// Passes that are told apart; times of further ones count as "other".
  static constexpr std::size_t kPasses = 24;

  struct Frame {
    std::array<float, kPasses> ms{};  ///< by the pass's place in passes_
    float totalMs = 0.0F;
    std::optional<LayerRow> layers;
  };
  struct PassRow {
    std::string name;
    double smoothedMs = 0.0;
    bool runs = false;  ///< in the newest frame
  };

  std::size_t indexOf(std::string_view name);
  /// @param age 0 is the newest frame
  [[nodiscard]] const Frame& frameAt(std::size_t age) const;
  void drawTimes() const;
  void drawLayers() const;
  void drawTable() const;
  void drawTooltip(const Frame& frame, std::size_t age) const;

  std::vector<PassRow> passes_;
  std::array<Frame, kHistory> frames_{};
  std::size_t next_ = 0;
  std::size_t count_ = 0;
};

}  // namespace macula::ui
