// The verdict on a timer, without a GPU.
#include "engine/gl/time_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace macula::gl {
namespace {

TimeSourceCheck judged(std::array<double, 3> query, std::array<double, 3> finish) {
  TimeSourceCheck check;
  check.queryMs = query;
  check.finishMs = finish;
  judge(check);
  return check;
}

TEST(TimeSource, TimersThatAgreeAreUsed) {
  EXPECT_EQ(judged({4.0, 8.1, 16.0}, {4.2, 8.3, 16.2}).source, TimeSource::Query);
  EXPECT_EQ(judged({4.0, 8.0, 16.0}, {4.9, 9.9, 19.9}).source, TimeSource::Query) << "within 20 %";
}

TEST(TimeSource, TimersThatLieAreNot) {
  const TimeSourceCheck deferred = judged({0.04, 0.05, 0.06}, {4.2, 8.3, 16.2});
  EXPECT_EQ(deferred.source, TimeSource::Finish);
  EXPECT_THAT(deferred.reason, testing::HasSubstr("0.04 ms where the steady clock says 4.20 ms"));
  EXPECT_EQ(judged({4.0, 8.0, 8.0}, {4.0, 8.0, 16.0}).source, TimeSource::Finish)
      << "one wrong time of three is enough";
  EXPECT_EQ(judged({4.0, 8.0, 16.0}, {0.0, 0.0, 0.0}).source, TimeSource::Finish)
      << "no division by a clock that stands";
}

}  // namespace
}  // namespace macula::gl
