// hid_probe SCENARIO UHID_TRACKER: reads virtual trackers through EyeTracker and checks what came.
// Loss and order are checked; latencies are only printed, because a guest's time is not its own.
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "engine/gaze/hid/eye_tracker.h"
#include "tests/hid/device_process.h"

namespace {

using namespace macula::gaze::hid;
using testing::DeviceProcess;

// As uhid_tracker streams.
constexpr double kWidth = 500'000.0;
constexpr double kHeight = 300'000.0;
constexpr double kStep = 10.0;
/// Bounds every wait, so that a failure is told instead of a hang.
constexpr double kPatience = 20.0;
constexpr std::chrono::milliseconds kFrame{16};

std::string devicePath;

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void check(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error("FAILED: " + what);
}

/// A tracker, all that came from it, and every state it went through.
class Watched {
 public:
  explicit Watched(TrackerChoice choice)
      : tracker_(std::make_unique<EyeTracker>(std::move(choice))) {
    fresh_.reserve(kSampleRing);
  }

  void frame() {
    fresh_.clear();
    tracker_->drain(fresh_);
    samples.insert(samples.end(), fresh_.begin(), fresh_.end());
    std::this_thread::sleep_for(kFrame);
  }

  void until(const std::string& what, const std::function<bool()>& holds) {
    const double begin = now();
    while (!holds()) {
      check(now() - begin < kPatience, "gave up waiting until " + what + "; " + describe());
      frame();
    }
  }
  void untilState(Connection connection) {
    until(std::string(connectionName(connection)),
          [&] { return status().connection == connection; });
  }
  void untilSamples(std::size_t count) {
    until(std::to_string(count) + " samples", [&] { return samples.size() >= count; });
  }

  [[nodiscard]] TrackerStatus status() const { return tracker_->status(); }
  [[nodiscard]] std::string describe() const {
    const TrackerStatus s = status();
    return std::string(connectionName(s.connection)) + ", " + std::to_string(samples.size()) +
           " samples, " + std::to_string(s.received) + " received, " + std::to_string(s.dropped) +
           " dropped, " + std::to_string(s.garbage) + " garbage: " + s.message;
  }
  void end() { tracker_.reset(); }

  std::vector<HidSample> samples;

 private:
  std::unique_ptr<EyeTracker> tracker_;
  std::vector<HidSample> fresh_;
};

TrackerChoice bySerial(const std::string& serial) {
  return parseTrackerChoice("1209:0001:" + serial);
}

/// The samples are the stream 0, 1, ... of that y, none missing and none twice.
void checkStream(std::span<const HidSample> samples, double y) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const HidSample& sample = samples[i];
    check(sample.valid, "sample " + std::to_string(i) + " is not valid");
    const glm::dvec2 wanted{kStep * static_cast<double>(i) / kWidth, y / kHeight};
    check(std::abs(sample.position.x - wanted.x) < 1e-9 &&
              std::abs(sample.position.y - wanted.y) < 1e-9,
          "sample " + std::to_string(i) + " is out of order or misplaced: " +
              std::to_string(sample.position.x) + "," + std::to_string(sample.position.y));
  }
}

/// Samples from `begin` on are such a stream of `count`, and there are no others.
void checkStream(const Watched& watched, std::size_t begin, std::size_t count, double y) {
  check(watched.samples.size() == begin + count,
        "wanted " + std::to_string(begin + count) + " samples; " + watched.describe());
  checkStream(std::span(watched.samples).subspan(begin), y);
}

void printLatencies(const Watched& watched) {
  std::vector<double> late;
  for (const HidSample& sample : watched.samples) {
    if (sample.deviceSeconds) late.push_back((sample.hostSeconds - *sample.deviceSeconds) * 1e3);
  }
  check(late.size() > watched.samples.size() / 2, "few samples have a device time");
  std::sort(late.begin(), late.end());
  const auto at = [&](double share) {
    return late[static_cast<std::size_t>(share * static_cast<double>(late.size() - 1))];
  };
  std::printf("  write to read: p50 %.3f ms, p99 %.3f ms, max %.3f ms (%zu samples)\n", at(0.5),
              at(0.99), at(1.0), late.size());
}

