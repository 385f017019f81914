// Views, sizes and moments at the edge: nothing to draw, odd windows, gaze outside, cuts.
#include <gmock/gmock.h>

#include "oit_cases.h"

namespace macula::test {
namespace {

using passes::OitSettings;
using passes::Predictor;
using passes::Tail;

/// One row of options for each method, with tail and fill where they apply.
std::vector<OitSettings> eachMethod(passes::DeviceContext& device) {
  std::vector<OitSettings> all{
      {.method = "blend"},
      {.method = "wboit"},
      {.method = "peel", .layers = 3},
      {.method = "ab-array", .layers = 3},
      {.method = "ab-list"},
      {.method = "ab-sbuffer"},
      {.method = "kb-racy", .kAve = 3.0},
      {.method = "kb-atomic", .kAve = 3.0, .tail = Tail::Mean},
      {.method = "kb-fixed", .kAve = 3.0, .tail = Tail::Mean},
      {.method = "kb-fixed", .kAve = 3.0, .fragmentBytes = 8},
      {.method = "kb-plus", .kAve = 2.0, .fill = true, .tail = Tail::Mean},
      {.method = "kb-plus", .kAve = 2.0},
      {.method = "kb-variable", .kAve = 2.0},
      {.method = "kb-variable", .kAve = 2.0, .fill = true, .tail = Tail::Mean},
      {.method = "kb-variable", .kAve = 2.0, .importance = Predictor::Transmittance},
      {.method = "kb-variable", .kAve = 2.0, .tail = Tail::Mean, .importance = Predictor::Error}};
  if (!device.capabilities.routableSamples.empty()) {
    const int samples = device.capabilities.routableSamples.front();
    all.push_back({.method = "kb-stencil", .kAve = static_cast<double>(samples)});
  }
  return all;
}

void expectSound(const Bench& bench, const passes::FrameResult& result, const std::string& what) {
  EXPECT_TRUE(allFinite(bench.linear())) << what;
  if (!result.fragments) return;
  const passes::FragmentCounts& f = *result.fragments;
  EXPECT_EQ(f.generated, f.stored + f.merged + f.lost) << what;
  if (const auto budget = bench.renderer.plan().budgetBytes) {
    EXPECT_LE(bench.renderer.bytes().oit, *budget) << what;
  }
}

class Edges : public GlTest {};

/// glFinish after each pass hides a barrier or a buffer that is missing; GL timer queries do not
/// wait.
TEST_F(Edges, PassesNeedNoWaitBetweenThem) {
  const scene::Scene scene = tangle(60, 1);
  const gl::TimeSource before = device().time.source;
  for (const OitSettings& oit : eachMethod(device())) {
    if (oit.method == "kb-racy") continue;  // no two frames need to be alike
    std::vector<std::vector<std::uint8_t>> shown;
    for (const gl::TimeSource source : {gl::TimeSource::Finish, gl::TimeSource::Query}) {
      device().time.source = source;
      Bench bench(scene, settingsOf(oit), {40, 24}, device());
      for (int frame = 0; frame < 2; ++frame) {
        bench.draw();
        shown.push_back(bench.display());
      }
    }
    EXPECT_EQ(shown[0], shown[2]) << describe(oit) << ", first frame";
    EXPECT_EQ(shown[1], shown[3]) << describe(oit) << ", second frame";
  }
  device().time.source = before;
}

TEST_F(Edges, EverythingOffScreenShowsWhatIsBehind) {
  const scene::Scene scene = tangle(60, 1);
  for (const OitSettings& oit : eachMethod(device())) {
    passes::RenderSettings settings = settingsOf(oit);
    settings.background = {0.25F, 0.5F, 0.75F};
    Bench bench(scene, settings, {24, 16}, device());
    bench.draw();  // something to leave behind
    bench.camera.target = {0.0F, 0.0F, 1.0F};
    for (int frame = 0; frame < 2; ++frame) {
      const passes::FrameResult result = bench.draw();
      expectSound(bench, result, describe(oit));
      if (result.fragments) {
        EXPECT_EQ(result.fragments->generated, 0U) << describe(oit);
        EXPECT_FALSE(result.layers) << describe(oit);
      }
      const std::vector<float> rgb = bench.linear();
      for (std::size_t i = 0; i < rgb.size(); ++i) {
        ASSERT_EQ(rgb[i], settings.background[static_cast<int>(i % 3)]) << describe(oit);
      }
    }
  }
}

TEST_F(Edges, NothingTransparentNeedsNoStorage) {
  const scene::Scene scene = sheets({{2.0F, {0.5F, 0.5F, 0.5F, 1.0F}, 0.0F, 0.0F, true}});
  for (const OitSettings& oit : eachMethod(device())) {
    Bench bench(scene, settingsOf(oit), {24, 16}, device());
    const passes::FrameResult result = bench.draw();
    EXPECT_TRUE(result.exact) << describe(oit);
    EXPECT_EQ(bench.renderer.bytes().oit, 0U) << describe(oit);
    EXPECT_NEAR(bench.linear()[0], 0.5F, 5e-3F) << describe(oit);
  }
}

TEST_F(Edges, OddSizesShowTheSame) {
  // Three layers, so that every method with three slots or a tail that holds one is exact.
  std::vector<glm::vec4> colors;
  std::vector<Sheet> list;
  for (int i = 0; i < 3; ++i) {
    colors.push_back(variedColor(i + 1, 0.4F));
    list.push_back({1.0F + static_cast<float>(i), colors.back()});
  }
  const scene::Scene scene = sheets(list);
  const glm::vec3 expected = over(colors, {});
  for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(1, 64), glm::ivec2(127, 3),
                                glm::ivec2(33, 17), glm::ivec2(2, 2)}) {
    for (const OitSettings& given : eachMethod(device())) {
      OitSettings oit = given;
      if (oit.method != "kb-stencil") oit.kAve = oit.tail == Tail::Mean ? 4.0 : 13.0;
      Bench bench(scene, settingsOf(oit), size, device());
      const passes::FrameResult result = bench.draw();
      const std::string what = describe(oit) + " " + std::to_string(size.x);
      expectSound(bench, result, what);
      if (!result.fragments) continue;  // blending has no order
      EXPECT_EQ(result.fragments->generated, 3ULL * static_cast<unsigned>(size.x * size.y));
      // Without a fill, importance may leave a pixel of a large window short.
      if (oit.method == "kb-variable" && result.fragments->lost + result.fragments->merged > 0) {
        continue;
      }
      const float tolerance = oit.fragmentBytes == 8 ? 6e-3F : 2e-3F;
      const std::vector<float> rgb = bench.linear();
      for (std::size_t i = 0; i < rgb.size(); ++i) {
        ASSERT_NEAR(rgb[i], expected[static_cast<int>(i % 3)], tolerance) << what;
      }
    }
  }
}

