// Where on the screen pictures were shown, as far as it tells how large the screen is.
#pragma once

#include <glm/glm.hpp>
#include <optional>

namespace macula::gaze {

/// A part of the screen in pixels, from its top left.
struct Rectangle {
  glm::dvec2 origin{0.0};
  glm::dvec2 size{0.0};
  [[nodiscard]] bool holds(const Rectangle& other) const;
  bool operator==(const Rectangle&) const = default;
};

/// Collects which media (pictures, pages, or the bare screen) lay where; in bounded memory.
class MediaMap {
 public:
  /// One more medium; may come any number of times.
  void note(const Rectangle& medium);

  [[nodiscard]] bool any() const { return any_; }

  /// The medium that shows the screen: at (0, 0), holding all the others.
  [[nodiscard]] std::optional<Rectangle> screen() const;

 private:
  bool any_ = false;
  Rectangle last_;
  glm::dvec2 low_{0.0};   ///< corners of the rectangle
  glm::dvec2 high_{0.0};  ///< around every medium
  std::optional<Rectangle> largest_;
};

}  // namespace macula::gaze
