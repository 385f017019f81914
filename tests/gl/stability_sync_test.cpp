// Per-pixel ordering that fails: locks that are given up, and insertion without any.
#include <gmock/gmock.h>

#include "engine/measure/hazards.h"
#include "engine/scene/procedural/recipes.h"
#include "oit_cases.h"
#include "shader_copy.h"

namespace macula::test {
namespace {

using passes::OitSettings;
using passes::Tail;

constexpr int kLayers = 12;
constexpr int kSlots = 5;
constexpr glm::ivec2 kSize{32, 20};
constexpr std::uint64_t kPixels = 32 * 20;
constexpr std::uint32_t kHalfs = 0x38003800;  // two halves of 0.5; as a float, 3.05e-5

std::vector<OitSettings> lockedCases() {
  std::vector<OitSettings> all;
  for (const OitSettings& oit : sortedCases(kSlots)) {
    if (oit.sync == "spinlock" && oit.importance == passes::Predictor::Published &&
        oit.method != "kb-learned" && (oit.method != "kb-variable" || oit.fill)) {
      all.push_back(oit);
    }
  }
  return all;
}

class Ordering : public GlTest {};

TEST_F(Ordering, LocksAreNeverGivenUpWithTheUsualBound) {
  for (const OitSettings& oit : lockedCases()) {
    Bench bench(scene::makeLayers(kLayers, 1), settingsOf(oit), kSize, device());
    EXPECT_EQ(bench.draw().lockFailures, 0U) << describe(oit);
  }
}

TEST_F(Ordering, LocksGivenUpEverywhereAreCountedAsLost) {
  const ShaderCopy shaders;
  shaders.define("LOCK_BOUND", "0");
  passes::DeviceContext own;
  own.programs = gl::ProgramCache(shaders.folder());
  for (const OitSettings& oit : lockedCases()) {
    Bench bench(scene::makeLayers(kLayers, 1), settingsOf(oit), kSize, own);
    bench.draw();
    // Slots that no fragment was written to hold anything; none of it may reach the image.
    const frame::FrameResources& memory = bench.renderer.resources();
    for (const frame::Resource* slots : {&passes::kFragmentKeys, &passes::kFragmentColors}) {
      if (memory.has(*slots)) memory.fill(memory.slotOf(*slots), kHalfs);
    }
    const passes::FrameResult result = bench.draw();
    EXPECT_EQ(result.lockFailures, kLayers * kPixels) << describe(oit);
    EXPECT_EQ(result.fragments->lost, kLayers * kPixels) << describe(oit);
    EXPECT_EQ(result.fragments->stored, 0U) << describe(oit);
    EXPECT_EQ(result.fragments->merged, 0U) << describe(oit);
    EXPECT_FALSE(result.exact);
    for (const float value : bench.linear()) ASSERT_EQ(value, 0.0F) << describe(oit);
  }
}

TEST_F(Ordering, LocksGivenUpInPlacesLeaveTheOthersAlone) {
  // No try in even columns, one in odd ones, which is enough without contention.
  const ShaderCopy shaders;
  shaders.define("LOCK_BOUND", "(int(gl_FragCoord.x) & 1)");
  passes::DeviceContext own;
  own.programs = gl::ProgramCache(shaders.folder());
  if (!own.ordered.passed) GTEST_SKIP() << "fragments of a pixel may contend here";
  for (const OitSettings& oit : lockedCases()) {
    if (oit.method == "kb-variable") continue;  // its slots differ from pixel to pixel
    const scene::Scene scene = scene::makeLayers(kLayers, 1);
    Bench whole(scene, settingsOf(oit), kSize, device());
    Bench bench(scene, settingsOf(oit), kSize, own);
    const passes::FrameResult wanted = whole.draw();
    const passes::FrameResult result = bench.draw();
    EXPECT_EQ(result.lockFailures, kLayers * kPixels / 2) << describe(oit);
    EXPECT_EQ(result.fragments->lost, (kLayers * kPixels + wanted.fragments->lost) / 2)
        << describe(oit);
    EXPECT_EQ(result.fragments->stored, wanted.fragments->stored / 2) << describe(oit);
    EXPECT_EQ(result.fragments->merged, wanted.fragments->merged / 2) << describe(oit);
    const std::vector<float> rgb = bench.linear();
    const std::vector<float> all = whole.linear();
    for (std::size_t i = 0; i < rgb.size(); ++i) {
      ASSERT_EQ(rgb[i], i / 3 % 2 == 1 ? all[i] : 0.0F) << describe(oit);
    }
  }
}

image::Image8 displayed(const Bench& bench, glm::ivec2 size) {
  image::Image8 image{size.x, size.y, 3, bench.display()};
  return image;
}

TEST_F(Ordering, WithoutItPixelsMayDiffer) {
  constexpr glm::ivec2 kLarger{96, 80};
  for (const Tail tail : {Tail::None, Tail::Mean}) {
    for (const int bytes : {16, 8}) {
      const scene::Scene scene = tangle(300, 5);
      OitSettings oit{.method = "kb-fixed", .kAve = 4.0, .tail = tail, .fragmentBytes = bytes};
      Bench fixed(scene, settingsOf(oit), kLarger, device());
      oit.method = "kb-racy";
      Bench racy(scene, settingsOf(oit), kLarger, device());
      fixed.draw();
      const passes::FrameResult result = racy.draw();
      EXPECT_FALSE(result.exact) << "it cannot promise anything";
      const std::uint64_t unlike =
          measure::countUnlikePixels(displayed(fixed, kLarger), displayed(racy, kLarger));
      note("pixels unlike, " + describe(oit), static_cast<double>(unlike));
      if (device().ordered.passed) {
        EXPECT_EQ(unlike, 0U) << "this rasteriser orders fragments by itself";
      }
    }
  }
}

}  // namespace
}  // namespace macula::test