TEST_F(Edges, LargeWindowsRun) {
  scene::Scene scene = sheets({{2.0F, variedColor(1, 0.5F)}});
  for (const OitSettings& oit :
       {OitSettings{.method = "kb-variable", .kAve = 0.25, .fill = true, .tail = Tail::Mean},
        OitSettings{.method = "kb-variable", .kAve = 0.25}, OitSettings{.method = "blend"}}) {
    passes::RenderSettings settings = settingsOf(oit);
    settings.tonemap.linearOut = false;
    Bench bench(scene, settings, {4096, 4096}, device());
    const passes::FrameResult result = bench.draw();
    if (!result.fragments) continue;
    EXPECT_EQ(result.fragments->generated, 4096ULL * 4096) << describe(oit);
    EXPECT_LE(result.fragments->stored, 4096ULL * 1024) << describe(oit);
    if (oit.fill) {
      EXPECT_EQ(result.fragments->stored, 4096ULL * 1024) << describe(oit);
    }
  }
}

TEST_F(Edges, GazeInCornersAndOutside) {
  const scene::Scene scene = tangle(200, 5);
  for (const glm::vec2 gaze :
       {glm::vec2(0.0F, 0.0F), glm::vec2(1.0F, 0.0F), glm::vec2(0.0F, 1.0F), glm::vec2(1.0F, 1.0F),
        glm::vec2(-3.0F, 0.5F), glm::vec2(2.0F, 7.0F), glm::vec2(1e6F, -1e6F)}) {
    for (const OitSettings& oit : eachMethod(device())) {
      passes::RenderSettings settings = settingsOf(oit);
      settings.importance.gazeWeight = 1.0;  // the predictors look at it too
      Bench bench(scene, settings, {37, 29}, device());
      for (int frame = 0; frame < 2; ++frame) {
        const passes::FrameResult result = bench.draw(gaze);
        expectSound(bench, result, describe(oit));
        if (result.fragments) {
          EXPECT_GT(result.fragments->stored, 0U) << describe(oit);
        }
      }
    }
  }
}

