// Sweeps: what a file may say of them, the points they make, and targets that name them.
#include <gtest/gtest.h>

#include <set>

#include "engine/core/error.h"
#include "engine/experiment/point.h"
#include "experiment_builder.h"

namespace macula::experiment {
namespace {

const std::string kSwept = R"(title = "Swept"
scenes = ["smoke"]
base = "full"

[[variant]]
id = "full"

[[variant]]
id = "plain"
label = "tent"
sweep = { "lod.r" = [1.25, 2, 4] }

[[variant]]
id = "better"
sweep = { lod.r = [2, 3] }

[[target]]
name = "above"
kind = "curve"
metric = "psnr_db"
of = "better"
against = "plain"
limit = "> 0"
)";

std::string sweptWith(const std::string& part, const std::string& by) {
  std::string text = kSwept;
  const std::size_t at = text.find(part);
  return at == std::string::npos ? "no such part" : text.replace(at, part.size(), by);
}

TEST(ExperimentSweep, BothWaysOfWritingAKeyMeanTheSame) {
  const Experiment e = parseExperiment(kSwept, "x.toml");
  EXPECT_EQ(e.variant("plain").sweep.value().setting, "lod.r");
  EXPECT_EQ(e.variant("better").sweep.value().setting, "lod.r");
  EXPECT_EQ(e.variant("plain").sweep->values, (std::vector<double>{1.25, 2.0, 4.0}));
  EXPECT_EQ(e.variant("plain").labelAt(2.0), "tent r=2");
  EXPECT_EQ(e.variant("plain").labelAt(std::nullopt), "tent");
  EXPECT_EQ(e.variant("plain").sweep->place, "x.toml:11");
  EXPECT_FALSE(e.variant("full").sweep);
}

TEST(ExperimentSweep, EveryValueIsAPointOfOneBatch) {
  const Experiment e = parseExperiment(kSwept, "x.toml");
  const auto groups = expand(e, {});
  ASSERT_EQ(groups.size(), 1U);
  ASSERT_EQ(groups[0].batches.size(), 1U) << "curves are interleaved with the base";
  const auto& points = groups[0].batches[0].points;
  ASSERT_EQ(points.size(), 6U);
  EXPECT_FALSE(points[0].value);
  EXPECT_EQ(points[1].value, 1.25);
  EXPECT_NE(points[1].stem.find("plain_r-1.25_"), std::string::npos) << points[1].stem;
  const Point point = startPoint(e, groups[0], groups[0].batches[0], points[2], kMeasured);
  EXPECT_EQ(point["sweep"], 2.0);
  EXPECT_EQ(point["label"], "tent r=2");
  EXPECT_EQ(point["variant"], "plain");
}

TEST(ExperimentSweep, ValuesAndViewersDecideKeys) {
  const auto keysOf = [](const std::string& text) {
    std::set<std::string> keys;
    const auto groups = expand(parseExperiment(text, "x.toml"), {});
    for (const PointPlan& point : groups[0].batches[0].points) {
      keys.insert(point.key);
    }
    return keys;
  };
  const auto first = keysOf(kSwept);
  EXPECT_EQ(first.size(), 6U);
  EXPECT_EQ(first, keysOf(sweptWith("\"tent\"", "\"tents\"")));
  for (const auto& [part, by] :
       {std::pair{"[2, 3]", "[2, 3.5]"}, {"base =", "pixels_per_degree = 45\nbase ="}}) {
    for (const std::string& key : keysOf(sweptWith(part, by))) EXPECT_FALSE(first.contains(key));
  }
}

TEST(ExperimentSweep, TheViewerIsTheOneOfFlipUnlessSaid) {
  EXPECT_DOUBLE_EQ(parseExperiment(kSwept, "x").studies[0].pixelsPerDegree, 67.0206);
  const auto e = parseExperiment(sweptWith("base =", "pixels_per_degree = 45\nbase ="), "x");
  EXPECT_DOUBLE_EQ(e.studies[0].pixelsPerDegree, 45.0);
}

struct Fault {
  const char* part;
  const char* by;
  const char* place;
  const char* word;
};

class SweepFault : public testing::TestWithParam<Fault> {};

TEST_P(SweepFault, NamesPlaceAndFix) {
  try {
    (void)parseExperiment(sweptWith(GetParam().part, GetParam().by), "x.toml");
    FAIL() << "no error";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.rfind(GetParam().place, 0), 0U) << message;
    EXPECT_NE(message.find(GetParam().word), std::string::npos) << message;
  }
}

