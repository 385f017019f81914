#include "walk/gaze_control.h"

#include <algorithm>
#include <utility>

#include "engine/core/error.h"

namespace macula::tools {
namespace {

/// Devices are looked for this often while their list is of use.
constexpr auto kListEvery = std::chrono::seconds(1);

}  // namespace

void GazeControl::choose(const std::string& spec) {
  if (spec == "mouse") {
    source_.reset();
    recording_.reset();
    begin_.reset();
    delay_ = {};
    spec_ = spec;
    queued_.reset();
    opening_.clear();
    return;
  }
  opening_ = spec;
  queued_ = spec;
}

void GazeControl::chooseNext() {
  listChoices();
  const auto present = std::find_if(choices_.begin(), choices_.end(),
                                    [&](const GazeChoice& choice) { return choice.spec == spec_; });
  const bool last = present == choices_.end() || present + 1 == choices_.end();
  choose(last ? choices_.front().spec : (present + 1)->spec);
}

void GazeControl::poll() {
  if (job_.ready()) {
    const bool wanted = !queued_ && !opening_.empty();
    if (!queued_) opening_.clear();
    Opened opened;
    try {
      opened = job_.take();
    } catch (const InputError&) {
      if (wanted) throw;  // an error of a source that is no longer wanted is not shown
    }
    if (wanted) {
      delay_ = {};
      source_ = std::move(opened.source);
      recording_ = std::move(opened.recording);
      untold_ = recording_ ? recording_->warnings : std::vector<std::string>{};
      spec_ = opened.spec;
      begin_.reset();
      listen();
      if (recording_ && std::find(logs_.begin(), logs_.end(), spec_) == logs_.end()) {
        logs_.push_back(spec_);
        listChoices();
      }
    }
  }
  if (queued_ && !job_.busy()) {
    // A copy: the panels may change the settings while the thread reads.
    job_.start([open = sources_.open, spec = *queued_, settings = settings_] {
      Opened opened{spec, open(spec, settings), {}};
      if (const auto* log = dynamic_cast<const gaze::ReplayGaze*>(opened.source.get())) {
        opened.recording =
            Recording{gaze::assess(log->log()), log->log().format, log->viewing().warnings};
      }
      return opened;
    });
    queued_.reset();
  }
  if (deviceJob_.ready()) {
    devices_ = deviceJob_.take();
    listChoices();
  }
  if (!deviceJob_.busy() && Clock::now() - listed_ > kListEvery) {
    listed_ = Clock::now();
    deviceJob_.start(sources_.devices);
  }
}

void GazeControl::listChoices() {
  choices_ = {{"mouse", "the pointer in place of the eye"},
              {"center", "the middle of the picture"}};
  choices_.insert(choices_.end(), devices_.begin(), devices_.end());
  for (const std::string& log : logs_) choices_.push_back({log, "recording"});
}

void GazeControl::reopen() {
  if (!opening_.empty()) return choose(opening_);
  if (!isMouse()) choose(spec_);
}

void GazeControl::place(const gaze::WindowPlacement& placement) {
  if (source_) source_->place(placement);
}

void GazeControl::onSample(gaze::GazeSource::SampleListener listener) {
  listener_ = std::move(listener);
  listen();
}

void GazeControl::listen() {
  if (!listener_) return;
  mouse_.onSample(listener_);
  if (!source_) return;
  source_->onSample([this](const gaze::GazeSample& sample) {
    gaze::GazeSample shifted = sample;
    shifted.timeSeconds += begin_.value_or(0.0);
    listener_(shifted);
  });
}

gaze::PointOfInterest GazeControl::at(double seconds) {
  if (!begin_) begin_ = seconds;
  sourceSeconds_ = seconds - *begin_;
  gaze::PointOfInterest point = source_ ? source_->at(sourceSeconds_) : mouse_.at(seconds);
  // A log brings its latency with it; what comes now can only be held back.
  if (settings_.latencyMs > 0.0 && (isMouse() || source_->status().live)) {
    point = delay_.next(seconds, point, settings_.latencyMs * 1e-3);
  }
  strip_[next_] = point.state;
  next_ = (next_ + 1) % kStrip;
  return point;
}

gaze::SourceStatus GazeControl::status() const {
  return source_ ? source_->status() : mouse_.status();
}

}  // namespace macula::tools
