// Devices that offer less: every limit lowered to what OpenGL 4.5 promises.
#include <gmock/gmock.h>

#include <map>
#include <set>

#include "engine/core/error.h"
#include "oit_cases.h"
#include "shared/bindings.h"
#include "shared/frame_constants.h"
#include "shared/scene_data.h"

namespace macula::test {
namespace {

using gl::Limit;

constexpr glm::ivec2 kSize{48, 40};

class DeviceLimits : public GlTest {
 protected:
  void TearDown() override {
    limits() = own_;
    device().capabilities.routableSamples = ownSamples_;
    GlTest::TearDown();
  }
  static gl::Limits& limits() { return device().capabilities.limits; }

  /// By method: its image, or why there is none.
  struct Outcome {
    std::vector<float> image;
    std::string refusal;
  };
  /// With spin locks where a method takes them: they need an image more.
  Outcome draw(const passes::Method& method) const {
    passes::OitSettings oit{.method = std::string(method.id)};
    if (method.sorts() && !method.isRacy()) oit.sync = "spinlock";
    try {
      Bench bench(scene_, settingsOf(oit), kSize, device());
      bench.draw();
      return {bench.linear(), {}};
    } catch (const InputError& error) {
      return {{}, error.what()};
    }
  }
  [[nodiscard]] std::map<std::string, Outcome> drawAll() const {
    std::map<std::string, Outcome> all;
    for (const passes::Method& method : passes::methods()) {
      all[std::string(method.id)] = draw(method);
    }
    return all;
  }

  std::vector<int> ownSamples_ = device().capabilities.routableSamples;

 private:
  gl::Limits own_ = limits();
  scene::Scene scene_ = unlit(tangle(30, 3));
};

TEST_F(DeviceLimits, EachAtItsLeastIsKeptTo) {
  const auto whole = drawAll();
  int ran = 0;
  for (const gl::LimitRow& row : gl::limitRows()) {
    const std::int64_t own = limits()[row.limit];
    EXPECT_GE(own, row.guaranteed) << row.name << " is less than OpenGL 4.5 promises";
    limits()[row.limit] = row.guaranteed;
    for (const auto& [method, outcome] : drawAll()) {
      if (outcome.refusal.empty()) {
        EXPECT_EQ(outcome.image, whole.at(method).image) << method << " with " << row.name;
        ++ran;
        continue;
      }
      EXPECT_EQ(outcome.refusal, whole.at(method).refusal) << method << " with " << row.name;
    }
    limits()[row.limit] = own;
  }
  note("frames drawn under a lowered limit", ran);
  EXPECT_GT(ran, 0);
}

TEST_F(DeviceLimits, TheMethodsThatARefusalOffersRun) {
  limits()[Limit::CombinedOutputs] = 6;
  passes::OitSettings predicted{.method = "kb-variable", .sync = "spinlock"};
  Bench bench(unlit(tangle(30, 3)), settingsOf(predicted), kSize, device());
  std::string refusal;
  try {
    bench.draw();
  } catch (const InputError& error) {
    refusal = error.what();
  }
  ASSERT_THAT(refusal, testing::HasSubstr("pass 'oit.capture' needs 7"));
  const std::string offer = "these run with their default options: --method ";
  ASSERT_THAT(refusal, testing::HasSubstr(offer));
  const std::string list = refusal.substr(refusal.find(offer) + offer.size()) + ",";
  int offered = 0;
  for (const passes::Method& method : passes::methods()) {
    if (list.find(std::string(method.id) + ",") == std::string::npos) continue;
    const passes::OitSettings oit{.method = std::string(method.id)};
    Bench other(unlit(tangle(30, 3)), settingsOf(oit), kSize, device());
    EXPECT_NO_THROW(other.draw()) << method.id;
    ++offered;
  }
  EXPECT_GT(offered, 5);
}

TEST_F(DeviceLimits, ThatNoMethodKeepsToAreSaidToBeTheDevices) {
  limits()[Limit::ColorAttachments] = 0;
  for (const auto& [method, outcome] : drawAll()) {
    EXPECT_THAT(outcome.refusal,
                testing::EndsWith("; no --method runs here; use another GPU or driver"))
        << method;
  }
}

TEST_F(DeviceLimits, AllAtTheirLeastEveryMethodRunsThatTheDriverDraws) {
  const auto whole = drawAll();
  limits() = gl::guaranteedLimits();
  int ran = 0;
  for (const auto& [method, outcome] : drawAll()) {
    EXPECT_EQ(outcome.refusal, whole.at(method).refusal) << method;
    EXPECT_EQ(outcome.image, whole.at(method).image) << method;
    ran += outcome.refusal.empty() ? 1 : 0;
  }
  note("methods drawn", ran);
  EXPECT_GE(ran, 12);
}

TEST_F(DeviceLimits, OfSamplesAreKeptToOrNamed) {
  const passes::Method& routed = passes::methodById("kb-stencil");
  const std::string whole = draw(routed).refusal;  // this driver may not route at all
  // OpenGL 4.5 promises one sample of integers, or none.
  device().capabilities.routableSamples = {};
  EXPECT_THAT(draw(routed).refusal, testing::HasSubstr("(GL_MAX_INTEGER_SAMPLES); use kb-fixed"));
  device().capabilities.routableSamples = {16};
  EXPECT_THAT(draw(routed).refusal, testing::HasSubstr("16 samples a pixel at the least"));
  device().capabilities.routableSamples = ownSamples_;
  EXPECT_EQ(draw(routed).refusal, whole);
}

TEST_F(DeviceLimits, ThatNoTableStatesAreKeptEverywhere) {
  const auto most = static_cast<std::size_t>(gl::rowOf(Limit::UniformBlockBytes).guaranteed);
  EXPECT_LE(sizeof(shader::FrameConstants), most);
  EXPECT_LE(sizeof(shader::LightBlock), most);
  EXPECT_LT(std::max({UBO_FRAME, UBO_LIGHTS, UBO_MATERIAL}),
            gl::rowOf(Limit::UniformBindings).guaranteed);
  if (!device().capabilities.renderer.starts_with("llvmpipe")) GTEST_SKIP() << "offers more";
  // Work groups: what links where no more is offered fits everywhere.
  for (const Limit limit : {Limit::GroupThreads, Limit::GroupBytes}) {
    EXPECT_EQ(limits()[limit], gl::rowOf(limit).guaranteed);
  }
}

constexpr frame::Resource kPlain{"plain colour", GL_RGBA8, frame::SizeRule::Display,
                                 frame::ByteClass::Other, frame::Initial::Undefined};
constexpr frame::Resource kSampled{"sampled colour", GL_RGBA8, frame::SizeRule::DisplaySamples,
                                   frame::ByteClass::Other, frame::Initial::Undefined};

TEST_F(DeviceLimits, TargetsThatTheDriverRefusesAreNamed) {
  frame::FrameResources resources;
  std::array<frame::Demand, 2> demands;
  demands[0].resource = &kPlain;
  demands[1].resource = &kSampled;
  demands[1].samples = 4;
  for (frame::Demand& demand : demands) demand.size = kSize;
  resources.allocate(demands, limits()[Limit::StorageBlockBytes]);
  std::array<std::uint32_t, frame::FrameResources::kMostTargets> colors{};
  colors.fill(frame::FrameResources::kNoSlot);
  colors[0] = resources.slotOf(kPlain);
  colors[1] = resources.slotOf(kSampled);
  try {
    (void)resources.framebuffer(colors, frame::FrameResources::kNoSlot);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("plain colour, sampled colour"));
  }
}

}  // namespace
}  // namespace macula::test