constexpr const char* kTwoSettings = "{ lod.r = [2, 3], oit.kAve = [1] }";
constexpr const char* kManyValues =
    "[1.01, 1.02, 1.03, 1.04, 1.05, 1.06, 1.07, 1.08, 1.09, 1.1, 1.11, 1.12, 1.13]";

INSTANTIATE_TEST_SUITE_P(
    Faults, SweepFault,
    testing::Values(
        Fault{"{ lod.r = [2, 3] }", kTwoSettings, "x.toml:15:", "one setting"},
        Fault{"{ lod.r = [2, 3] }", "{}", "x.toml:15:", "one setting"},
        Fault{"{ lod.r = [2, 3] }", "[2, 3]", "x.toml:15:", "table"},
        Fault{"[2, 3]", "3", "x.toml:15:", "one setting"},
        Fault{"[2, 3]", "[]", "x.toml:15:", "one setting"},
        Fault{"[2, 3]", "[2, \"3\"]", "x.toml:15:", "finite number"},
        Fault{"[2, 3]", "[2, inf]", "x.toml:15:", "finite number"},
        Fault{"[2, 3]", "[2, 2.0]", "x.toml:15:", "twice"},
        Fault{"[2, 3]", kManyValues, "x.toml:1:", "compare"},
        Fault{"sweep = { lod.r = [2, 3] }", "sweep = { lod.r = [2, 3] }\nbudgets = true",
              "x.toml:15:", "one of the two"},
        Fault{"base = \"full\"", "base = \"ful\"", "x.toml:1:", "'full'"},
        Fault{"base = \"full\"", "base = \"plain\"", "x.toml:1:", "one point"},
        Fault{"base = \"full\"", "base = \"full\"\ncompare = [[\"plain\", \"better\"]]",
              "x.toml:1:", "interleave"},
        Fault{"base =", "pixels_per_degree = 0\nbase =", "x.toml:3:", "1 to 1000"},
        Fault{"against = \"plain\"", "against = \"full\"", "x.toml:22:", "no sweep"},
        Fault{"against = \"plain\"", "against = [\"plain\", \"better\"]",
              "x.toml:22:", "one variant"},
        Fault{"\"psnr_db\"", "\"rmse\"", "x.toml:20:", "psnr_db"},
        Fault{"limit = ", "at = 2\nlimit = ", "x.toml:23:", "'at'"},
        Fault{"limit = ", "statistic = \"most\"\nlimit = ", "x.toml:23:", "least, mean"},
        Fault{"limit = ", "cost = \"ms.totl\"\nlimit = ", "x.toml:23:", "ms.total"},
        Fault{"\"> 0\"", "\"=> 0\"", "x.toml:23:", "> 0"},
        Fault{"\"curve\"", "\"ratio\"\nat = 5", "x.toml:20:", "2, 3"},
        Fault{"\"curve\"\nmetric = \"psnr_db\"\nof = \"better\"\nagainst = \"plain\"",
              "\"ratio\"\nmetric = \"ms.total\"\nof = \"full\"\nagainst = \"plain\"",
              "x.toml:22:", "against_at = 1.25"},
        Fault{"\"curve\"\nmetric = \"psnr_db\"\nof = \"better\"\nagainst = \"plain\"",
              "\"value\"\nmetric = \"ms.total\"\nof = \"full\"\nat = 2",
              "x.toml:22:", "leave it out"}));

TEST(ExperimentSweep, CompareAllowsManyRenderers) {
  const std::string text = sweptWith("[2, 3]", kManyValues);
  EXPECT_THROW((void)parseExperiment(text, "x"), InputError);
  const std::string asked = "compare = [[\"full\", \"plain\", \"better\"]]\nbase = \"full\"";
  const Experiment e =
      parseExperiment(std::string(text).replace(text.find("base = \"full\""), 13, asked), "x");
  const auto groups = expand(e, {});
  ASSERT_EQ(groups[0].batches.size(), 1U);
  EXPECT_EQ(groups[0].batches[0].points.size(), 17U);
}

}  // namespace
}  // namespace macula::experiment
