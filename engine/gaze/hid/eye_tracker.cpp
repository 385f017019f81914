#include "engine/gaze/hid/eye_tracker.h"

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/gaze/hid/device.h"
#include "engine/gaze/hid/exchange.h"
#include "engine/gaze/hid/link.h"
#include "engine/gaze/hid/session.h"
#include "engine/gaze/hid/spsc_ring.h"

namespace macula::gaze::hid {
namespace {

/// How often devices are listed while none is open: below what a person notices after a replug, and
/// a listing takes a millisecond or two.
constexpr std::chrono::milliseconds kSearchPeriod{100};
/// How long one wait for a report lasts: only the end of the program and silence are noticed so
/// late; a report or an unplug ends the wait.
constexpr int kReadTimeoutMs = 20;

constexpr const char* kRuleFile = "70-macula-eye-tracker.rules";

double hostSeconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

std::string denialMessage(const std::string& path) {
  std::string rule;
  try {
    rule = (dataFolder("assets") / "udev" / kRuleFile).string();
  } catch (const InputError&) {
    rule = std::string("share/macula/assets/udev/") + kRuleFile;
  }
  return fmt::format(
      "no permission to open {}: install the udev rule and plug the tracker in again: sudo cp {} "
      "/etc/udev/rules.d/ && sudo udevadm control --reload",
      path, rule);
}

}  // namespace

/// The reading thread and what it shares with its owner: the ring, the counters, and the status
/// behind a lock that is taken when something changes, not for each sample.
class EyeTracker::Thread {
 public:
  explicit Thread(TrackerChoice choice)
      : choice_(std::move(choice)), buffer_(kMaxReportBytes), thread_([this] { run(); }) {}

  ~Thread() {
    {
      const std::scoped_lock lock(stopMutex_);
      stop_ = true;
    }
    stopped_.notify_all();
    thread_.join();
  }

  std::size_t drain(std::vector<HidSample>& out) {
    return ring_.drain([&out](const HidSample& sample) { out.push_back(sample); });
  }

  TrackerStatus status() const {
    const std::scoped_lock lock(statusMutex_);
    TrackerStatus status = status_;
    status.received = received_.load(std::memory_order_relaxed);
    status.dropped = dropped_.load(std::memory_order_relaxed);
    status.garbage = garbage_.load(std::memory_order_relaxed);
    return status;
  }

 private:
  void run() {
    setMessage(Connection::Searching, fmt::format("no eye tracker ({})", choice_.text()));
    while (!stop_) {
      const std::vector<TrackerInfo> found = findDevices(choice_);
      if (const TrackerInfo* best = choose(found)) {
        attempt(*best);
      } else if (connection_ != Connection::Unplugged) {
        setMessage(Connection::Searching, fmt::format("no eye tracker ({})", choice_.text()));
      }
      std::unique_lock lock(stopMutex_);
      stopped_.wait_for(lock, kSearchPeriod, [this] { return stop_.load(); });
    }
  }

  /// The first that this user may open, else the first, so that the refusal is told.
  [[nodiscard]] const TrackerInfo* choose(const std::vector<TrackerInfo>& found) const {
    const TrackerInfo* first = nullptr;
    for (const TrackerInfo& info : found) {
      if (choice_.profile && !sendsGazeReport(info)) continue;
      if (info.accessible) return &info;
      if (first == nullptr) first = &info;
    }
    return first;
  }

  /// A vendor's device may have several interfaces; the profile's report comes from one of them.
  [[nodiscard]] bool sendsGazeReport(const TrackerInfo& info) const {
    const GazeReportLayout& gaze = choice_.profile->layout.gaze;
    try {
      const Descriptor descriptor = parseDescriptor(readReportDescriptor(info.path), info.path);
      return descriptor.reportBytes(ReportKind::Input, gaze.reportId) > 0;
    } catch (const InputError&) {
      return true;  // a profile may be there because the descriptor is no good
    }
  }

  /// Opens a device and reads it until it goes; where it cannot be read, says why.
  void attempt(const TrackerInfo& info) {
    try {
      TrackerLayout layout;
      if (choice_.profile) {
        layout = choice_.profile->layout;
      } else {
        const std::vector<std::uint8_t> descriptor = readReportDescriptor(info.path);
        if (descriptor.empty()) return;  // it has just gone
        layout = layoutOf(parseDescriptor(descriptor, info.path), info.path);
      }
      const auto link = std::make_shared<const HidrawLink>(info.path);
      if (!link->isOpen()) {
        refuseOpen(info, link->error());
        return;
      }
      identify(info);
      Session session(std::move(layout), choice_);
      setMessage(Connection::Opening, session.note(""));
      stream(session, link);
    } catch (const std::exception& error) {  // nothing may end the thread, and with it the program
      identify(info);
      setMessage(Connection::Refused, error.what());
    }
  }

  void refuseOpen(const TrackerInfo& info, int error) {
    if (error == ENOENT || error == ENODEV || error == ENXIO) return;  // it has just gone
    identify(info);
    if (error == EACCES || error == EPERM) {
      setMessage(Connection::Denied, denialMessage(info.path));
    } else {
      setMessage(Connection::Refused,
                 fmt::format("{} cannot be opened: {}", info.path, std::strerror(error)));
    }
  }

