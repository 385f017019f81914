// Memory that does not suffice: pools that are capped, buffers that the driver refuses.
#include <gmock/gmock.h>

#include "engine/core/error.h"
#include "engine/scene/procedural/recipes.h"
#include "oit_cases.h"

namespace macula::test {
namespace {

using passes::OitSettings;

constexpr glm::ivec2 kSize{48, 40};
constexpr std::uint64_t kPixels = 48 * 40;

class Memory : public GlTest {
 protected:
  void TearDown() override {
    limitBlocks(limit_);
    GlTest::TearDown();
  }
  /// Until the end of the test, buffers may hold no more.
  void limitBlocks(std::int64_t bytes) {
    device().capabilities.limits[gl::Limit::StorageBlockBytes] = bytes;
  }

 private:
  std::int64_t limit_ = device().capabilities.limits[gl::Limit::StorageBlockBytes];
};

TEST_F(Memory, ACappedPoolCountsWhatDoesNotFit) {
  constexpr int kLayers = 32;
  const scene::Scene scene = scene::makeLayers(kLayers, 1);
  struct Capped {
    const char* method;
    std::uint64_t slots;
  };
  // 0.25 MiB in fragments of 16 bytes, and in list elements of 20.
  for (const Capped& c : {Capped{"ab-sbuffer", 262144 / 16}, Capped{"ab-list", 262144 / 20}}) {
    for (const char* sync : {"ordered", "spinlock"}) {
      const OitSettings oit{.method = c.method, .memoryMiB = 0.25, .sync = sync};
      if (oit.sync == "ordered" && !device().ordered.passed) continue;
      Bench bench(scene, settingsOf(oit), kSize, device());
      for (int frame = 0; frame < 3; ++frame) {
        const passes::FrameResult result = bench.draw();
        EXPECT_EQ(result.fragments->generated, kLayers * kPixels) << describe(oit);
        EXPECT_EQ(result.fragments->stored, c.slots) << describe(oit);
        EXPECT_EQ(result.fragments->lost, kLayers * kPixels - c.slots) << describe(oit);
        EXPECT_FALSE(result.exact) << describe(oit);
        EXPECT_EQ(result.recaptures, 0) << describe(oit);
        EXPECT_LE(bench.renderer.bytes().oit, 262144U) << describe(oit);
        EXPECT_TRUE(allFinite(bench.linear())) << describe(oit);
      }
      // With fewer layers the same pool is exact again.
      const scene::GpuScene small(scene::makeLayers(4, 1), nullptr);
      bench.renderer.setScene(small);
      const passes::FrameResult result = bench.draw();
      EXPECT_TRUE(result.exact) << describe(oit);
      EXPECT_EQ(result.fragments->stored, 4 * kPixels) << describe(oit);
      const glm::vec3 expected = scene::layersComposite(4);
      EXPECT_NEAR(bench.linear()[1], expected.g, 2e-3F) << describe(oit);
    }
  }
}

TEST_F(Memory, ACapThatHoldsNothingIsRefused) {
  for (const char* method : {"ab-sbuffer", "ab-list", "kb-variable", "kb-fixed", "kb-plus"}) {
    Bench bench(tangle(10, 1), settingsOf({.method = method, .memoryMiB = 1e-6}), kSize, device());
    EXPECT_THROW(bench.draw(), InputError) << method;
  }
}

TEST_F(Memory, AFullArrayKeepsTheFirstDrawn) {
  constexpr int kLayers = 32;
  const OitSettings oit{.method = "ab-array", .layers = 5};
  Bench bench(scene::makeLayers(kLayers, 1), settingsOf(oit), kSize, device());
  for (int frame = 0; frame < 2; ++frame) {
    const passes::FrameResult result = bench.draw();
    EXPECT_EQ(result.fragments->stored, 5 * kPixels);
    EXPECT_EQ(result.fragments->lost, (kLayers - 5) * kPixels);
    EXPECT_FALSE(result.exact);
    EXPECT_TRUE(allFinite(bench.linear()));
  }
}

TEST_F(Memory, AnOverflowLeavesOtherPixelsAlone) {
  const scene::Scene scene = tangle(240, 5);
  Bench exact(scene, linearSettings("ab-sbuffer"), kSize, device());
  const std::uint64_t generated = exact.draw().fragments->generated;
  const std::vector<float> wanted = exact.linear();
  const auto counts = exact.floats(passes::kFragmentCount, 1);
  for (const char* sync : {"ordered", "spinlock"}) {
    const OitSettings array{.method = "ab-array", .sync = sync, .layers = 5};
    // Half of what the scene needs.
    const OitSettings ranges{.method = "ab-sbuffer",
                             .memoryMiB = 8.0 * static_cast<double>(generated) / (1 << 20),
                             .sync = sync};
    for (const OitSettings& oit : {array, ranges}) {
      if (oit.sync == "ordered" && !device().ordered.passed) continue;
      Bench bench(scene, settingsOf(oit), kSize, device());
      const passes::FrameResult result = bench.draw();
      EXPECT_GT(result.fragments->lost, 500U) << describe(oit);
      const std::vector<float> rgb = bench.linear();
      std::vector<std::uint32_t> table;
      if (bench.renderer.plan().method->hasRanges()) {
        table = bench.words(passes::kFragmentRange, 2);
      }
      std::size_t whole = 0;
      std::size_t unlike = 0;
      for (std::size_t p = 0; p < counts.size(); ++p) {
        const double slots = table.empty() ? 5.0 : table[2 * p + 1];
        if (counts[p] > slots) continue;  // some of this pixel's are lost
        ++whole;
        // Tables have rows from the bottom, images from the top.
        const std::size_t row = static_cast<std::size_t>(kSize.y) - 1 - p / 48;
        for (std::size_t c = 0; c < 3; ++c) {
          const std::size_t i = 3 * (row * 48 + p % 48) + c;
          if (rgb[i] != wanted[i]) ++unlike;
        }
      }
      EXPECT_GT(whole, kPixels / 10) << describe(oit);
      EXPECT_EQ(unlike, 0U) << describe(oit);
      note("whole pixels of " + describe(oit), static_cast<double>(whole));
    }
  }
}

TEST_F(Memory, ARefusedGrowthLeavesTheRendererUsable) {
  const scene::Scene deep = scene::makeLayers(64, 1);
  const scene::GpuScene few(scene::makeLayers(2, 1), nullptr);
  for (const char* method : {"ab-sbuffer", "ab-list"}) {
    Bench bench(deep, settingsOf({.method = method}), kSize, device());
    limitBlocks(2 * 8 * static_cast<std::int64_t>(kPixels) * 4);  // eight slots a pixel
    // Twice: the first refusal must not leave a pool behind that is larger than its memory.
    for (int frame = 0; frame < 2; ++frame) {
      EXPECT_THROW(bench.draw(), InputError) << method << " frame " << frame;
    }
    bench.renderer.setScene(few);
    const passes::FrameResult result = bench.draw();
    EXPECT_TRUE(result.exact) << method;
    EXPECT_EQ(result.fragments->stored, 2 * kPixels) << method;
    bench.renderer.setScene(bench.gpu);
    EXPECT_THROW(bench.draw(), InputError) << method;
    bench.renderer.resize({8, 8});
    EXPECT_TRUE(bench.draw().exact) << method << ": fewer pixels fit";
  }
}

TEST_F(Memory, BuffersBeyondTheDriverAreOneLine) {
  const scene::Scene scene = scene::makeLayers(8, 1);
  const std::vector<OitSettings> tooLarge{
      {.method = "ab-sbuffer"},
      {.method = "ab-list"},
      {.method = "ab-array", .layers = 64},
      // 2^34 slots: more than 32 bits count.
      {.method = "ab-array", .layers = 1024},
      {.method = "kb-fixed", .kAve = 32.0},
      {.method = "kb-variable", .kAve = 30.0},
      {.method = "kb-atomic", .kAve = 30.0},
      {.method = "kb-plus", .kAve = 30.0},
      {.method = "kb-variable", .memoryMiB = 8192.0},
  };
  limitBlocks(128 << 20);
  for (const OitSettings& oit : tooLarge) {
    passes::RenderSettings settings = settingsOf(oit);
    settings.tonemap.linearOut = false;
    Bench bench(scene, settings, {4096, 4096}, device());
    try {
      bench.draw();
      ADD_FAILURE() << "drawn: " << describe(oit);
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("lower")) << describe(oit);
      EXPECT_THAT(error.what(), testing::Not(testing::HasSubstr("\n"))) << describe(oit);
    }
    // The same renderer goes on at a size that it can do.
    bench.settings.oit.kAve = 8.0;
    bench.settings.oit.memoryMiB = 0.0;
    bench.renderer.resize({16, 12});
    EXPECT_EQ(bench.draw().fragments->generated, 8U * 16U * 12U) << describe(oit);
  }
}

}  // namespace
}  // namespace macula::test
