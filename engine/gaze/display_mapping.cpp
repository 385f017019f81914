#include "engine/gaze/display_mapping.h"

#include "engine/gaze/log.h"

namespace macula::gaze {

glm::dvec2 shareOfDisplay(const glm::dvec2& gaze, DeviceUnit unit, const WindowPlacement& placement,
                          const glm::dvec2& calibratedMicrometres) {
  switch (unit) {
    case DeviceUnit::Pixels:
      return gaze / (placement.monitorSize * placement.pixelsPerUnit);
    case DeviceUnit::Micrometres:
      return gaze / calibratedMicrometres;
    case DeviceUnit::Share:
      break;
  }
  return gaze;
}

glm::dvec2 displayToWindow(const glm::dvec2& share, const WindowPlacement& placement) {
  if (!(placement.clientSize.x > 0.0) || !(placement.clientSize.y > 0.0)) return kNoPosition;
  const glm::dvec2 onDesktop = placement.monitorOrigin + share * placement.monitorSize;
  return (onDesktop - placement.clientOrigin) / placement.clientSize;
}

}  // namespace macula::gaze
