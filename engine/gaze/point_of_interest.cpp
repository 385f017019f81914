#include "engine/gaze/point_of_interest.h"

namespace macula::gaze {

std::string_view stateName(GazeState state) {
  switch (state) {
    case GazeState::Ok:
      return "ok";
    case GazeState::Held:
      return "held";
    case GazeState::Lost:
      return "lost";
    case GazeState::Easing:
      return "easing";
    case GazeState::Ended:
      return "ended";
    case GazeState::None:
      break;
  }
  return "none";
}

PointOfInterest exactPoint(const glm::dvec2& position) {
  PointOfInterest point;
  point.position = glm::vec2(glm::clamp(position, 0.0, 1.0));
  point.raw = glm::vec2(position);
  point.state = GazeState::Ok;
  point.ageSeconds = 0.0F;
  return point;
}

}  // namespace macula::gaze
