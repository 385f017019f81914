#include "engine/core/progress.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace macula {
namespace {

TEST(ProgressLines, ALineEveryTenSecondsWithWhatIsLeft) {
  double now = 1000.0;
  ProgressLines lines("replay", 60, [&] { return now; });
  std::vector<std::string> said;
  for (int i = 0; i < 60; ++i) {
    now += 0.8;  // 48 s in all
    if (const std::string line = lines.advance(); !line.empty()) said.push_back(line);
  }
  // The first steps after ten seconds each: 10.4, 20.8, 31.2 and 41.6 s.
  EXPECT_EQ(said, (std::vector<std::string>{
                      "replay: 13/60, about 38 s left", "replay: 26/60, about 27 s left",
                      "replay: 39/60, about 17 s left", "replay: 52/60, about 6 s left"}));
}

TEST(ProgressLines, ShortRunsSayNothing) {
  double now = 0.0;
  ProgressLines lines("replay", 3, [&] { return now; });
  for (int i = 0; i < 3; ++i) {
    now += 4.9;  // the last step ends after ten seconds, but leaves nothing
    EXPECT_EQ(lines.advance(), "") << i;
  }
}

TEST(ProgressLines, LongRestsAreInMinutesAndHours) {
  double now = 0.0;
  ProgressLines lines("chart", 100, [&] { return now; });
  now = 61.0;
  EXPECT_EQ(lines.advance(), "chart: 1/100, about 1.7 h left");
  EXPECT_EQ(lines.advance(), "") << "no time has passed";
  now = 150.0;
  EXPECT_EQ(lines.advance(), "chart: 3/100, about 81 min left");
}

}  // namespace
}  // namespace macula