TEST_F(Edges, CutsResizesAndSettingsStartAfresh) {
  const scene::Scene scene = tangle(200, 5);
  for (const OitSettings& oit : eachMethod(device())) {
    passes::RenderSettings settings = settingsOf(oit);
    settings.importance.layerLimit = 10.0;  // else it follows what was seen before
    Bench fresh(scene, settings, {40, 32}, device());
    fresh.draw();
    const std::vector<float> first = fresh.linear();
    Bench bench(scene, settings, {56, 24}, device());
    bench.draw({0.1F, 0.9F});
    bench.draw({0.9F, 0.1F});
    bench.renderer.resize({40, 32});
    bench.draw();
    EXPECT_EQ(countUnlike(bench.linear(), first), 0U) << describe(oit) << " after a resize";
    bench.draw();
    bench.draw(glm::vec2(0.5F), true);
    EXPECT_EQ(countUnlike(bench.linear(), first), 0U) << describe(oit) << " after a cut";
    bench.draw();
    bench.settings.oit = {.method = "ab-list"};
    bench.renderer.settingsChanged();
    bench.draw();
    bench.settings.oit = oit;
    bench.renderer.settingsChanged();
    bench.draw();
    EXPECT_EQ(countUnlike(bench.linear(), first), 0U) << describe(oit) << " after another method";
  }
}

/// Sheets of one depth, so that every pixel has the same number of fragments.
TEST_F(Edges, NoSlotsAndOneSlot) {
  const scene::Scene scene = sheets({{1.0F, {1, 0, 0, 0.5F}}, {2.0F, {0, 1, 0, 0.5F}}});
  // Half a slot for each pixel: k is 0 in half of them, 1 in the others.
  for (const OitSettings& oit : sortedCases(0.5)) {
    if (!oit.fill || oit.sync != "spinlock" || oit.fragmentBytes == 8) continue;
    Bench bench(scene, settingsOf(oit), {32, 16}, device());
    const passes::FrameResult result = bench.draw();
    ASSERT_TRUE(result.layers);
    EXPECT_EQ(result.layers->min, 0U) << describe(oit);
    EXPECT_EQ(result.layers->max, 1U) << describe(oit);
    const bool tail = oit.tail == Tail::Mean;
    EXPECT_EQ(result.fragments->stored, tail ? 0U : 256U) << describe(oit);
    EXPECT_EQ(result.fragments->merged, tail ? 512U : 0U) << describe(oit);
    const std::vector<float> rgb = bench.linear();
    for (std::size_t i = 0; i < rgb.size(); i += 3) {
      // Nothing; the nearest; or both as a mean of equal optical depths.
      const glm::vec3 shown(rgb[i], rgb[i + 1], rgb[i + 2]);
      const glm::vec3 one = tail ? glm::vec3(0.375F, 0.375F, 0.0F) : glm::vec3(0.5F, 0.0F, 0.0F);
      ASSERT_TRUE(shown == glm::vec3(0.0F) || glm::length(shown - one) < 1e-3F) << describe(oit);
    }
  }
}

}  // namespace
}  // namespace macula::test
