#include "engine/gaze/media_map.h"

#include <algorithm>

namespace macula::gaze {

bool Rectangle::holds(const Rectangle& other) const {
  return glm::all(glm::lessThanEqual(origin, other.origin)) &&
         glm::all(glm::greaterThanEqual(origin + size, other.origin + other.size));
}

void MediaMap::note(std::size_t sampleIndex, const std::optional<Rectangle>& medium) {
  if (changes_.empty() || changes_.back().medium != medium) {
    changes_.push_back({sampleIndex, medium});
  }
}

std::optional<Rectangle> MediaMap::screen() const {
  std::optional<Rectangle> largest;
  for (const Change& change : changes_) {
    if (!change.medium || change.medium->origin != glm::dvec2(0.0)) continue;
    if (!largest || change.medium->holds(*largest)) largest = change.medium;
  }
  const bool holdsAll =
      largest && std::all_of(changes_.begin(), changes_.end(), [&](const Change& change) {
        return !change.medium || largest->holds(*change.medium);
      });
  return holdsAll ? largest : std::nullopt;
}

bool MediaMap::normalise(GazeLog& log) const {
  const std::optional<Rectangle> whole = screen();
  if (whole) log.coordinates.screenPixels = whole->size;

  bool any = false;
  std::size_t change = 0;
  for (std::size_t i = 0; i < log.samples.size(); ++i) {
    while (change + 1 < changes_.size() && changes_[change + 1].firstSample <= i) ++change;
    const std::optional<Rectangle> frame = whole ? whole : changes_[change].medium;
    GazeSample& sample = log.samples[i];
    if (frame) {
      any = true;
      sample.position = (sample.position - frame->origin) / frame->size;
    } else {
      sample.position = kNoPosition;  // pixels of something unknown are no place
      sample.valid = false;
    }
  }
  return any;
}

}  // namespace macula::gaze
