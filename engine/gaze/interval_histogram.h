// Median and spread of any number of time steps in bounded memory.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace macula::gaze {

/// Counts steps in bins of a microsecond up to a quarter second, and of 0.4 % beyond. Each bin
/// keeps the mean of its steps, so that a median is exact where the clock counts whole microseconds
/// or longer, and within a microsecond (or 0.4 %) otherwise. At most 4 MB.
class IntervalHistogram {
 public:
  IntervalHistogram();

  /// @param seconds > 0
  void add(double seconds);

  [[nodiscard]] std::uint64_t count() const { return count_; }
  /// The upper median in seconds; 0 where nothing was added.
  [[nodiscard]] double median() const;
  /// How many steps lie between two lengths in seconds, by the means of their bins, and their sum.
  struct Steps {
    std::uint64_t count = 0;
    double seconds = 0.0;
  };
  [[nodiscard]] Steps within(double least, double most) const;
  /// Standard deviation, in seconds, of the steps up to a limit; 0 where there are none.
  [[nodiscard]] double deviation(double limitSeconds) const;

 private:
  struct Bin {
    std::uint64_t count = 0;
    double sum = 0.0;
  };
  /// Most recordings need few bins: a page of them is made when the first of its steps comes.
  static constexpr std::size_t kPage = 256;
  using Page = std::array<Bin, kPage>;

  [[nodiscard]] static std::size_t binOf(double seconds);
  /// Calls `visit(bin)` for each bin that holds something, from short steps to long ones, until it
  /// returns false.
  template <typename Visit>
  void forEachBin(Visit visit) const;

  std::vector<std::unique_ptr<Page>> pages_;
  std::uint64_t count_ = 0;
};

}  // namespace macula::gaze
