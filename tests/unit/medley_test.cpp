// The medleys: still lifes of transparent things by number.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

#include "engine/core/error.h"
#include "engine/scene/camera_path.h"
#include "engine/scene/glb_writer.h"
#include "engine/scene/load.h"
#include "engine/scene/procedural/recipes.h"
#include "engine/scene/scene_facts.h"
#include "tests/unit/plain_raster.h"

namespace macula::scene {
namespace {

constexpr int kSeeds = 16;        // that are to show all that medleys are made of
constexpr int kSize = 128;        // pixels a side
constexpr int kDeepest = 150;     // layers
constexpr double kMargin = 1.15;  // depths are kept at another size than they are counted at here
constexpr double kLeastCoverage = 0.18;  // of the frame; less than 20 % for the same reason
const std::set<std::string> kGroupNames{"puffs",  "glass",  "strands", "leaves",
                                        "sheets", "shells", "confetti"};

std::set<std::string> groupsOf(const Scene& scene) {
  std::set<std::string> names;
  for (const Instance& instance : scene.instances) {
    const Material& material = scene.materialOf(scene.primitives[instance.primitive]);
    if (material.isTransparent()) names.insert(material.name);
  }
  return names;
}

TEST(Medley, EqualNumbersGiveEqualBytesWhateverTheSeed) {
  for (const int n : {0, 5, 9999}) {
    const std::string name = "medley-" + std::to_string(n);
    EXPECT_EQ(glbBytes(loadScene(name, 1)), glbBytes(loadScene(name, 2))) << n;
  }
}

TEST(Medley, EveryNumberIsAnotherScene) {
  std::set<std::string> bytes;
  for (int n = 0; n < kSeeds; ++n) bytes.insert(glbBytes(makeMedley(n)));
  EXPECT_EQ(bytes.size(), static_cast<std::size_t>(kSeeds));
}

TEST(Medley, KeepsItsBounds) {
  for (int n = 0; n < kSeeds; ++n) {
    const Scene scene = makeMedley(n);
    EXPECT_EQ(scene.name, "medley-" + std::to_string(n));
    const SceneFacts facts = factsOf(scene, false);
    EXPECT_LE(facts.opaqueTriangles + facts.transparentTriangles, 60'000U) << n;
    EXPECT_GT(facts.opaqueTriangles, 0U) << n;
    EXPECT_LE(scene.lights.size(), 3U) << n;
    const std::set<std::string> groups = groupsOf(scene);
    EXPECT_GE(groups.size(), 2U) << n;
    EXPECT_LE(groups.size(), 5U) << n;
    EXPECT_TRUE(std::includes(kGroupNames.begin(), kGroupNames.end(), groups.begin(), groups.end()))
        << n;
    for (const Primitive& primitive : scene.primitives) {
      for (const VertexAttributes& vertex : primitive.attributes) {
        ASSERT_EQ(vertex.color, glm::clamp(vertex.color, 0.0F, 1.0F)) << n;
      }
    }
  }
}

TEST(Medley, AFewOfThemCoverWhatTransparentScenesAre) {
  std::set<std::string> groups;
  int shallowest = kDeepest;
  int deepest = 0;
  int unlit = 0;
  double least = 1.0;
  double most = 0.0;
  for (int n = 0; n < kSeeds; ++n) {
    const Scene scene = makeMedley(n);
    groups.merge(groupsOf(scene));
    unlit += scene.lights.empty() ? 1 : 0;
    const plain::DepthCounts counts = plain::countTransparent(scene, scene.cameras.at(0), kSize);
    const double coverage = static_cast<double>(counts.covered) / (kSize * kSize);
    EXPECT_GE(counts.maximum, 5) << n;
    EXPECT_LE(counts.maximum, kDeepest * kMargin) << n;
    EXPECT_GT(coverage, kLeastCoverage) << n;
    shallowest = std::min(shallowest, counts.maximum);
    deepest = std::max(deepest, counts.maximum);
    least = std::min(least, coverage);
    most = std::max(most, coverage);
  }
  EXPECT_EQ(groups, kGroupNames);
  EXPECT_LE(shallowest, 10);
  EXPECT_GE(deepest, 80);
  EXPECT_LE(least, 0.4);
  EXPECT_GE(most, 0.9);
  EXPECT_GT(unlit, 0);
  EXPECT_LT(unlit, kSeeds / 2);
}

TEST(Medley, SparseOnesAreFilled) {
  // The groups that are drawn for it at first cover 15 % of the frame.
  constexpr int kSparse = 90;
  const Scene scene = makeMedley(kSparse);
  const plain::DepthCounts counts = plain::countTransparent(scene, scene.cameras.at(0), kSize);
  EXPECT_GT(static_cast<double>(counts.covered) / (kSize * kSize), kLeastCoverage);
}

TEST(Medley, AnOrbitGoesAroundTheMiddle) {
  const Scene scene = makeMedley(1);
  const CameraPath orbit = autoOrbit(scene);
  const Camera first = orbit.at(0.0);
  EXPECT_LT(glm::distance(first.position, scene.cameras.at(0).position), 1e-3F);
  for (const double time : {2.0, 5.0, 9.0}) {
    EXPECT_EQ(orbit.at(time).target, scene.cameras.at(0).target);
    EXPECT_GT(plain::countTransparent(scene, orbit.at(time), kSize).covered, kSize * kSize / 10U);
  }
}

TEST(Medley, ExplainsWrongNumbers) {
  for (const char* name : {"medley-", "medley-x", "medley-10000", "medley--1", "medley--0",
                           "medley-3x", "medley-99999999999999999999"}) {
    try {
      (void)loadScene(name, 0);
      ADD_FAILURE() << name;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("choose 0 to 9999, for example medley-7"),
                std::string::npos)
          << error.what();
    }
  }
}

}  // namespace
}  // namespace macula::scene
