// The ring between two threads, the choice of a tracker, and a tracker that is not there.
#include "engine/gaze/hid/eye_tracker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "engine/gaze/hid/spsc_ring.h"

namespace macula::gaze::hid {
namespace {

TEST(HidRing, KeepsOrderAndSaysWhenItIsFull) {
  SpscRing<int, 4> ring;
  std::vector<int> out;
  const auto take = [&out](int element) { out.push_back(element); };
  EXPECT_EQ(ring.drain(take), 0U);
  for (int round = 0; round < 3; ++round) {  // around its end
    for (int i = 0; i < 4; ++i) EXPECT_TRUE(ring.push(i));
    EXPECT_FALSE(ring.push(4));
    out.clear();
    EXPECT_EQ(ring.drain(take), 4U);
    EXPECT_THAT(out, ::testing::ElementsAre(0, 1, 2, 3));
    EXPECT_TRUE(ring.push(9));
    EXPECT_EQ(ring.drain(take), 1U);
  }
}

// What was not refused arrives, in order and once, however the threads run.
TEST(HidRing, LosesNothingBetweenTwoThreads) {
  constexpr int kCount = 200'000;
  SpscRing<int, 64> ring;
  int refused = 0;
  std::atomic<bool> done{false};
  std::thread writer([&] {
    for (int i = 0; i < kCount; ++i) {
      while (!ring.push(i)) {
        ++refused;
        std::this_thread::yield();
      }
    }
    done = true;
  });
  int next = 0;
  bool inOrder = true;
  bool last = false;
  while (!last) {
    last = done;
    const std::size_t got =
        ring.drain([&](int element) { inOrder = inOrder && element == next++; });
    if (got == 0) std::this_thread::yield();
  }
  writer.join();
  EXPECT_TRUE(inOrder);
  EXPECT_EQ(next, kCount);
}

TEST(HidChoice, IsByIdsSerialOrFirst) {
  const TrackerInfo info{.name = "T",
                         .path = "/dev/hidraw0",
                         .vendorId = 0x2104,
                         .productId = 0x0127,
                         .serial = "IS4-1",
                         .accessible = true};
  for (const char* text : {"", "first", "2104:0127", "2104:0127:IS4-1", "IS4-1"}) {
    EXPECT_TRUE(parseTrackerChoice(text).matches(info)) << text;
  }
  for (const char* text : {"2104:0128", "2104:0127:IS4", "IS4", "2104", "2104:127"}) {
    EXPECT_FALSE(parseTrackerChoice(text).matches(info)) << text;
  }
  EXPECT_EQ(parseTrackerChoice("2104:0127:IS4-1").text(), "2104:0127 serial IS4-1");
  EXPECT_EQ(parseTrackerChoice("first").text(), "any");
  // A serial number may look like two ids that are none.
  EXPECT_EQ(parseTrackerChoice("21g4:0127").serial, "21g4:0127");
}

TEST(HidEyeTracker, OneThatIsNotThereIsSearchedFor) {
  EyeTracker tracker(parseTrackerChoice("ffff:ffff:no such tracker"));
  std::vector<HidSample> samples;
  EXPECT_EQ(tracker.drain(samples), 0U);
  const TrackerStatus status = tracker.status();
  EXPECT_EQ(connectionName(status.connection), hidSupported() ? "searching" : "refused");
  EXPECT_EQ(status.received, 0U);
}

}  // namespace
}  // namespace macula::gaze::hid
