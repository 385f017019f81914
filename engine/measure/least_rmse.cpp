// leastRmse() of oracle.h: hulls, the walk along them, and what is left over.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <queue>
#include <utility>

#include "engine/measure/oracle.h"

namespace macula::measure {
namespace {

/// From a pixel's present number of slots to k.
struct Step {
  double gain;  ///< squared error it saves, per slot
  std::uint32_t pixel;
  std::uint32_t k;
};

/// Larger gains first; ties by pixel and then by k, so that a pixel's steps stay in order.
bool comesBefore(const Step& a, const Step& b) {
  if (a.gain != b.gain) return a.gain > b.gain;
  return std::pair(a.pixel, a.k) < std::pair(b.pixel, b.k);
}

double gainPerSlot(std::span<const double> errors, std::uint32_t from, std::uint32_t to) {
  return (errors[from] - errors[to]) / static_cast<double>(to - from);
}

/// Appends the steps along the lower convex hull of errors[first..]. Comparing the very gains that
/// are sorted later keeps a pixel's steps in order in spite of rounding; points on a straight line
/// stay apart, because shorter steps fit more often.
void appendHull(std::span<const double> errors, std::uint32_t first, std::uint32_t pixel,
                std::vector<Step>& steps) {
  const std::size_t begin = steps.size();
  for (std::uint32_t k = first + 1; k < errors.size(); ++k) {
    std::uint32_t from = steps.size() > begin ? steps.back().k : first;
    double gain = gainPerSlot(errors, from, k);
    while (steps.size() > begin && steps.back().gain < gain) {
      steps.pop_back();
      from = steps.size() > begin ? steps.back().k : first;
      gain = gainPerSlot(errors, from, k);
    }
    steps.push_back({gain, pixel, k});
  }
}

/// Hands slots out until none fits.
class Spender {
 public:
  Spender(const FragmentImage& image, std::uint64_t budget, Tail tail,
          const DisplayTransform& display)
      : image_(image),
        curve_(image, tail, display),
        k_(image.pixels(), 0),
        stopped_(image.pixels(), false),
        left_(budget) {
    const std::uint64_t covered = image.coveredPixels();
    const std::uint32_t first = budget >= covered ? 1 : 0;
    left_ -= first * covered;
    for (std::size_t pixel = 0; pixel < image.pixels(); ++pixel) {
      if (image.depth(pixel) == 0) continue;
      const std::span<const double> errors = curve_.of(pixel);
      k_[pixel] = first;
      squares_ += errors[first];
      appendHull(errors, first, static_cast<std::uint32_t>(pixel), steps_);
    }
  }

  /// Along the hulls. @returns the squared error that no choice of as many slots can undercut
  double takeSteps() {
    std::sort(steps_.begin(), steps_.end(), comesBefore);
    std::optional<double> bound;
    for (const Step& step : steps_) {
      if (left_ == 0) break;
      if (stopped_[step.pixel]) continue;
      const std::uint32_t length = step.k - k_[step.pixel];
      if (length <= left_) {
        take(step);
        continue;
      }
      // A part of this step would reach the hull's chord, and nothing goes below the hulls.
      if (!bound) bound = squares_ - step.gain * static_cast<double>(left_);
      stopped_[step.pixel] = true;
    }
    steps_ = {};
    return std::max(0.0, bound.value_or(squares_));
  }

  /// Inside the hulls of pixels whose next step did not fit: there alone layers are left over.
  void takeParts() {
    const auto later = [](const Step& a, const Step& b) { return comesBefore(b, a); };
    std::priority_queue<Step, std::vector<Step>, decltype(later)> heap(later);
    const auto offer = [&](std::size_t pixel) {
      if (const auto part = bestPart(pixel)) heap.push(*part);
    };
    for (std::size_t pixel = 0; pixel < stopped_.size() && left_ > 0; ++pixel) {
      if (stopped_[pixel]) offer(pixel);
    }
    while (left_ > 0 && !heap.empty()) {
      const Step part = heap.top();
      heap.pop();
      if (part.k - k_[part.pixel] <= left_) take(part);
      offer(part.pixel);
    }
  }

  std::vector<std::uint32_t> result() && { return std::move(k_); }

 private:
  void take(const Step& step) {
    const std::uint32_t length = step.k - k_[step.pixel];
    squares_ -= step.gain * static_cast<double>(length);
    left_ -= length;
    k_[step.pixel] = step.k;
  }

  /// The step of most gain per slot that fits and does no harm.
  std::optional<Step> bestPart(std::size_t pixel) {
    const std::span<const double> errors = curve_.of(pixel);
    const std::uint32_t from = k_[pixel];
    const auto last = static_cast<std::uint32_t>(
        std::min<std::uint64_t>(errors.size() - 1, std::uint64_t{from} + left_));
    std::optional<Step> best;
    for (std::uint32_t k = from + 1; k <= last; ++k) {
      const double gain = gainPerSlot(errors, from, k);
      if (gain >= 0.0 && (!best || gain > best->gain)) {
        best = Step{gain, static_cast<std::uint32_t>(pixel), k};
      }
    }
    return best;
  }

  const FragmentImage& image_;
  ErrorCurve curve_;
  std::vector<std::uint32_t> k_;
  std::vector<bool> stopped_;  ///< a step of this pixel did not fit
  std::uint64_t left_;
  std::vector<Step> steps_;
  double squares_ = 0.0;  ///< squared error of the image so far
};

}  // namespace

LeastRmseChoice leastRmse(const FragmentImage& image, std::uint64_t budget, Tail tail,
                          const DisplayTransform& display) {
  requireConsistent(image);
  Spender spender(image, budget, tail, display);
  const double bound = spender.takeSteps();
  spender.takeParts();
  LeastRmseChoice choice{evaluate(image, std::move(spender).result(), tail, display)};
  choice.bound =
      std::min(choice.rmse, std::sqrt(bound / (3.0 * static_cast<double>(image.pixels()))));
  return choice;
}

}  // namespace macula::measure
