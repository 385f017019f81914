// What tables of passes need of a device, without GL.
#include "engine/frame/device_needs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oit_combinations.h"
#include "passes/frame_list.h"

namespace macula::frame {
namespace {

using gl::Limit;

constexpr Resource kWords{"words", GL_R32UI, SizeRule::Display, ByteClass::Other, Initial::Zero};
constexpr Resource kMore{"more words", GL_R32UI, SizeRule::Display, ByteClass::Other,
                         Initial::Zero};
constexpr Resource kMap{"map", GL_R32F, SizeRule::Declared, ByteClass::Other, Initial::Zero};
constexpr Resource kSums{"sums", 0, SizeRule::Declared, ByteClass::Other, Initial::Zero};

std::int64_t amount(const PassDeclaration& table, Limit limit) {
  for (const Need& need : needsOf(table)) {
    if (need.limit == limit) return need.amount;
  }
  return 0;
}

TEST(DeviceNeeds, OfAComputeStepAreItsRows) {
  PassDeclaration d;
  d.image(2, kWords, Access::Write);
  d.image(3, kMore, Access::Read);
  d.storage(7, kSums, Access::ReadWrite);
  d.texture(8, kMap);
  EXPECT_EQ(amount(d, Limit::StorageBindings), 8);
  EXPECT_EQ(amount(d, Limit::ComputeStorageBlocks), 1);
  EXPECT_EQ(amount(d, Limit::FragmentStorageBlocks), 0);
  EXPECT_EQ(amount(d, Limit::VertexStorageBlocks), 0);
  EXPECT_EQ(amount(d, Limit::ImageUnits), 4);
  EXPECT_EQ(amount(d, Limit::ComputeImages), 2);
  EXPECT_EQ(amount(d, Limit::CombinedOutputs), 3);
  EXPECT_EQ(amount(d, Limit::TextureUnits), 9);
}

TEST(DeviceNeeds, OfAStepThatDrawsTheSceneCountItsTextures) {
  PassDeclaration d;
  d.scene();
  d.color(1, kMap, Access::Write);
  d.image(0, kWords, Access::ReadWrite);
  d.storage(2, kSums, Access::ReadWrite);
  EXPECT_EQ(amount(d, Limit::VertexStorageBlocks), 0);
  EXPECT_EQ(amount(d, Limit::FragmentStorageBlocks), 1);
  EXPECT_EQ(amount(d, Limit::CombinedStorageBlocks), 1);
  EXPECT_EQ(amount(d, Limit::CombinedOutputs), 3);
  EXPECT_EQ(amount(d, Limit::DrawBuffers), 2);
  EXPECT_EQ(amount(d, Limit::FragmentTextures), 6);
  d.clear();
  d.color(0, kMap, Access::Write);
  EXPECT_EQ(amount(d, Limit::FragmentTextures), 0) << "forgotten with the rows";
}

TEST(DeviceNeeds, AreTheMostOfAnyStepWithAlternativesOnceAndRestingRowsToo) {
  PassDeclaration d;
  d.image(0, kWords, Access::Write).when(false);
  d.image(0, kMore, Access::Write);
  d.step();
  d.image(0, kWords, Access::Read);
  d.image(1, kMore, Access::Write).when(false);
  EXPECT_EQ(amount(d, Limit::ComputeImages), 2);
  PassDeclaration alternatives;
  alternatives.image(0, kWords, Access::Write).when(false);
  alternatives.image(0, kMore, Access::Write);
  EXPECT_EQ(amount(alternatives, Limit::ComputeImages), 1);
}

TEST(DeviceNeeds, TexturesOfADeclaredSizeNeedTheirSide) {
  PassDeclaration d;
  d.depth(kMap, Access::Write);
  d.size(kMap, {100, 40000});
  EXPECT_EQ(amount(d, Limit::TextureSide), 40000);
}

TEST(DeviceNeeds, TheFirstThatExceedsItsLimitIsNamedWithBothNumbers) {
  gl::Limits limits = gl::guaranteedLimits();
  const std::vector<Need> needs{{Limit::StorageBindings, 8}, {Limit::ImageUnits, 9}};
  const auto found = shortageOf("oit.capture", needs, limits);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->describe(),
            "pass 'oit.capture' needs 9 image units (GL_MAX_IMAGE_UNITS), and this GPU has 8");
  limits[Limit::ImageUnits] = 9;
  EXPECT_FALSE(shortageOf("oit.capture", needs, limits).has_value());
}

TEST(DeviceNeeds, OfEveryCombinationFitTheBindingsThatAllDevicesHave) {
  gl::Limits limits = gl::guaranteedLimits();
  constexpr glm::ivec2 kSize{96, 64};
  const passes::LodPlan lod{.size = kSize, .texels = kSize};
  FrameInputs in = passes::inputsOf({.opaqueTriangles = 1,
                                     .transparentTriangles = 1,
                                     .litOpaque = true,
                                     .litTransparent = true,
                                     .shadowLight = true,
                                     .environment = true});
  in.outputSize = in.displaySize = kSize;
  const passes::RenderSettings settings;
  int frames = 0;
  int within = 0;
  for (const passes::OitSettings& options : test::acceptedSettings()) {
    for (const passes::SyncMode sync : test::syncModesOf(passes::methodById(options.method))) {
      passes::OitPlan plan = test::planOf(options, sync);
      plan.imageSize = plan.size = kSize;
      const FrameList list = passes::makeFrameList(settings, plan, lod);
      const auto found = list.shortage(in, limits);
      EXPECT_FALSE(found.has_value()) << options.method << ": " << found->describe();
      ++frames;
      gl::Limits least = limits;
      least[Limit::CombinedOutputs] = 6;
      if (!list.shortage(in, least)) ++within;
    }
  }
  EXPECT_GT(frames, 300);
  EXPECT_GT(within, 0);
  EXPECT_LT(within, frames) << "else the message for those that do not fit is never seen";
  RecordProperty("combinations within 6 outputs", within);
}

}  // namespace
}  // namespace macula::frame
