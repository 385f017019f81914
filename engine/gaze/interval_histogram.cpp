#include "engine/gaze/interval_histogram.h"

#include <algorithm>
#include <cmath>

namespace macula::gaze {
namespace {

constexpr double kMicroSecondsPerSecond = 1e6;
constexpr int kFineBits = 18;  // 0.26 s: slower trackers than 4 Hz are none
constexpr std::size_t kFineBins = std::size_t{1} << kFineBits;
constexpr std::size_t kBinsPerOctave = 256;
constexpr std::size_t kOctaves = 45;                                  // up to 2^63 microseconds
constexpr std::size_t kBins = kFineBins + kOctaves * kBinsPerOctave;  // whole pages

}  // namespace

IntervalHistogram::IntervalHistogram() : pages_(kBins / kPage) {}

template <typename Visit>
void IntervalHistogram::forEachBin(Visit visit) const {
  for (const std::unique_ptr<Page>& page : pages_) {
    if (page == nullptr) continue;
    for (const Bin& bin : *page) {
      if (bin.count > 0 && !visit(bin)) return;
    }
  }
}

std::size_t IntervalHistogram::binOf(double seconds) {
  const double micro = seconds * kMicroSecondsPerSecond + 0.5;
  if (micro < static_cast<double>(kFineBins)) return static_cast<std::size_t>(micro);
  int exponent = 0;
  const double mantissa = std::frexp(micro, &exponent);  // 0.5 <= mantissa < 1
  const auto octave = static_cast<std::size_t>(exponent - 1 - kFineBits);
  const auto part = static_cast<std::size_t>((2.0 * mantissa - 1.0) * kBinsPerOctave);
  return std::min(kFineBins + octave * kBinsPerOctave + part, kBins - 1);
}

void IntervalHistogram::add(double seconds) {
  const std::size_t index = binOf(seconds);
  std::unique_ptr<Page>& page = pages_[index / kPage];
  if (page == nullptr) page = std::make_unique<Page>();
  Bin& bin = (*page)[index % kPage];
  ++bin.count;
  bin.sum += seconds;
  ++count_;
}

double IntervalHistogram::median() const {
  std::uint64_t below = 0;
  double median = 0.0;
  forEachBin([&](const Bin& bin) {
    below += bin.count;
    median = bin.sum / static_cast<double>(bin.count);
    return below <= count_ / 2;
  });
  return median;
}

IntervalHistogram::Steps IntervalHistogram::within(double least, double most) const {
  Steps steps;
  forEachBin([&](const Bin& bin) {
    const double step = bin.sum / static_cast<double>(bin.count);
    if (step > most) return false;
    if (step < least) return true;
    steps.count += bin.count;
    steps.seconds += bin.sum;
    return true;
  });
  return steps;
}

double IntervalHistogram::deviation(double limitSeconds) const {
  double weight = 0.0;
  double mean = 0.0;
  double squares = 0.0;  // West 1979: updating mean and variance, weighted
  forEachBin([&](const Bin& bin) {
    const auto count = static_cast<double>(bin.count);
    const double step = bin.sum / count;
    if (step > limitSeconds) return false;
    weight += count;
    const double difference = step - mean;
    mean += difference * count / weight;
    squares += count * difference * (step - mean);
    return true;
  });
  return weight > 0.0 ? std::sqrt(squares / weight) : 0.0;
}

}  // namespace macula::gaze
