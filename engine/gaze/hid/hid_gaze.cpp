#include "engine/gaze/hid/hid_gaze.h"

#include <fmt/format.h>

#include <chrono>
#include <optional>
#include <utility>

#include "engine/core/error.h"

namespace macula::gaze::hid {
namespace {

constexpr std::string_view kPrefix = "hid";

/// The thread's samples as the pipeline takes them.
class HidReader final : public DeviceReader {
 public:
  explicit HidReader(TrackerChoice choice) : choice_(choice.text()), tracker_(std::move(choice)) {
    samples_.reserve(kSampleRing);
  }

  void drain(std::vector<DeviceSample>& samples) override {
    samples_.clear();
    tracker_.drain(samples_);
    for (const HidSample& sample : samples_) {
      samples.push_back({sample.hostSeconds, sample.deviceSeconds, sample.position, sample.valid});
    }
  }
  [[nodiscard]] bool connected() const override {
    const Connection connection = tracker_.status().connection;
    return connection == Connection::Opening || connection == Connection::Streaming ||
           connection == Connection::Silent;
  }
  [[nodiscard]] std::string name() const override {
    const std::string name = tracker_.status().name;
    return name.empty() ? fmt::format("eye tracker ({})", choice_) : oneLine(name);
  }
  [[nodiscard]] std::string message() const override {
    const TrackerStatus status = tracker_.status();
    if (!status.message.empty()) return oneLine(status.message);
    return status.connection == Connection::Streaming
               ? std::string()
               : std::string(connectionName(status.connection));
  }

 private:
  std::string choice_;
  EyeTracker tracker_;
  std::vector<HidSample> samples_;
};

double steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The reader with the pipeline on it.
class HidGaze final : public GazeSource {
 public:
  HidGaze(TrackerChoice choice, GazeSettings settings)
      : reader_(std::move(choice)), settings_(std::move(settings)) {}

  [[nodiscard]] PointOfInterest at(double timeSeconds) override {
    if (!gaze_) {
      gaze_.emplace(reader_, settings_, steadySeconds() - timeSeconds);
      gaze_->place(placement_);
      gaze_->onSample(std::move(listener_));
    }
    return gaze_->at(timeSeconds);
  }
  [[nodiscard]] std::string name() const override { return reader_.name(); }
  [[nodiscard]] SourceStatus status() const override {
    if (gaze_) return gaze_->status();
    SourceStatus status;
    status.live = true;
    status.connected = reader_.connected();
    status.message = reader_.message();
    return status;
  }
  void place(const WindowPlacement& placement) override {
    placement_ = placement;
    if (gaze_) gaze_->place(placement);
  }
  void onSample(SampleListener listener) override {
    if (gaze_) return gaze_->onSample(std::move(listener));
    listener_ = std::move(listener);
  }

 private:
  HidReader reader_;
  GazeSettings settings_;
  WindowPlacement placement_;
  SampleListener listener_;
  std::optional<LiveGaze> gaze_;  ///< from the first question on
};

TrackerChoice choiceOf(std::string_view name) {
  if (!name.ends_with(".toml")) return parseTrackerChoice(name);
  TrackerChoice choice;
  choice.profile = readProfile(std::string(name));
  choice.vendorId = choice.profile->vendorId;
  choice.productId = choice.profile->productId;
  return choice;
}

}  // namespace

bool isTrackerSpec(std::string_view spec) {
  return spec == kPrefix ||
         (spec.starts_with(kPrefix) && spec.substr(kPrefix.size()).starts_with(':'));
}

std::unique_ptr<GazeSource> openTracker(const std::string& spec, const GazeSettings& settings) {
  if (!hidSupported()) {
    failInput("--gaze {}: this build reads no HID devices; build with -DMACULA_HID=ON", spec);
  }
  const std::size_t named = kPrefix.size() + 1;
  const std::string name = spec.size() > named ? spec.substr(named) : std::string();
  return std::make_unique<HidGaze>(choiceOf(name), settings);
}

}  // namespace macula::gaze::hid
