#include "engine/gaze/hid/eye_tracker.h"

namespace macula::gaze::hid {

std::string_view connectionName(Connection connection) {
  switch (connection) {
    case Connection::Searching:
      return "searching";
    case Connection::Opening:
      return "opening";
    case Connection::Streaming:
      return "streaming";
    case Connection::Silent:
      return "silent";
    case Connection::Unplugged:
      return "unplugged";
    case Connection::Denied:
      return "denied";
    case Connection::Refused:
      break;
  }
  return "refused";
}

}  // namespace macula::gaze::hid
