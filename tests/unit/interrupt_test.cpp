#include "engine/core/interrupt.h"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>

#include "engine/core/file.h"
#include "engine/core/page.h"
#include "engine/gaze/canonical_csv.h"
#include "temporary_path.h"

namespace macula {
namespace {

namespace fs = std::filesystem;

TEST(Interrupt, FirstSignalIsNotedUntilTheGuardEnds) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const InterruptGuard guard;
    EXPECT_FALSE(interruptAsked());
    EXPECT_NO_THROW(endIfInterrupted());
    ::raise(signal);
    EXPECT_TRUE(interruptAsked());
    EXPECT_THROW(endIfInterrupted(), Interrupted);
  }
  EXPECT_FALSE(interruptAsked());
}

TEST(InterruptDeathTest, SecondSignalEndsAtOnce) {
  const auto twice = [](int first, int second) {
    const InterruptGuard guard;
    ::raise(first);
    ::raise(second);
  };
  EXPECT_EXIT(twice(SIGINT, SIGINT), testing::KilledBySignal(SIGINT), "");
  EXPECT_EXIT(twice(SIGINT, SIGTERM), testing::KilledBySignal(SIGTERM), "");
}

TEST(Interrupt, ConversionLeavesTheOldFileAndNoOther) {
  const fs::path folder = test::temporaryPath("interrupt");
  fs::create_directories(folder);
  writeFileAtomically(folder / "log.csv", "time_s,x,y,valid\n0,0.5,0.5,1\n");
  writeFileAtomically(folder / "out.csv", "old");
  {
    const InterruptGuard guard;
    ::raise(SIGINT);
    EXPECT_THROW(gaze::convertGazeLog(folder / "log.csv", folder / "out.csv", {}), Interrupted);
  }
  EXPECT_EQ(readTextFile(folder / "out.csv"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 2);
  fs::remove_all(folder);
}

TEST(Interrupt, BannerSaysHowFar) {
  EXPECT_EQ(interruptedBanner(""), "");
  EXPECT_NE(interruptedBanner("1 < 2 frames were drawn").find("1 &lt; 2 frames were drawn."),
            std::string::npos);
}

}  // namespace
}  // namespace macula
