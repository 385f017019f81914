// Median and spread of any number of time steps in bounded memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace macula::gaze {

/// Counts steps in bins of a microsecond up to a quarter second, and of 0.4 % beyond. Each bin
/// keeps the mean of its steps, so that a median is exact where the clock counts whole microseconds
/// or longer, and within a microsecond (or 0.4 %) otherwise. 4 MB.
class IntervalHistogram {
 public:
  IntervalHistogram();

  /// @param seconds > 0
  void add(double seconds);

  [[nodiscard]] std::uint64_t count() const { return count_; }
  /// The upper median in seconds; 0 where nothing was added.
  [[nodiscard]] double median() const;
  /// Standard deviation, in seconds, of the steps up to a limit; 0 where there are none.
  [[nodiscard]] double deviation(double limitSeconds) const;

 private:
  struct Bin {
    std::uint64_t count = 0;
    double sum = 0.0;
  };
  [[nodiscard]] static std::size_t binOf(double seconds);

  std::vector<Bin> bins_;
  std::uint64_t count_ = 0;
};

}  // namespace macula::gaze
