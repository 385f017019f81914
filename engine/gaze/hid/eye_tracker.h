// A live HID eye tracker, read on a thread of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/gaze/hid/choice.h"
#include "engine/gaze/log.h"

namespace macula::gaze::hid {

/// Samples that wait for drain(): four seconds at 1 kHz. Beyond that, new ones are dropped.
inline constexpr std::size_t kSampleRing = 4096;
/// No report for this long is silence: a blink, in drivers that drop samples without an eye.
inline constexpr double kSilentSeconds = 0.1;

/// One gaze report as it came.
struct HidSample {
  double hostSeconds = 0.0;  ///< when it was read: std::chrono::steady_clock since its epoch
  /// By the device's clock, as it says; whether to believe it is ClockJudge's to say.
  std::optional<double> deviceSeconds;
  glm::dvec2 position = kNoPosition;  ///< 0..1 of the calibrated display from the top left, or NaN
  bool valid = false;                 ///< there is a position and the device believes in it
};

enum class Connection : std::uint8_t {
  Searching,  ///< no tracker that matches has been seen yet
  Opening,    ///< it is open; nothing has come so far
  Streaming,  ///< gaze comes
  Silent,     ///< open, but no report for kSilentSeconds
  Unplugged,  ///< it was there and is looked for
  Denied,     ///< this user may not open it; the message says what to do
  Refused,    ///< it cannot be read; the message says why
};

/// "searching", "streaming", ...
[[nodiscard]] std::string_view connectionName(Connection connection);

struct TrackerStatus {
  Connection connection = Connection::Searching;
  double sinceSeconds = 0.0;  ///< when `connection` last changed, by the clock of hostSeconds
  std::string name;
  std::string path;
  std::uint16_t vendorId = 0;
  std::uint16_t productId = 0;
  std::string serial;
  double reportedHz = 0.0;                 ///< sampling rate that the device states; 0: none
  std::optional<glm::dvec2> calibratedMm;  ///< what positions are divided by; absent: shares as is
  std::uint64_t received = 0;              ///< gaze reports, since the EyeTracker was made
  std::uint64_t dropped = 0;               ///< of those, did not fit into the ring
  std::uint64_t garbage = 0;               ///< reports that were none of the descriptor's
  std::string message;                     ///< one line for a person; may be empty
};

/// Reads one tracker: looks for it, opens it, asks it to stream, and after an unplug looks for it
/// again under whatever path it has then. Nothing here throws after construction or waits for the
/// device; several may run at once.
class EyeTracker {
 public:
  explicit EyeTracker(TrackerChoice choice);
  EyeTracker(const EyeTracker&) = delete;
  EyeTracker& operator=(const EyeTracker&) = delete;
  ~EyeTracker();

  /// Appends the samples since the last call, the oldest first. For one thread. Allocates only
  /// where `out` has less than kSampleRing free places.
  /// @return how many
  std::size_t drain(std::vector<HidSample>& out);

  [[nodiscard]] TrackerStatus status() const;

 private:
  class Thread;
  std::unique_ptr<Thread> thread_;
};

/// The eye trackers (usage page 0x12) that are plugged in, ordered by path.
[[nodiscard]] std::vector<TrackerInfo> listTrackers();

/// False where the program was built without hidapi: no tracker is ever found.
[[nodiscard]] bool hidSupported();

}  // namespace macula::gaze::hid
