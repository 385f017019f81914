#include "engine/gaze/hid/exchange.h"

#include <thread>
#include <utility>

#include "engine/gaze/hid/report.h"

namespace macula::gaze::hid {

std::shared_ptr<Exchange> Exchange::start(std::shared_ptr<const HidrawLink> link,
                                          const TrackerLayout& layout) {
  auto exchange = std::make_shared<Exchange>(std::move(link), layout);
  std::thread([exchange] { exchange->run(); }).detach();
  return exchange;
}

Exchange::Exchange(std::shared_ptr<const HidrawLink> link, TrackerLayout layout)
    : link_(std::move(link)), layout_(std::move(layout)) {}

void Exchange::run() {
  // The size first: a device that never answers the mode request may still have told it, and one
  // that does answer streams only afterwards, so that no sample comes too early for the size.
  if (!isAbandoned()) askScreen();
  if (!isAbandoned()) askToStream();
  const std::scoped_lock lock(mutex_);
  outcome_.done = true;
}

void Exchange::askScreen() {
  const auto& width = layout_.screenWidth;
  const auto& height = layout_.screenHeight;
  if (!width || !height || width->kind != ReportKind::Feature ||
      height->kind != ReportKind::Feature || width->reportId != height->reportId) {
    return;
  }
  const auto size = screenSize(layout_, link_->getFeature(width->reportId, width->bytes));
  if (!size) {
    addProblem("it does not tell the size of its calibrated display");
    return;
  }
  const std::scoped_lock lock(mutex_);
  outcome_.screenMm = size;
}

void Exchange::askToStream() {
  std::vector<std::uint8_t> report = layout_.startReport;
  if (const auto& mode = layout_.modeRequest; report.empty() && mode) {
    report.resize(mode->bytes);
    writeRaw(mode->value, layout_.mode, report);
    if (layout_.numbered) {
      report.front() = mode->reportId;
    } else {
      report.insert(report.begin(), 0);  // the id byte that the request wants all the same
    }
  }
  if (report.empty()) return;
  if (!link_->setFeature(report)) addProblem("it does not answer the request to stream gaze");
}

void Exchange::addProblem(const std::string& problem) {
  const std::scoped_lock lock(mutex_);
  outcome_.problem += (outcome_.problem.empty() ? "" : "; ") + problem;
}

Exchange::Outcome Exchange::outcome() const {
  const std::scoped_lock lock(mutex_);
  return outcome_;
}

void Exchange::abandon() {
  const std::scoped_lock lock(mutex_);
  abandoned_ = true;
}

bool Exchange::isAbandoned() const {
  const std::scoped_lock lock(mutex_);
  return abandoned_;
}

}  // namespace macula::gaze::hid
