// uhid_tracker: a virtual eye tracker for tests, driven by lines on standard input. Needs
// /dev/uhid.
//
//   create SERIAL VARIANT ANSWERS   plugs it in; VARIANT bytes | wide | vendor (see
//                                   assets/trackers/example.toml); ANSWERS all | get | none
//   await-open · await-mode         until a program has it open, has set its mode
//   stream HZ COUNT Y               COUNT gaze reports; report i looks at (10 i, Y) micrometres
//   blink COUNT                     as many reports with INT32_MAX in place of the gaze
//   garbage COUNT                   as many damaged reports of each kind
//   status STATUS HZ                one status report
//   display WIDTH HEIGHT            another calibrated display, in micrometres
//   destroy                         unplugs it; answers with the time just before, in seconds
//
// Each line is answered by one: "ok ..." or "error ...". Times are CLOCK_MONOTONIC.
#include <time.h>

#include <cstdio>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>

#include "tests/hid/tracker_descriptor.h"
#include "tests/hid/uhid_device.h"

namespace {

using namespace macula::gaze::hid::testing;

constexpr std::int64_t kNanosecond = 1'000'000'000;
/// Of the display, in micrometres: report i of a stream lies within it for i below 50,000.
constexpr std::uint64_t kWidth = 500'000;
constexpr std::uint64_t kHeight = 300'000;
constexpr std::int64_t kStep = 10;
/// What a person waits for at most; the guest is slow.
constexpr int kAwaitMs = 20'000;
/// A device does not catch up on reports that it could not send in time: it would only fill the
/// kernel's ring of 64 while the reader cannot run.
constexpr int kLatePeriods = 4;

std::int64_t now() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec * kNanosecond + time.tv_nsec;
}

void sleepUntil(std::int64_t nanoseconds) {
  const timespec time{.tv_sec = nanoseconds / kNanosecond, .tv_nsec = nanoseconds % kNanosecond};
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr);
}

class Tracker {
 public:
  std::string obey(const std::string& line) {
    std::istringstream words(line);
    std::string command;
    words >> command;
    if (command == "create") return create(words);
    if (!device_) return "error nothing is plugged in";
    if (command == "await-open") return await([this] { return device_->isOpen(); });
    if (command == "await-mode") return await([this] { return device_->mode() != 0; });
    if (command == "stream") return stream(words);
    if (command == "blink") return blink(words);
    if (command == "garbage") return garbage(words);
    if (command == "status") return status(words);
    if (command == "display") return display(words);
    if (command == "destroy") return destroy();
    return "error unknown command";
  }

 private:
  std::string create(std::istream& words) {
    std::string serial;
    std::string variant;
    std::string answers;
    words >> serial >> variant >> answers;
    variant_ = {};
    if (variant == "wide") {
      variant_.wideTimestamp = true;
      variant_.padBytes = 7;
      variant_.flags = kDataVariable;
    }
    DeviceSettings settings;
    settings.serial = serial;
    settings.descriptor = trackerDescriptor(variant_);
    vendor_ = variant == "vendor";
    if (vendor_) {
      settings.vendorId = 0x1234;
      settings.productId = 0xABCD;
      settings.descriptor = vendorDescriptor();
    }
    settings.configuration = configurationReport(kWidth, kHeight);
    settings.answersGet = answers != "none";
    settings.answersSet = answers == "all";
    device_ = std::make_unique<UhidDevice>(settings);
    return "ok";
  }

  template <typename Condition>
  static std::string await(Condition&& holds) {
    constexpr std::int64_t kMillisecond = kNanosecond / 1000;
    for (int i = 0; i < kAwaitMs; ++i) {
      if (holds()) return "ok";
      sleepUntil(now() + kMillisecond);
    }
    return "error gave up waiting";
  }

  std::string stream(std::istream& words) {
    int hertz = 0;
    std::int64_t count = 0;
    std::int64_t y = 0;
    words >> hertz >> count >> y;
    const std::int64_t period = kNanosecond / hertz;
    std::int64_t next = now();
    for (std::int64_t i = 0; i < count; ++i) {
      sleepUntil(next);
      const std::int64_t time = now();
      const auto microseconds = static_cast<std::uint64_t>(time / 1000);
      device_->send(vendor_ ? vendorReport(microseconds, i, y)
                            : gazeReport(variant_, microseconds, kStep * i, y));
      next = time - next > kLatePeriods * period ? time + period : next + period;
    }
    return "ok";
  }

  std::string blink(std::istream& words) {
    int count = 0;
    words >> count;
    for (int i = 0; i < count; ++i) {
      const auto time = static_cast<std::uint64_t>(now() / 1000);
      device_->send(gazeReport(variant_, time, kInt32Max, kInt32Max));
    }
    return "ok";
  }

  std::string garbage(std::istream& words) {
    int count = 0;
    words >> count;
    auto shorter = gazeReport(variant_, 0, 0, 0);
    shorter.resize(shorter.size() / 2);
    auto longer = gazeReport(variant_, 0, 0, 0);
    longer.push_back(0xAA);
    for (int i = 0; i < count; ++i) {
      device_->send(shorter);
      device_->send(longer);
      device_->send({0x77, 1, 2, 3});  // a report that the descriptor does not have
      device_->send({});
    }
    return "ok";
  }

  std::string status(std::istream& words) {
    int status = 0;
    int hertz = 0;
    words >> status >> hertz;
    device_->send(
        statusReport(static_cast<std::uint8_t>(status), static_cast<std::uint16_t>(hertz)));
    return "ok";
  }

  std::string display(std::istream& words) {
    std::uint64_t width = 0;
    std::uint64_t height = 0;
    words >> width >> height;
    device_->configure(configurationReport(width, height));
    return "ok";
  }

  std::string destroy() {
    device_->stopServing();
    const std::int64_t time = now();
    device_.reset();
    return "ok " + std::to_string(static_cast<double>(time) / kNanosecond);
  }

  /// Report 5 of the example profile: 64 bits of microseconds, then quarter pixels.
  static std::vector<std::uint8_t> vendorReport(std::uint64_t time, std::int64_t i,
                                                std::int64_t y) {
    std::vector<std::uint8_t> bytes{5};
    append(bytes, time, 8);
    append(bytes, static_cast<std::uint64_t>(i), 2);
    append(bytes, static_cast<std::uint64_t>(y), 2);
    bytes.resize(20);
    return bytes;
  }

  static std::vector<std::uint8_t> vendorDescriptor() {
    DescriptorBuilder d;
    d.usagePage(0xFF00).usage(1).collection(1).logical(0, 255);
    d.reportId(5).usage(2).array(8, 19).input(kDataVariable);
    d.reportId(0x14).usage(3).array(8, 1).feature(kDataVariable);
    return d.end().bytes();
  }

  TrackerVariant variant_;
  bool vendor_ = false;
  std::unique_ptr<UhidDevice> device_;
};

}  // namespace

int main() {
  Tracker tracker;
  std::string line;
  while (std::getline(std::cin, line)) {
    try {
      std::cout << tracker.obey(line) << std::endl;
    } catch (const std::exception& error) {
      std::cout << "error " << error.what() << std::endl;
    }
  }
  return 0;
}
