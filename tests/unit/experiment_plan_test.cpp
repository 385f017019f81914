// The expansion of an experiment, its keys, and the file that keeps finished points.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "engine/core/file.h"
#include "engine/experiment/points_file.h"
#include "experiment_builder.h"

namespace macula::experiment {
namespace {

std::vector<Group> expandText(const std::string& text, const Fingerprint& fingerprint = {}) {
  return expand(parseExperiment(text, "x.toml"), fingerprint);
}

std::set<std::string> keysOf(const std::vector<Group>& groups) {
  std::set<std::string> keys;
  for (const Group& group : groups) {
    for (const Batch& batch : group.batches) {
      for (const PointPlan& point : batch.points) keys.insert(point.key);
    }
  }
  return keys;
}

TEST(ExperimentPlan, EveryVariantMeetsItsBudgets) {
  const auto groups = expandText(kSmall);
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].scene, "smoke");
  ASSERT_EQ(groups[0].batches.size(), 1U) << "few points are interleaved in one batch";
  EXPECT_EQ(groups[0].batches[0].points.size(), 3U);
  EXPECT_EQ(keysOf(groups).size(), 6U) << "every key is its own";
}

TEST(ExperimentPlan, ManyPointsTakeTurnsByBudget) {
  std::string budgets = "budgets = [";
  for (int k = 1; k <= 16; ++k) budgets += "{ k_ave = " + std::to_string(k) + " },";
  const auto groups =
      expandText(smallWith("budgets = [{ k_ave = 2 }, { share = 0.3 }]", budgets + "]"));
  ASSERT_EQ(groups[0].batches.size(), 16U);
  EXPECT_EQ(groups[0].batches[0].points.size(), 2U) << "with the variant that has no budget";
  EXPECT_EQ(groups[0].batches[1].points.size(), 1U);
}

TEST(ExperimentPlan, CompareListsAreBatches) {
  const auto groups = expandText(smallWith("sizes =", "compare = [[\"limited\"]]\nsizes ="));
  ASSERT_EQ(groups[0].batches.size(), 2U);
  EXPECT_EQ(groups[0].batches[0].points.size(), 2U) << "both budgets";
  EXPECT_EQ(groups[0].batches[1].points.size(), 1U) << "who was not named stands apart";
}

TEST(ExperimentPlan, ABudgetMayBelongToAScene) {
  const auto groups = expandText(smallWith("{ k_ave = 2 }", "{ k_ave = 2, scenes = [\"smoke\"] }"));
  EXPECT_EQ(groups[0].batches[0].points.size(), 3U);
  EXPECT_EQ(groups[1].batches[0].points.size(), 2U);
}

TEST(ExperimentPlan, OraclesDoNotWalk) {
  const std::string best = "[[variant]]\nid = \"best\"\noracle = \"optimal-k\"\nbudgets = true\n";
  const auto still = expandText(kSmall + best);
  const auto moving = expandText(smallWith("sizes =", "path_frames = 2\nsizes =") + best);
  ASSERT_TRUE(moving[0].batches[1].oracles);
  EXPECT_EQ(moving[0].batches[1].points[0].key, still[0].batches[1].points[0].key);
  EXPECT_NE(moving[0].batches[0].points[0].key, still[0].batches[0].points[0].key);
}

TEST(ExperimentPlan, GroupsOfOptionalScenesSaySo) {
  const auto groups = expandText(smallWith("sizes =", "optional_scenes = [\"a.glb\"]\nsizes ="));
  ASSERT_EQ(groups.size(), 3U);
  EXPECT_FALSE(groups[1].optional);
  EXPECT_EQ(groups[2].scene, "a.glb");
  EXPECT_TRUE(groups[2].optional);
}

TEST(ExperimentPlan, OraclesStandApart) {
  const auto groups =
      expandText(kSmall + "[[variant]]\nid = \"best\"\noracle = \"optimal-k\"\nbudgets = true\n");
  ASSERT_EQ(groups[0].batches.size(), 2U);
  EXPECT_FALSE(groups[0].batches[0].oracles);
  EXPECT_TRUE(groups[0].batches[1].oracles);
  EXPECT_EQ(groups[0].batches[1].points.size(), 2U);
}

/// Whether any point of `a` could stand for one of `b`.
bool share(const std::vector<Group>& a, const std::vector<Group>& b) {
  const auto known = keysOf(a);
  for (const std::string& key : keysOf(b)) {
    if (known.contains(key)) return true;
  }
  return false;
}

