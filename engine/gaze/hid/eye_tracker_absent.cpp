// What stands for the device thread where hidapi was left out (MACULA_HID=OFF).
#include "engine/gaze/hid/eye_tracker.h"

namespace macula::gaze::hid {

class EyeTracker::Thread {};

EyeTracker::EyeTracker(TrackerChoice) {}
EyeTracker::~EyeTracker() = default;

std::size_t EyeTracker::drain(std::vector<HidSample>&) {
  return 0;
}

TrackerStatus EyeTracker::status() const {
  TrackerStatus status;
  status.connection = Connection::Refused;
  status.message = "this program was built without HID eye trackers; build it with MACULA_HID=ON";
  return status;
}

std::vector<TrackerInfo> listTrackers() {
  return {};
}

bool hidSupported() {
  return false;
}

}  // namespace macula::gaze::hid
