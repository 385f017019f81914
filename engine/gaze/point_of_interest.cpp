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
    case GazeState::None:
      break;
  }
  return "none";
}

}  // namespace macula::gaze
