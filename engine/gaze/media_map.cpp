#include "engine/gaze/media_map.h"

namespace macula::gaze {

bool Rectangle::holds(const Rectangle& other) const {
  return glm::all(glm::lessThanEqual(origin, other.origin)) &&
         glm::all(glm::greaterThanEqual(origin + size, other.origin + other.size));
}

void MediaMap::note(const Rectangle& medium) {
  if (any_ && medium == last_) return;  // as nearly always
  const glm::dvec2 end = medium.origin + medium.size;
  low_ = any_ ? glm::min(low_, medium.origin) : medium.origin;
  high_ = any_ ? glm::max(high_, end) : end;
  any_ = true;
  last_ = medium;
  if (medium.origin == glm::dvec2(0.0) && (!largest_ || medium.holds(*largest_))) {
    largest_ = medium;
  }
}

std::optional<Rectangle> MediaMap::screen() const {
  const bool holdsAll = largest_ && glm::all(glm::lessThanEqual(largest_->origin, low_)) &&
                        glm::all(glm::greaterThanEqual(largest_->origin + largest_->size, high_));
  return holdsAll ? largest_ : std::nullopt;
}

}  // namespace macula::gaze
