// What --gaze says of trackers, and a tracker that is not there.
#include "engine/gaze/hid/hid_gaze.h"

#include <gtest/gtest.h>

#include "engine/core/error.h"

namespace macula::gaze::hid {
namespace {

TEST(HidGaze, KnowsItsSpecs) {
  for (const char* spec : {"hid", "hid:", "hid:1234:abcd", "hid:1234:abcd:X", "hid:SERIAL"}) {
    EXPECT_TRUE(isTrackerSpec(spec)) << spec;
  }
  for (const char* spec : {"hidden.csv", "center", "0.5,0.5", "", "my/hid"}) {
    EXPECT_FALSE(isTrackerSpec(spec)) << spec;
  }
}

TEST(HidGaze, ATrackerThatIsNotThereIsWaitedForAtTheCentre) {
  if (!hidSupported()) GTEST_SKIP() << "this build reads no HID devices (MACULA_HID=OFF)";
  const auto gaze = openTracker("hid:fffe:fffe:no-such-serial", {});
  const PointOfInterest point = gaze->at(0.0);
  EXPECT_EQ(point.state, GazeState::None);
  EXPECT_EQ(point.position, glm::vec2(0.5F));
  const SourceStatus status = gaze->status();
  EXPECT_TRUE(status.live);
  EXPECT_FALSE(status.connected);
  EXPECT_FALSE(status.message.empty());
}

TEST(HidGaze, AProfileThatIsNotThereIsAnError) {
  if (!hidSupported()) GTEST_SKIP() << "this build reads no HID devices (MACULA_HID=OFF)";
  EXPECT_THROW(static_cast<void>(openTracker("hid:/no/such.toml", {})), InputError);
}

}  // namespace
}  // namespace macula::gaze::hid
