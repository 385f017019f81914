// The real frame, checked without GL: order, work, folders.
#include "passes/frame_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "engine/core/file.h"
#include "oit_combinations.h"
#include "passes/resources.h"

namespace macula::passes {
namespace {

constexpr glm::ivec2 kSize{96, 64};

frame::FrameInputs sized(const scene::SceneFacts& facts) {
  frame::FrameInputs inputs = inputsOf(facts);
  inputs.outputSize = inputs.displaySize = kSize;
  return inputs;
}

OitPlan sized(OitPlan plan) {
  plan.imageSize = plan.size = kSize;
  return plan;
}

const scene::SceneFacts kEverything{.opaqueTriangles = 1,
                                    .transparentTriangles = 1,
                                    .litOpaque = true,
                                    .litTransparent = true,
                                    .unlitOpaque = true,
                                    .shadowLight = true,
                                    .environment = true};

std::vector<std::string> running(const frame::FrameList& list, const scene::SceneFacts& facts) {
  std::vector<std::string> names;
  for (const frame::PassReport& row : list.report(sized(facts))) {
    EXPECT_FALSE(row.reason.empty()) << row.name;
    if (row.runs) names.emplace_back(row.name);
  }
  return names;
}

/// Everything at full rate.
const LodPlan kFullRate{.size = kSize, .texels = kSize};

TEST(FrameList, IsSoundForEveryAcceptedCombination) {
  RenderSettings settings;
  int frames = 0;
  for (const OitSettings& options : test::acceptedSettings()) {
    for (const SyncMode sync : test::syncModesOf(methodById(options.method))) {
      for (const bool factors : {false, true}) {
        settings.heatmap.map = factors ? "importance" : "none";
        OitPlan plan = sized(test::planOf(options, sync));
        plan.factorMaps = factors;
        if (factors && !plan.mapsImportance()) continue;
        const frame::FrameList list = makeFrameList(settings, plan, kFullRate);
        for (const bool history : {false, true}) {
          plan.historyValid = history;
          EXPECT_THAT(list.validate(sized(kEverything)), testing::IsEmpty())
              << test::combinationName(options) << " sync " << nameOf(sync) << " history "
              << history;
          ++frames;
        }
      }
    }
  }
  EXPECT_GT(frames, 100) << "the enumeration finds something";
  RecordProperty("frames", frames);
}

TEST(FrameList, IsSoundForEveryCombinationWithReducedRateTransparency) {
  const RenderSettings settings;
  const LodSettings reduced{.resize = 2.0, .transparency = true};
  const frame::FrameInputs inputs = sized(kEverything);
  LodPlan lod;
  planLod(lod, reduced, {}, kEverything, false);
  planFrame(lod, reduced, {}, inputs, 1);
  ASSERT_TRUE(lod.transparency);
  for (const OitSettings& options : test::acceptedSettings()) {
    OitPlan plan = sized(test::planOf(options, SyncMode::Ordered));
    plan.resizable = true;
    const frame::FrameList list = makeFrameList(settings, plan, lod);
    for (const glm::ivec2 size : {kSize, lod.texels}) {
      plan.size = size;
      EXPECT_THAT(list.validate(inputs), testing::IsEmpty())
          << test::combinationName(options) << (plan.reduced() ? " reduced" : " full");
    }
    EXPECT_THAT(running(list, kEverything),
                testing::IsSupersetOf({"lod.depth", "lod.shade", "lod.transparency"}));
    EXPECT_THAT(list.neededResources(inputs),
                testing::IsSupersetOf({&kDepth, &kReducedDepth, &kHdrColor, &kReducedColor}));
  }
}

TEST(FrameList, KnowsWhatCouldBeResizedBeforeItIs) {
  const auto planOf = [](const LodSettings& settings, const scene::SceneFacts& facts) {
    LodPlan plan;
    planLod(plan, settings, {}, facts, false);
    EXPECT_FALSE(plan.wanted || plan.transparency);
    return std::pair{plan.canResizeShading, plan.canResizeTransparency};
  };
  using Pair = std::pair<bool, bool>;
  const scene::SceneFacts unlit{.opaqueTriangles = 1, .transparentTriangles = 1};
  const scene::SceneFacts lit{.opaqueTriangles = 1, .transparentTriangles = 1, .litOpaque = true};
  EXPECT_EQ(planOf({}, unlit), Pair(false, false));
  EXPECT_EQ(planOf({.transparency = true}, unlit), Pair(false, true));
  EXPECT_EQ(planOf({}, lit), Pair(true, false));
  EXPECT_EQ(planOf({.what = "shadow"}, lit), Pair(false, false)) << "no light casts shadows";
}

TEST(FrameList, ResizesTransparencyOnlyWhereItIsAskedFor) {
  const scene::SceneFacts glass{.opaqueTriangles = 1, .transparentTriangles = 1};
  const auto resizes = [](const LodSettings& settings, const scene::SceneFacts& facts,
                          bool mayResize) {
    LodPlan plan;
    planLod(plan, settings, {}, facts, mayResize);
    return plan.transparency;
  };
  EXPECT_TRUE(resizes({.resize = 2.0, .transparency = true}, glass, false))
      << "no opaque surface need be lit";
  EXPECT_TRUE(resizes({.transparency = true}, glass, true));
  EXPECT_FALSE(resizes({.transparency = true}, glass, false));
  EXPECT_FALSE(resizes({.resize = 2.0}, glass, true));
  EXPECT_FALSE(resizes({.resize = 2.0, .transparency = true}, {.opaqueTriangles = 1}, false));
}

TEST(FrameList, IsSoundForEveryLevelOfDetail) {
  const RenderSettings settings;
  const OitPlan plan = sized({.method = &methodById("kb-variable")});
  const scene::SceneFacts facts{.opaqueTriangles = 1,
                                .litOpaque = true,
                                .shadowLight = true,
                                .veins = true,
                                .occlusion = {.radius = 1.0F, .samples = 16}};
  for (const char* what : {"shading", "shadow", "ao,noise", "shadow,ao,noise"}) {
    for (const char* reconstruction : {"bilinear", "yang2008", "macula"}) {
      for (const bool foveated : {false, true}) {
        LodSettings lod{.resize = 2.0, .what = what};
        lod.reconstruction =
            std::string_view(reconstruction) == "bilinear" ? Reconstruction::Bilinear
            : std::string_view(reconstruction) == "macula" ? Reconstruction::Macula
                                                           : Reconstruction::Yang2008;
        FoveationSettings foveation;
        foveation.enabled = foveated;
        LodPlan planned;
        planLod(planned, lod, foveation, facts, false);
        planFrame(planned, lod, foveation, sized(facts), 1);
        const frame::FrameList list = makeFrameList(settings, plan, planned);
        EXPECT_THAT(list.validate(sized(facts)), testing::IsEmpty())
            << what << ' ' << reconstruction;
        EXPECT_EQ(testing::Matches(testing::Contains("lighting"))(running(list, facts)),
                  std::string_view(what) != "shading");
      }
    }
  }
}

TEST(FrameList, ResizesNothingThatTheSceneLacks) {
  const RenderSettings settings;
  const OitPlan plan{.method = &methodById("kb-variable")};
  const scene::SceneFacts lit{.opaqueTriangles = 1, .litOpaque = true};
  const auto runs = [&](const LodSettings& lod, const scene::SceneFacts& facts) {
    LodPlan planned;
    planLod(planned, lod, {}, facts, false);
    return running(makeFrameList(settings, plan, planned), facts);
  };
  const std::vector<std::string> plain{"gbuffer", "lighting", "tonemap"};
  EXPECT_EQ(runs({.resize = 2.0, .what = "shadow,ao,noise"}, lit), plain);
  EXPECT_EQ(runs({.resize = 1.0}, lit), plain);
  EXPECT_EQ(runs({.resize = 2.0}, {.opaqueTriangles = 1, .unlitOpaque = true}), plain);
  EXPECT_EQ(runs({.resize = 2.0}, lit),
            (std::vector<std::string>{"gbuffer", "lod.rates", "lod.shade", "lod.reconstruct",
                                      "lod.holes", "tonemap"}));
}

TEST(FrameList, RunsOnlyWhatTheSceneNeeds) {
  const RenderSettings settings;
  const OitPlan variable{.method = &methodById("kb-variable")};
  const frame::FrameList list = makeFrameList(settings, variable, kFullRate);
  EXPECT_EQ(running(list, {}), (std::vector<std::string>{"tonemap"}));
  EXPECT_EQ(running(list, {.opaqueTriangles = 1, .unlitOpaque = true, .shadowLight = true}),
            (std::vector<std::string>{"gbuffer", "lighting", "tonemap"}))
      << "an unlit scene draws no shadow map";
  EXPECT_EQ(running(list, {.opaqueTriangles = 1, .litOpaque = true, .shadowLight = true}),
            (std::vector<std::string>{"shadow", "gbuffer", "lighting", "tonemap"}));
  EXPECT_EQ(running(list, {.transparentTriangles = 1}),
            (std::vector<std::string>{"oit.count", "oit.importance", "oit.reserve", "oit.allocate",
                                      "oit.capture", "oit.resolve", "tonemap"}));
  const OitPlan blend{.method = &methodById("blend")};
  EXPECT_EQ(running(makeFrameList(settings, blend, kFullRate), {.transparentTriangles = 1}),
            (std::vector<std::string>{"oit.blend", "tonemap"}));
}

TEST(FrameList, ReleasesWhatAMethodDoesNotUse) {
  const RenderSettings settings;
  const OitPlan exact = sized({.method = &methodById("ab-sbuffer")});
  const auto needed =
      makeFrameList(settings, exact, kFullRate).neededResources(sized({.transparentTriangles = 1}));
  EXPECT_THAT(needed, testing::Contains(&kFragmentKeys));
  EXPECT_THAT(needed, testing::Not(testing::Contains(&kImportance)));
  EXPECT_THAT(needed, testing::Not(testing::Contains(&kFragmentLinks)));
  EXPECT_THAT(needed, testing::Not(testing::Contains(&kShadowMap)));
}

/// Includes of the sources in a folder, as "file: included".
std::vector<std::string> includesOf(const std::string& folder) {
  std::vector<std::string> found;
  const std::regex include(R"re(#include\s+"([^"]+)")re");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(
           std::filesystem::path(MACULA_SOURCE_DIR) / folder)) {
    const std::string extension = entry.path().extension();
    if (extension != ".cpp" && extension != ".h") continue;
    const std::string text = readTextFile(entry.path());
    for (std::sregex_iterator it(text.begin(), text.end(), include), end; it != end; ++it) {
      found.push_back(entry.path().filename().string() + ": " + (*it)[1].str());
    }
  }
  return found;
}

TEST(Rooms, APassNeverNamesAnotherPass) {
  for (const std::string& line : includesOf("passes")) {
    if (line.find("_pass.h") == std::string::npos) continue;
    // Base classes of many, themselves no passes.
    if (line.ends_with("/oit_pass.h") || line.ends_with("/lod_pass.h")) continue;
    const std::string file = line.substr(0, line.find('.'));
    // The list names all; the settings gather what passes declare as theirs.
    if (file == "frame_list" || file == "render_settings") continue;
    EXPECT_NE(line.find(file + ".h"), std::string::npos) << line;
  }
}

TEST(Rooms, AFeatureNamesNoFactoryButItsOwn) {
  const std::regex factory(R"re((\S+) make\w+Pass\()re");
  int made = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(
           std::filesystem::path(MACULA_SOURCE_DIR) / "passes")) {
    const std::filesystem::path& file = entry.path();
    if (file.extension() != ".cpp" || file.stem() == "frame_list") continue;
    const std::string text = readTextFile(file);
    for (std::sregex_iterator it(text.begin(), text.end(), factory), end; it != end; ++it, ++made) {
      EXPECT_THAT((*it)[1].str(), testing::EndsWith("PassPtr")) << file << ": " << it->str();
    }
  }
  EXPECT_GT(made, 30);
}

}  // namespace
}  // namespace macula::passes
