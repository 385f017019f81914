// Memory barriers that follow from what passes declare.
#include "engine/frame/barriers.h"

#include <gtest/gtest.h>

#include <vector>

namespace macula::frame {
namespace {

constexpr GLbitfield kUpdates = GL_BUFFER_UPDATE_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT;

GLbitfield before(BarrierTracker& tracker, Resource resource, Use use, Access access) {
  const Touch touch{resource, use, access};
  return tracker.before({&touch, 1});
}

TEST(Barriers, FollowIncoherentWritesOnly) {
  BarrierTracker tracker;
  const std::vector<Touch> target{{Resource::HdrColor, Use::ColorTarget, Access::Write}};
  const std::vector<Touch> sampled{{Resource::HdrColor, Use::Texture, Access::Read}};
  EXPECT_EQ(tracker.before(target), 0U);
  EXPECT_EQ(tracker.before(sampled), 0U) << "the driver orders render targets itself";
  const std::vector<Touch> stored{{Resource::HdrColor, Use::Image, Access::Write}};
  EXPECT_EQ(tracker.before(stored), 0U);
  EXPECT_EQ(tracker.before(sampled), GLbitfield{GL_TEXTURE_FETCH_BARRIER_BIT});
  EXPECT_EQ(tracker.before(sampled), 0U) << "one barrier settles the write";
  EXPECT_EQ(tracker.before(target), GLbitfield{GL_FRAMEBUFFER_BARRIER_BIT});
}

TEST(Barriers, StorageWritesReachTheNextPass) {
  BarrierTracker tracker;
  const std::vector<Touch> counts{{Resource::OitTotals, Use::Storage, Access::Modify}};
  EXPECT_EQ(tracker.before(counts), 0U);
  EXPECT_EQ(tracker.before(counts), GLbitfield{GL_SHADER_STORAGE_BARRIER_BIT});
}

TEST(Barriers, OfOneFrameReachIntoTheNext) {
  BarrierTracker tracker;
  // Written by image store while one frame ends; the next one reads it as history.
  before(tracker, Resource::FrontNormal, Use::Image, Access::Modify);
  EXPECT_EQ(before(tracker, Resource::FrontNormal, Use::Texture, Access::ReadHistory),
            GLbitfield{GL_TEXTURE_FETCH_BARRIER_BIT});
}

TEST(Barriers, StandBeforeAClearOfWhatAShaderWrote) {
  BarrierTracker tracker;
  EXPECT_EQ(tracker.beforeClear(Resource::CountBins), 0U);
  before(tracker, Resource::CountBins, Use::Storage, Access::Modify);
  EXPECT_EQ(tracker.beforeClear(Resource::CountBins), kUpdates);
  EXPECT_EQ(tracker.beforeClear(Resource::CountBins), 0U);
  // A pass that overwrites a resource may clear it itself.
  before(tracker, Resource::PeelIds, Use::Image, Access::Scratch);
  EXPECT_EQ(before(tracker, Resource::PeelIds, Use::Image, Access::Scratch),
            GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | kUpdates);
}

TEST(Barriers, CoverBothUsesOfWhatIsStoredInSomeFramesAndRenderedInOthers) {
  BarrierTracker tracker;
  before(tracker, Resource::PredictedCount, Use::ImageOrTarget, Access::Write);
  EXPECT_EQ(before(tracker, Resource::PredictedCount, Use::ImageOrTarget, Access::Write),
            GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT | kUpdates);
}

}  // namespace
}  // namespace macula::frame
