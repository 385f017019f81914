// Frames of paths, views and recordings: times, cuts, gaze, and their order.
#include "engine/recording/frame_source.h"

#include <gtest/gtest.h>

#include "tests/unit/recording_builder.h"

namespace macula::recording {
namespace {

scene::CameraKey keyAt(double time, float x, bool cut = false) {
  return {.time = time, .position = {x, 0.0F, 5.0F}, .target = {x, 0.0F, 0.0F}, .cut = cut};
}

/// Notes the times that it was asked for.
class NotingGaze final : public gaze::GazeSource {
 public:
  gaze::PointOfInterest at(double timeSeconds) override {
    times.push_back(timeSeconds);
    return gaze::exactPoint({timeSeconds, 0.5});
  }
  [[nodiscard]] std::string name() const override { return "noting"; }
  std::vector<double> times;
};

TEST(PathFrames, AreAtTheirIndexOverTheRate) {
  const scene::CameraPath path({keyAt(0.0, 0.0F), keyAt(1.0, 1.0F)});
  NotingGaze gaze;
  PathFrames frames(path, gaze, 4.0, 3, {64, 48});
  EXPECT_EQ(frames.count(), 3U);
  EXPECT_EQ(frames.first().camera.position, path.at(0.0).position);
  for (std::uint64_t i = 0; i < 3; ++i) {
    const Frame* frame = frames.next();
    ASSERT_NE(frame, nullptr);
    EXPECT_EQ(frame->index, i);
    EXPECT_EQ(frame->timeSeconds, static_cast<double>(i) / 4.0);
    EXPECT_EQ(frame->camera.position, path.at(frame->timeSeconds).position);
    EXPECT_FLOAT_EQ(frame->gaze.position.x, static_cast<float>(frame->timeSeconds));
    EXPECT_EQ(frame->size, glm::ivec2(64, 48));
    EXPECT_EQ(frame->reset, Reset::None);
    EXPECT_FALSE(frame->cut);
  }
  EXPECT_EQ(frames.next(), nullptr);
  EXPECT_EQ(gaze.times, (std::vector<double>{0.0, 0.0, 0.25, 0.5})) << "never back in time";
}

TEST(PathFrames, ACutBelongsToTheFirstFrameBehindIt) {
  gaze::FixedGaze centre({0.5, 0.5}, "center");
  PathFrames frames(scene::CameraPath({keyAt(0.0, 0.0F), keyAt(0.3, 9.0F, true)}), centre, 4.0, 4,
                    {8, 8});
  std::vector<bool> cuts;
  while (const Frame* frame = frames.next()) cuts.push_back(frame->cut);
  EXPECT_EQ(cuts, (std::vector<bool>{false, false, true, false}));
}

TEST(ListedFrames, AreTheViewsLookedAtInTheirMiddle) {
  scene::Camera view;
  view.position = {1.0F, 2.0F, 3.0F};
  ListedFrames frames({scene::Camera{}, view}, {8, 4});
  EXPECT_EQ(frames.count(), 2U);
  EXPECT_EQ(frames.first().index, 0U);
  (void)frames.next();
  const Frame* second = frames.next();
  ASSERT_NE(second, nullptr);
  EXPECT_EQ(second->index, 1U);
  EXPECT_EQ(second->camera.position, view.position);
  EXPECT_EQ(second->gaze.position, glm::vec2(0.5F));
  EXPECT_EQ(second->gaze.state, gaze::GazeState::Ok);
  EXPECT_EQ(frames.next(), nullptr);
}

TEST(ListedFrames, OfARecordingAreItsOwn) {
  ListedFrames frames(std::vector<Frame>{someFrame(0), someFrame(1)});
  EXPECT_EQ(frames.first().reset, Reset::Restart);
  for (std::uint64_t i = 0; i < 2; ++i) expectSame(*frames.next(), someFrame(i));
  EXPECT_EQ(frames.next(), nullptr);
}

TEST(CameraPathOf, ARecordingsCameraWithItsCuts) {
  Recording recording;
  for (std::uint64_t i = 0; i < 3; ++i) {
    recording.frames.push_back(someFrame(i));
    recording.frames.back().camera.position.x = static_cast<float>(i);
  }
  recording.frames[2].cut = true;
  recording.frames.push_back(recording.frames.back());  // at the same time: left out
  const scene::CameraPath path = cameraPathOf(recording);
  EXPECT_EQ(path.duration(), recording.frames[2].timeSeconds);
  EXPECT_EQ(path.at(recording.frames[1].timeSeconds).position.x, 1.0F);
  EXPECT_TRUE(path.cutAt(recording.frames[1].timeSeconds, recording.frames[2].timeSeconds));
}

}  // namespace
}  // namespace macula::recording
