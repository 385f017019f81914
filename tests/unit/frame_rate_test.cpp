// Frames a second from clock values, and a method's median time.
#include "engine/ui/frame_rate.h"

#include <gtest/gtest.h>

namespace macula::ui {
namespace {

TEST(FrameRate, IsNotKnownBeforeTheSecondPresent) {
  FrameRate rate;
  EXPECT_FALSE(rate.perSecond());
  rate.presented(5.0);
  EXPECT_FALSE(rate.perSecond());
  rate.presented(5.0);  // no time has passed
  EXPECT_FALSE(rate.perSecond());
}

TEST(FrameRate, CountsFromPresentToPresent) {
  FrameRate rate;
  for (int i = 0; i < 200; ++i) rate.presented(i * 0.025);
  EXPECT_NEAR(*rate.perSecond(), 40.0, 1e-9);
}

TEST(FrameRate, IsTheMeanOfUnevenFrames) {
  FrameRate rate;  // 10 ms and 30 ms in turn: 2 frames in 40 ms
  double now = 0.0;
  for (int i = 0; i < 400; ++i) rate.presented(now += i % 2 == 0 ? 0.01 : 0.03);
  EXPECT_NEAR(*rate.perSecond(), 50.0, 1.0);
}

TEST(FrameRate, OfFramesLongerThanTheSpanIsThatOfTheLast) {
  FrameRate rate;
  for (int i = 0; i < 100; ++i) rate.presented(i * 0.01);
  rate.presented(0.99 + 4.0);
  EXPECT_NEAR(*rate.perSecond(), 0.25, 1e-9);
}

TEST(FrameRate, ForgetsAPause) {
  FrameRate rate;
  rate.presented(0.0);
  rate.presented(0.1);
  rate.restart();
  rate.presented(60.0);
  EXPECT_FALSE(rate.perSecond());
  rate.presented(60.1);
  EXPECT_NEAR(*rate.perSecond(), 10.0, 1e-6);
}

TEST(MethodTime, IsTheMedianOfOneMethodsFrames) {
  MethodTime time;
  EXPECT_EQ(time.medianMs(), 0.0);
  for (const double ms : {5.0, 100.0, 4.0}) time.add("blend", ms);
  EXPECT_EQ(time.medianMs(), 5.0);
  time.add("wboit", 30.0);
  EXPECT_EQ(time.medianMs(), 30.0) << "what another method took does not count";
  EXPECT_EQ(time.method(), "wboit");
}

}  // namespace
}  // namespace macula::ui