  /// The questions to the device that are under way, and what of the answers is known here.
  struct Talk {
    explicit Talk(std::shared_ptr<Exchange> started) : exchange(std::move(started)) {}
    Talk(const Talk&) = delete;
    Talk& operator=(const Talk&) = delete;
    ~Talk() { exchange->abandon(); }

    std::shared_ptr<Exchange> exchange;
    bool done = false;
    Exchange::Outcome known;
  };

  void follow(Session& session, Talk& talk) {
    if (talk.done) return;
    const Exchange::Outcome outcome = talk.exchange->outcome();
    talk.done = outcome.done;
    if (outcome.screenMm == talk.known.screenMm && outcome.problem == talk.known.problem) return;
    session.learn(outcome.screenMm, outcome.problem);
    show(session);
    talk.known = outcome;
  }

  void stream(Session& session, const std::shared_ptr<const HidrawLink>& link) {
    auto talk = std::make_unique<Talk>(Exchange::start(link, session.layout()));
    show(session);
    double lastGaze = hostSeconds();
    while (!stop_) {
      std::size_t length = 0;
      const HidrawLink::Read read = link->read(buffer_, length, kReadTimeoutMs);
      const double now = hostSeconds();
      follow(session, *talk);  // before the report: the first one may come with the answers
      if (talk->done && session.takeCalibrated()) {
        talk = std::make_unique<Talk>(Exchange::start(link, session.layout()));
      }
      if (read == HidrawLink::Read::Gone) {
        setMessage(Connection::Unplugged, "unplugged; it is looked for");
        return;
      }
      if (read == HidrawLink::Read::Report &&
          take(session, std::span(buffer_).first(length), now)) {
        lastGaze = now;
      } else if (connection_ == Connection::Streaming && now - lastGaze > kSilentSeconds) {
        connection_ = Connection::Silent;
        show(session);
      }
    }
  }

  /// @return true where the report is one of gaze
  bool take(Session& session, std::span<const std::uint8_t> bytes, double now) {
    const Session::Taken taken = session.take(bytes, now);
    if (taken.kind == ReportClass::Garbage) garbage_.fetch_add(1, std::memory_order_relaxed);
    const bool isGaze = taken.kind == ReportClass::Gaze;
    if (isGaze) {
      received_.fetch_add(1, std::memory_order_relaxed);
      if (!ring_.push(taken.sample)) dropped_.fetch_add(1, std::memory_order_relaxed);
    }
    const bool returns = isGaze && connection_ != Connection::Streaming;
    if (returns) connection_ = Connection::Streaming;
    if (returns || taken.news) show(session);
    return isGaze;
  }

  /// Brings the status up to what the session and connection_ say.
  void show(const Session& session) {
    {
      const std::scoped_lock lock(statusMutex_);
      status_.calibratedMm = session.screenMm();
      status_.reportedHz = session.samplingHz();
    }
    const bool silent = connection_ == Connection::Silent;
    const bool opening = connection_ == Connection::Opening;
    setMessage(connection_, session.note(silent    ? "no reports: a blink, or nobody in front of it"
                                         : opening ? "waits for the first report"
                                                   : ""));
  }

  void identify(const TrackerInfo& info) {
    const std::scoped_lock lock(statusMutex_);
    status_.name = info.name.empty() && choice_.profile ? choice_.profile->name : info.name;
    status_.path = info.path;
    status_.vendorId = info.vendorId;
    status_.productId = info.productId;
    status_.serial = info.serial;
  }

  void setMessage(Connection connection, std::string message) {
    const std::scoped_lock lock(statusMutex_);
    if (connection != status_.connection || status_.sinceSeconds == 0.0) {
      status_.sinceSeconds = hostSeconds();
    }
    connection_ = status_.connection = connection;
    status_.message = oneLine(message);
  }

  const TrackerChoice choice_;
  SpscRing<HidSample, kSampleRing> ring_;
  std::atomic<std::uint64_t> received_{0};
  std::atomic<std::uint64_t> dropped_{0};
  std::atomic<std::uint64_t> garbage_{0};
  mutable std::mutex statusMutex_;
  TrackerStatus status_;
  Connection connection_ = Connection::Searching;  ///< the reading thread's own copy
  std::vector<std::uint8_t> buffer_;
  std::mutex stopMutex_;
  std::condition_variable stopped_;
  std::atomic<bool> stop_{false};
  std::thread thread_;  ///< last: it begins when all else is there
};

EyeTracker::EyeTracker(TrackerChoice choice)
    : thread_(std::make_unique<Thread>(std::move(choice))) {}

EyeTracker::~EyeTracker() = default;

std::size_t EyeTracker::drain(std::vector<HidSample>& out) {
  return thread_->drain(out);
}

TrackerStatus EyeTracker::status() const {
  return thread_->status();
}

std::vector<TrackerInfo> listTrackers() {
  return findDevices(TrackerChoice{});
}

bool hidSupported() {
  return true;
}

}  // namespace macula::gaze::hid