void rate(int hertz, std::size_t count, const std::string& variant) {
  DeviceProcess device(devicePath);
  device.obey("create A " + variant + " all");
  Watched watched(bySerial("A"));
  device.begin("await-mode");
  watched.untilState(Connection::Opening);
  device.finish();
  device.begin("stream " + std::to_string(hertz) + " " + std::to_string(count) + " 150000");
  // Frames, not a wait for the device: the ring holds four seconds of 1 kHz.
  const double begin = now();
  while (watched.samples.size() < count &&
         now() - begin < kPatience + 3.0 * double(count) / hertz) {
    watched.frame();
  }
  device.finish();
  checkStream(watched, 0, count, 150'000);
  const TrackerStatus status = watched.status();
  check(status.received == count && status.dropped == 0 && status.garbage == 0, watched.describe());
  check(status.calibratedMm && std::abs(status.calibratedMm->x - 500.0) < 1e-6 &&
            std::abs(status.calibratedMm->y - 300.0) < 1e-6,
        "calibrated size");
  std::printf("  %zu reports at %d Hz: 0 lost, in order\n", count, hertz);
  printLatencies(watched);
}

void rate250() {
  rate(250, 10'000, "bytes");
}

void rate1000() {
  rate(1000, 10'000, "wide");
}

void replug() {
  DeviceProcess device(devicePath);
  std::vector<std::unique_ptr<DeviceProcess>> others;
  Watched watched(bySerial("A"));
  std::string path;
  for (int round = 0; round < 5; ++round) {
    device.obey(round % 2 == 0 ? "create A bytes all" : "create A wide all");
    const double plugged = now();
    watched.untilState(Connection::Opening);
    const TrackerStatus status = watched.status();
    check(status.path != path, "the path should be a new one: " + path);
    path = status.path;
    std::printf("  %s found after %.0f ms", path.c_str(), (status.sinceSeconds - plugged) * 1e3);
    device.obey("await-mode");
    watched.samples.clear();
    device.obey("stream 250 200 1000");
    // What still waits in the kernel's ring at the unplug must not be lost: no pause before it.
    device.obey("stream 100000 40 2000");
    const double unplugged = std::stod(device.obey("destroy"));
    watched.untilState(Connection::Unplugged);
    watched.frame();
    std::printf(", unplug noticed after %.3f ms\n",
                (watched.status().sinceSeconds - unplugged) * 1e3);
    const std::vector<HidSample> all = watched.samples;
    check(all.size() == 240, "240 samples before the unplug; " + watched.describe());
    checkStream(std::span(all).first(200), 1000);
    checkStream(std::span(all).last(40), 2000);
    // Another device takes the path, so that the tracker comes back under a new one.
    others.push_back(std::make_unique<DeviceProcess>(devicePath));
    others.back()->obey("create OTHER" + std::to_string(round) + " bytes all");
    const std::size_t taken = others.size();
    watched.until("the path is taken", [&] { return listTrackers().size() == taken; });
  }
}

void blink() {
  DeviceProcess device(devicePath);
  device.obey("create A bytes all");
  Watched watched(bySerial("A"));
  device.obey("await-mode");
  device.obey("status 1 250");
  device.obey("stream 250 50 1000");
  watched.untilSamples(50);
  checkStream(watched, 0, 50, 1000);
  watched.untilState(Connection::Silent);
  check(std::abs(watched.status().reportedHz - 250.0) < 1e-9, "stated rate");
  device.obey("stream 250 50 2000");
  watched.untilSamples(100);
  checkStream(watched, 50, 50, 2000);
  check(watched.status().connection != Connection::Unplugged, "silence is no unplug");
  device.obey("blink 5");
  watched.untilSamples(105);
  for (std::size_t i = 100; i < 105; ++i) {
    check(!watched.samples[i].valid && std::isnan(watched.samples[i].position.x), "INT32_MAX");
  }
  device.obey("status 4 250");
  watched.until("calibration is asked for",
                [&] { return watched.status().message.find("calibration") != std::string::npos; });
}

void garbage() {
  DeviceProcess device(devicePath);
  device.obey("create A wide all");
  Watched watched(bySerial("A"));
  device.obey("await-mode");
  for (std::size_t round = 1; round <= 10; ++round) {
    device.obey("garbage 5");
    device.obey("stream 1000 20 1000");
    watched.untilSamples(20 * round);
    checkStream(watched, 20 * (round - 1), 20, 1000);
  }
  // Which damaged reports arrive is the kernel's choice: it drops unknown ids itself.
  const TrackerStatus status = watched.status();
  check(status.garbage >= 50 && status.garbage <= 200, "garbage; " + watched.describe());
  std::printf("  of 200 damaged reports %llu arrived and were counted; 200 good ones of 200\n",
              static_cast<unsigned long long>(status.garbage));
}

/// The kernel waits five seconds for an answer; nobody else does.
void muteMode() {
  DeviceProcess device(devicePath);
  device.obey("create A bytes get");
  Watched watched(bySerial("A"));
  device.obey("await-open");
  watched.untilState(Connection::Opening);
  watched.until("the size is known", [&] {
    return watched.status().calibratedMm.has_value() &&
           watched.status().message.find("range") == std::string::npos;
  });
  const double begin = now();
  device.obey("stream 250 500 1000");  // it streams all the same
  watched.untilSamples(500);
  checkStream(watched, 0, 500, 1000);
  std::printf("  500 reports %.1f s after the request that is never answered\n", now() - begin);
  watched.until("the missing answer is told", [&] {
    return watched.status().message.find("does not answer") != std::string::npos;
  });
  std::printf("  told after %.1f s: %s\n", now() - begin, watched.status().message.c_str());
}

void muteAll() {
  DeviceProcess device(devicePath);
  device.obey("create A bytes none");
  TrackerChoice choice = bySerial("A");
  choice.screenMm = glm::dvec2{kWidth, kHeight} * 1e-3;
  {
    Watched watched(choice);
    device.obey("await-open");
    device.obey("stream 250 250 1000");
    watched.untilSamples(250);
    checkStream(watched, 0, 250, 1000);
    const double begin = now();
    watched.end();
    std::printf("  closed in %.0f ms while a request hangs\n", (now() - begin) * 1e3);
    check(now() - begin < 4.0, "closing waits for the device");
  }
}

void denied() {
  DeviceProcess device(devicePath);
  device.obey("create A bytes all");
  TrackerInfo info;
  for (int i = 0; i < 100 && info.path.empty(); ++i) {
    const auto found = listTrackers();
    if (!found.empty()) info = found.front();
    std::this_thread::sleep_for(kFrame);
  }
  check(!info.path.empty(), "the tracker is listed");
  check(::chmod(info.path.c_str(), 0600) == 0, "chmod");
  std::fflush(stdout);
  const pid_t child = ::fork();
  if (child == 0) {
    int result = 1;
    try {
      check(::setgid(1000) == 0 && ::setuid(1000) == 0, "setuid");
      check(!listTrackers().front().accessible, "listed as out of reach");
      Watched watched(bySerial("A"));
      watched.untilState(Connection::Denied);
      const std::string message = watched.status().message;
      check(message.find("70-macula-eye-tracker.rules") != std::string::npos, message);
      std::printf("  %s\n", message.c_str());
      std::fflush(stdout);
      watched.untilState(Connection::Opening);  // once the parent grants it
      result = 0;
    } catch (const std::exception& error) {
      std::printf("%s\n", error.what());
    }
    std::fflush(stdout);
    ::_exit(result);
  }
  std::this_thread::sleep_for(std::chrono::seconds(1));
  check(::chmod(info.path.c_str(), 0666) == 0, "chmod");
  int status = 1;
  ::waitpid(child, &status, 0);
  check(status == 0, "as another user");
}

/// A device that does not speak page 0x12, read by the example profile.
void profile() {
  DeviceProcess device(devicePath);
  device.obey("create A vendor all");
  TrackerChoice choice;
  choice.profile = readProfile("/assets/trackers/example.toml");
  Watched watched(choice);
  device.obey("await-mode");
  check(listTrackers().empty(), "it is no tracker of page 0x12");
  device.obey("stream 250 500 432");
  watched.untilSamples(500);
  for (std::size_t i = 0; i < 500; ++i) {
    const HidSample& sample = watched.samples[i];
    check(sample.valid && std::abs(sample.position.x - double(i) / 4.0 / 1920.0) < 1e-9 &&
              std::abs(sample.position.y - 0.1) < 1e-9,
          "sample " + std::to_string(i));
  }
}

void two() {
  DeviceProcess first(devicePath);
  DeviceProcess second(devicePath);
  first.obey("create LEFT bytes all");
  second.obey("create RIGHT wide all");
  Watched left(bySerial("LEFT"));
  Watched right(bySerial("RIGHT"));
  first.obey("await-mode");
  second.obey("await-mode");
  check(listTrackers().size() == 2, "each tracker is listed once");
  first.begin("stream 250 500 1000");
  second.begin("stream 250 500 2000");
  const auto both = [&] { return left.samples.size() >= 500 && right.samples.size() >= 500; };
  left.until("both have streamed", [&] {
    right.frame();
    return both();
  });
  first.finish();
  second.finish();
  checkStream(left, 0, 500, 1000);
  checkStream(right, 0, 500, 2000);
}

}  // namespace

int main(int argc, char** argv) {
  const std::map<std::string, void (*)()> scenarios{
      {"rate250", rate250}, {"rate1000", rate1000},  {"replug", replug},    {"blink", blink},
      {"garbage", garbage}, {"mute-mode", muteMode}, {"mute-all", muteAll}, {"denied", denied},
      {"two", two},         {"profile", profile}};
  const auto scenario = argc == 3 ? scenarios.find(argv[1]) : scenarios.end();
  if (scenario == scenarios.end()) {
    std::printf("usage: hid_probe SCENARIO UHID_TRACKER\n");
    return 2;
  }
  devicePath = argv[2];
  const double begin = now();
  std::printf("%s\n", argv[1]);
  try {
    scenario->second();
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
    return 1;
  }
  std::printf("  passed in %.1f s\n", now() - begin);
  return 0;
}