TEST(ExperimentPlan, KeysHoldAllThatDecides) {
  const auto first = expandText(kSmall, {"commit a", {}});
  EXPECT_EQ(keysOf(first), keysOf(expandText(kSmall, {"commit a", {}})));
  EXPECT_FALSE(share(first, expandText(kSmall, {"commit b", {}})));
  for (const auto& [part, by] : std::vector<std::pair<const char*, const char*>>{
           {"64x48", "64x64"},
           {"sizes =", "frames = 3\nsizes ="},
           {"sizes =", "camera = \"scene\"\nsizes ="},
           {"sizes =", "seeds = [2]\nsizes ="},
           {"sizes =", "path_frames = 2\nsizes ="},
           {"sizes =", "flip_maps = true\nsizes ="},
           {"sizes =", "settings = { tonemap.exposure = 1 }\nsizes ="},
           {"{ oit.method = \"kb-variable\" }",
            "{ oit.method = \"kb-variable\", oit.fill = true }"},
           {"share = 0.3", "share = 0.4"}}) {
    EXPECT_FALSE(share(first, expandText(smallWith(part, by), {"commit a", {}}))) << by;
  }
  // A rate of no frames decides nothing; of some, it does.
  EXPECT_EQ(keysOf(first),
            keysOf(expandText(smallWith("sizes =", "path_fps = 9\nsizes ="), {"commit a", {}})));
  EXPECT_FALSE(share(expandText(smallWith("sizes =", "path_frames = 2\nsizes =")),
                     expandText(smallWith("sizes =", "path_frames = 2\npath_fps = 9\nsizes ="))));
  const std::string relabelled = smallWith("k-buffer", "another label");
  EXPECT_EQ(keysOf(first), keysOf(expandText(relabelled, {"commit a", {}})));
  Fingerprint changed{"commit a", {{"smoke", "another file"}}};
  const auto half = expandText(kSmall, changed);
  EXPECT_FALSE(share({first[0]}, {half[0]}));
  EXPECT_TRUE(share({first[1]}, {half[1]}));
}

TEST(ExperimentPlan, BytesOfBudgets) {
  EXPECT_DOUBLE_EQ((Budget{Budget::Kind::KAve, 2.0, {}}.bytes(100, 0)), 3200.0);
  EXPECT_DOUBLE_EQ((Budget{Budget::Kind::MiB, 2.0, {}}.bytes(100, 0)), 2097152.0);
  EXPECT_DOUBLE_EQ((Budget{Budget::Kind::Share, 0.5, {}}.bytes(100, 1000)), 8000.0);
}

class PointsFileTest : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(path_); }
  void append(const std::string& bytes) const {
    std::ofstream(path_, std::ios::app | std::ios::binary) << bytes;
  }
  const std::filesystem::path path_ = std::filesystem::path(testing::TempDir()) /
                                      ("macula_points_" + std::to_string(::getpid()) + ".jsonl");
};

TEST_F(PointsFileTest, KeepsWhatWasAppended) {
  {
    PointsFile file(path_);
    EXPECT_EQ(file.find("a"), nullptr);
    file.append(std::vector<Point>{{{"key", "a"}, {"x", 1}}, {{"key", "b"}, {"x", 2}}});
  }
  const PointsFile again(path_);
  ASSERT_NE(again.find("b"), nullptr);
  EXPECT_EQ(again.find("b")->at("x"), 2);
  EXPECT_EQ(again.damagedLines(), 0U);
}

TEST_F(PointsFileTest, ALineCutOffIsLeftOutAndTheNextOneStandsByItself) {
  append("{\"key\":\"a\",\"x\":1}\n{\"key\":\"b\",\"x\"");
  {
    PointsFile file(path_);
    EXPECT_NE(file.find("a"), nullptr);
    EXPECT_EQ(file.find("b"), nullptr);
    EXPECT_EQ(file.damagedLines(), 1U);
    file.append(std::vector<Point>{{{"key", "c"}, {"x", 3}}});
  }
  const PointsFile again(path_);
  EXPECT_NE(again.find("a"), nullptr);
  EXPECT_NE(again.find("c"), nullptr);
  EXPECT_EQ(again.damagedLines(), 0U);
}

TEST_F(PointsFileTest, AWholeLineWithoutItsEndIsNotTrusted) {
  append("{\"key\":\"a\",\"x\":12}");  // the number may go on
  EXPECT_EQ(PointsFile(path_).find("a"), nullptr);
}

}  // namespace
}  // namespace macula::experiment
