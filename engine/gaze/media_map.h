// From pixels of the screen to 0..1, by where the file says that pictures were shown.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "engine/gaze/log.h"

namespace macula::gaze {

/// A part of the screen in pixels, from its top left.
struct Rectangle {
  glm::dvec2 origin{0.0};
  glm::dvec2 size{0.0};
  [[nodiscard]] bool holds(const Rectangle& other) const;
  bool operator==(const Rectangle&) const = default;
};

/// Collects which medium (picture, page, or the bare screen) lay where during which samples.
class MediaMap {
 public:
  /// The medium during a sample; nothing where the row does not say. Samples come in order.
  void note(std::size_t sampleIndex, const std::optional<Rectangle>& medium);

  /// Turns the positions of the log from pixels into 0..1: of the screen, where the file shows it
  /// (a medium at (0, 0) that holds all the others), since media of other sizes then leave the
  /// place on the screen alone; otherwise of the medium of each sample. Samples of unknown medium
  /// become lost. States the screen's size in the log.
  /// @returns false where no sample had a medium
  [[nodiscard]] bool normalise(GazeLog& log) const;

 private:
  struct Change {
    std::size_t firstSample = 0;
    std::optional<Rectangle> medium;
  };
  [[nodiscard]] std::optional<Rectangle> screen() const;

  std::vector<Change> changes_;
};

}  // namespace macula::gaze
