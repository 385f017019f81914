// Experiment files: what they may say, and where they are wrong.
#include <gtest/gtest.h>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "experiment_builder.h"

namespace macula::experiment {
namespace {

std::string messageOf(const std::string& text) {
  try {
    (void)parseExperiment(text, "x.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ExperimentParse, ASmallFileIsOneStudy) {
  const Experiment e = parseExperiment(kSmall, "x.toml");
  EXPECT_EQ(e.title, "Small");
  ASSERT_EQ(e.studies.size(), 1U);
  const Study& study = e.studies[0];
  EXPECT_EQ(study.sizes, (std::vector<Size>{{64, 48}}));
  EXPECT_EQ(study.seeds, std::vector<std::int64_t>{1});
  EXPECT_EQ(study.lights, std::vector<std::string>{"own"});
  EXPECT_EQ(study.variants, (std::vector<std::string>{"exact", "limited"}));
  ASSERT_EQ(study.budgets.size(), 2U);
  EXPECT_EQ(study.budgets[0].label(), "k_ave 2");
  EXPECT_EQ(study.budgets[1].label(), "share 0.3");
  EXPECT_EQ(e.variant("limited").label, "k-buffer");
  EXPECT_EQ(e.variant("exact").label, "exact");
}

TEST(ExperimentParse, AStudyInheritsAndReplaces) {
  const Experiment e = parseExperiment(kSmall + R"(
[settings]
tonemap.exposure = 1.0
[[study]]
id = "a"
scenes = ["smoke"]
variants = ["exact"]
settings = { tonemap.exposure = 2.0 }
[[study]]
id = "b"
frames = 3
)",
                                       "x.toml");
  ASSERT_EQ(e.studies.size(), 2U);
  EXPECT_EQ(e.studies[0].scenes, std::vector<std::string>{"smoke"});
  EXPECT_EQ(e.studies[0].settings.size(), 2U);
  EXPECT_EQ(e.studies[1].scenes.size(), 2U);
  EXPECT_EQ(e.studies[1].settings.size(), 1U);
  EXPECT_EQ(e.studies[1].frames, 3);
}

TEST(ExperimentParse, TargetsAreRead) {
  const Experiment e = parseExperiment(kSmall + R"(
[[target]]
name = "fast"
papers = "8.1 times"
kind = "ratio"
metric = "ms.transparency"
of = "limited"
against = ["exact"]
limit = "<= 1.25"
)",
                                       "x.toml");
  ASSERT_EQ(e.targets.size(), 1U);
  EXPECT_EQ(e.targets[0].kind, Target::Kind::Ratio);
  EXPECT_EQ(e.targets[0].bound, Target::Bound::AtMost);
  EXPECT_DOUBLE_EQ(e.targets[0].limit, 1.25);
  EXPECT_EQ(e.targets[0].limitText(), "<= 1.25");
}

TEST(ExperimentParse, FramesAlongThePathAreOffUntilAskedFor) {
  const Study plain = parseExperiment(kSmall, "x.toml").studies[0];
  EXPECT_EQ(plain.pathFrames, 0);
  EXPECT_DOUBLE_EQ(plain.pathFps, 15.0);
  EXPECT_FALSE(plain.flipMaps);
  const std::string asked =
      smallWith("sizes =",
                "path_frames = 12\npath_fps = 30\nflip_maps = true\noptional_scenes = "
                "[\"a.glb\"]\nsizes =");
  const Study study = parseExperiment(asked, "x.toml").studies[0];
  EXPECT_EQ(study.pathFrames, 12);
  EXPECT_DOUBLE_EQ(study.pathFps, 30.0);
  EXPECT_TRUE(study.flipMaps);
}

TEST(ExperimentParse, OptionalScenesStandBehindTheOthers) {
  const std::string text =
      smallWith("sizes =", "optional_scenes = [\"a.glb\", \"b.glb\"]\nsizes =") + R"(
[[study]]
id = "own"
optional_scenes = ["c.glb"]
[[study]]
id = "inherits"
[[target]]
name = "t"
kind = "mean"
metric = "rmse"
of = "limited"
against = "exact"
limit = "<= 0.68"
scenes = ["smoke", "c.glb"]
)";
  const Experiment e = parseExperiment(text, "x.toml");
  EXPECT_EQ(e.studies[0].scenes, (std::vector<std::string>{"smoke", "bottles", "c.glb"}));
  EXPECT_EQ(e.studies[1].scenes, (std::vector<std::string>{"smoke", "bottles", "a.glb", "b.glb"}));
  EXPECT_TRUE(e.studies[1].isOptional("b.glb"));
  EXPECT_FALSE(e.studies[1].isOptional("smoke"));
  EXPECT_EQ(e.targets[0].kind, Target::Kind::Mean);
  EXPECT_EQ(e.targets[0].limitText(), "mean <= 0.68");
}

TEST(ExperimentParse, AStudyMayHaveNothingButOptionalScenes) {
  const std::string text =
      smallWith("scenes = [\"smoke\", \"bottles\"]", "optional_scenes = [\"a.glb\"]");
  EXPECT_EQ(parseExperiment(text, "x.toml").studies[0].scenes, std::vector<std::string>{"a.glb"});
}

struct Fault {
  const char* part;
  const char* by;
  const char* place;
  const char* word;
};

class ExperimentFault : public testing::TestWithParam<Fault> {};

TEST_P(ExperimentFault, NamesPlaceAndFix) {
  const std::string message = messageOf(smallWith(GetParam().part, GetParam().by));
  EXPECT_EQ(message.rfind(GetParam().place, 0), 0U) << message;
  EXPECT_NE(message.find(GetParam().word), std::string::npos) << message;
}

INSTANTIATE_TEST_SUITE_P(
    Faults, ExperimentFault,
    testing::Values(
        Fault{"scenes =", "scene =", "x.toml:2:", "'scenes'"},
        Fault{"title = \"Small\"", "", "x.toml:1:", "title"},
        Fault{"\"64x48\"", "\"64\"", "x.toml:3:", "WIDTHxHEIGHT"},
        Fault{"\"64x48\"", "\"0x48\"", "x.toml:3:", "WIDTHxHEIGHT"},
        Fault{"{ k_ave = 2 }", "{ k_ave = 0 }", "x.toml:4:", "k_ave"},
        Fault{"{ k_ave = 2 }", "{ k_ave = 2, mib = 3 }", "x.toml:4:", "one of"},
        Fault{"{ share = 0.3 }", "{ k_ave = 2.0 }", "x.toml:1:", "k_ave 2"},
        Fault{"\"64x48\"", "\"64x48\", \"64x48\"", "x.toml:1:", "twice"},
        Fault{"sizes =", "seeds = [4, 4]\nsizes =", "x.toml:1:", "twice"},
        Fault{"{ k_ave = 2 }", "{ kave = 2 }", "x.toml:4:", "k_ave"},
        Fault{"{ share = 0.3 }", "{ share = 1.5 }", "x.toml:4:", "share"},
        Fault{"{ share = 0.3 }", "{ share = 30 }", "x.toml:4:", "; write 0.3 for 30 %"},
        Fault{"{ share = 0.3 }", "{ share = '30%' }", "x.toml:4:", "; write 0.3 for 30 %"},
        Fault{"{ k_ave = 2 }", "{ k_ave = 2, scenes = [\"smok\"] }", "x.toml:1:", "smoke"},
        Fault{"budgets = [{ k_ave = 2 }, { share = 0.3 }]", "", "x.toml:1:", "limited"},
        Fault{"id = \"limited\"", "id = \"exact\"", "x.toml:10:", "twice"},
        Fault{"id = \"exact\"", "id = \"a b\"", "x.toml:6:", "letters"},
        Fault{"id = \"exact\"\n", "", "x.toml:6:", "id"},
        Fault{"label = ", "lable = ", "x.toml:12:", "'label'"},
        Fault{"label = \"k-buffer\"", "oracle = \"optimal\"", "x.toml:12:", "optimal-k"},
        Fault{"label = \"k-buffer\"", "oracle = \"optimal-k\"", "x.toml:10:", "no settings"},
        Fault{"sizes =", "frames = 0\nsizes =", "x.toml:3:", "frames"},
        Fault{"sizes =", "path_frames = 1\nsizes =", "x.toml:3:", "2 or more"},
        Fault{"sizes =", "path_frames = -1\nsizes =", "x.toml:3:", "path_frames"},
        Fault{"sizes =", "path_frames = 2.5\nsizes =", "x.toml:3:", "path_frames"},
        Fault{"sizes =", "path_frame = 2\nsizes =", "x.toml:3:", "'path_frames'"},
        Fault{"sizes =", "path_fps = 0\nsizes =", "x.toml:3:", "path_fps"},
        Fault{"sizes =", "flip_maps = 2\nsizes =", "x.toml:3:", "true or false"},
        Fault{"sizes =", "optional_scenes = \"a.glb\"\nsizes =", "x.toml:3:", "optional_scenes"},
        Fault{"sizes =", "optional_scenes = [\"smoke\"]\nsizes =", "x.toml:1:", "twice"},
        Fault{"sizes =", "compare = [[\"exakt\"]]\nsizes =", "x.toml:1:", "exact"},
        Fault{"[[variant]]", "[[target]]\nname = \"t\"\n[[variant]]", "x.toml:6:", "kind"},
        Fault{"[[variant]]",
              "[[target]]\nname = \"t\"\nkind = \"value\"\nmetric = \"rsme\"\nof = \"exact\"\n"
              "limit = \"<= 1\"\n[[variant]]",
              "x.toml:9:", "rmse"},
        Fault{"[[variant]]",
              "[[target]]\nname = \"t\"\nkind = \"value\"\nmetric = \"rmse\"\nof = \"exact\"\n"
              "limit = \"< 1\"\n[[variant]]",
              "x.toml:11:", "<= 1.25"},
        Fault{"budgets = true\n", "budgets = 'yes'\n", "x.toml:14:", "true or false"}));

TEST(ExperimentParse, BooleansAreThoseOfTheCommandLine) {
  for (const char* on : {"true", "1", "\"on\"", "'true'"}) {
    const std::string text = smallWith("sizes =", std::string("flip_maps = ") + on + "\nsizes =");
    EXPECT_TRUE(parseExperiment(text, "x.toml").studies[0].flipMaps) << on;
  }
  for (const char* off : {"0", "\"off\""}) {
    const std::string text = smallWith("sizes =", std::string("flip_maps = ") + off + "\nsizes =");
    EXPECT_FALSE(parseExperiment(text, "x.toml").studies[0].flipMaps) << off;
  }
}

TEST(ExperimentParse, MorePointsThanAnybodyWaitsForAreRefused) {
  std::string seeds = "seeds = [0";
  for (int i = 1; i < 20000; ++i) seeds += "," + std::to_string(i);
  EXPECT_NE(messageOf(smallWith("sizes =", seeds + "]\nsizes =")).find("100000"),
            std::string::npos);
}

TEST(ExperimentParse, ReadyMadeExperimentsAreWhole) {
  for (const char* name : {"quick", "papers", "lod", "learned"}) {
    const std::string path =
        std::string(MACULA_SOURCE_DIR) + "/assets/experiments/" + name + ".toml";
    const Experiment e = parseExperiment(readTextFile(path), path);
    EXPECT_FALSE(e.targets.empty()) << name;
    EXPECT_FALSE(expand(e, {}).empty()) << name;
  }
}

}  // namespace
}  // namespace macula::experiment
