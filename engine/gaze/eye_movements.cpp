// This work is based on: Olsen 2012, "The Tobii I-VT Fixation Filter"; Salvucci and Goldberg 2000,
// "Identifying fixations and saccades in eye-tracking protocols" (I-VT).
#include "engine/gaze/eye_movements.h"

#include "engine/gaze/tracker.h"

namespace macula::gaze {

EyeMovementClassifier::EyeMovementClassifier(double threshold, const Display& display)
    : threshold_(threshold), display_(display) {}

void EyeMovementClassifier::settle(Tally& tally) const {
  if (tally.pending) {
    const double seconds = tally.pending->end.time - tally.pending->begin.time;
    if (seconds >= kIvtShortestFixation - kTimeTolerance) {
      ++tally.fixations;
      tally.fixationSeconds += seconds;
    }
    tally.pending.reset();
  }
  tally.saccades += tally.pendingSaccades;
  tally.saccadeDegrees += tally.pendingDegrees;
  tally.pendingSaccades = 0;
  tally.pendingDegrees = 0.0;
}

void EyeMovementClassifier::close(Tally& tally, const Movement& movement) const {
  if (movement.kind == Kind::Saccade) {
    ++tally.pendingSaccades;
    tally.pendingDegrees += angleBetween(movement.begin.place, movement.end.place, display_);
  }
  if (movement.kind != Kind::Fixation) return;
  if (tally.pending &&
      movement.begin.time - tally.pending->end.time <= kIvtMergeSeconds + kTimeTolerance &&
      angleBetween(tally.pending->end.place, movement.begin.place, display_) <= kIvtMergeDegrees) {
    tally.pending->end = movement.end;
    tally.pendingSaccades = 0;
    tally.pendingDegrees = 0.0;
    return;
  }
  settle(tally);
  tally.pending = movement;
}

double EyeMovementClassifier::speedTo(const Point& point) {
  // The oldest sample within the window, but at least the one before.
  const auto at = [&](std::size_t back) -> const Point& {
    return recent_[(next_ + recent_.size() - back) % recent_.size()];
  };
  while (held_ > 1 && point.time - at(held_).time > kIvtWindowSeconds + kTimeTolerance) --held_;
  const Point& from = at(held_);
  return angleBetween(from.place, point.place, display_) / (point.time - from.time);
}

void EyeMovementClassifier::add(double timeSeconds, const std::optional<glm::dvec2>& place) {
  const auto stop = [&] {
    close(tally_, current_);
    current_ = {};
    held_ = 0;
  };
  if (!place) {
    if (held_ > 0) stop();
    return;
  }
  const Point point{timeSeconds, *place};
  if (held_ > 0) {
    const Point last = recent_[(next_ + recent_.size() - 1) % recent_.size()];
    if (point.time - last.time > kIvtMergeSeconds + kTimeTolerance) {
      stop();
    } else {
      const Kind kind = speedTo(point) >= threshold_ ? Kind::Saccade : Kind::Fixation;
      if (kind != current_.kind) {
        close(tally_, current_);
        current_ = {kind, last, last};
      }
      current_.end = point;
    }
  }
  recent_[next_] = point;
  next_ = (next_ + 1) % recent_.size();
  if (held_ < recent_.size()) ++held_;
}

EyeMovements EyeMovementClassifier::result() const {
  Tally tally = tally_;
  close(tally, current_);
  settle(tally);
  EyeMovements movements{.fixations = tally.fixations, .saccades = tally.saccades};
  if (tally.fixations > 0) {
    movements.fixationSeconds = tally.fixationSeconds / static_cast<double>(tally.fixations);
  }
  if (tally.saccades > 0) {
    movements.saccadeDegrees = tally.saccadeDegrees / static_cast<double>(tally.saccades);
  }
  return movements;
}

}  // namespace macula::gaze
