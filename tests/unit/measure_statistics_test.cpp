// Median, percentiles, mean and deviation of lists worked by hand.
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <vector>

#include "engine/measure/statistics.h"

namespace macula::measure {
namespace {

using Values = std::vector<double>;

TEST(Statistics, Median) {
  EXPECT_EQ(median(Values{3.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(median(Values{4.0, 1.0, 2.0, 3.0}), 2.5);
  EXPECT_EQ(median(Values{7.0}), 7.0);
}

TEST(Statistics, PercentileInterpolates) {
  // Position 0.95 * 4 = 3.8 between 4 and 10.
  EXPECT_DOUBLE_EQ(p95(Values{10.0, 1.0, 2.0, 3.0, 4.0}).value(), 4.0 + 0.8 * 6.0);
  EXPECT_EQ(percentile(Values{2.0, 1.0}, 0.0), 1.0);
  EXPECT_EQ(percentile(Values{2.0, 1.0}, 1.0), 2.0);
  EXPECT_EQ(percentile(Values{2.0, 1.0}, 0.25), 1.25);
}

TEST(Statistics, MeanAndDeviation) {
  const Values values = {2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0};
  EXPECT_EQ(mean(values), 5.0);
  EXPECT_EQ(standardDeviation(values), 2.0);
}

TEST(Statistics, NothingOfNothing) {
  EXPECT_FALSE(median(Values{}));
  EXPECT_FALSE(p95(Values{}));
  EXPECT_FALSE(mean(Values{}));
  EXPECT_FALSE(standardDeviation(Values{}));
}

TEST(Statistics, FractionOutsideIsAMistake) {
  EXPECT_THROW((void)percentile(Values{1.0}, 95.0), std::invalid_argument);
  EXPECT_THROW((void)percentile(Values{1.0}, -0.1), std::invalid_argument);
  EXPECT_THROW((void)percentile(Values{1.0}, std::numeric_limits<double>::quiet_NaN()),
               std::invalid_argument);
}

}  // namespace
}  // namespace macula::measure
