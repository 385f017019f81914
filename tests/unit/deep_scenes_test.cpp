// The scenes of many layers: hair, greenhouse, hairball, and the ribbons that they are made of.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "engine/scene/load.h"
#include "engine/scene/procedural/ribbon.h"
#include "engine/scene/scene_facts.h"
#include "engine/scene/scene_info.h"
#include "tests/unit/plain_raster.h"

namespace macula::scene {
namespace {

constexpr int kPromisedSize = 1024;  // pixels a side

TEST(Ribbon, HasItsLengthWidthAndFront) {
  // Upwards along y, across along x: cross(x, y) = z is the front.
  const std::array<RibbonPoint, 3> points{RibbonPoint{{0, 0, 0}, {1, 0, 0}, 0.5F},
                                          RibbonPoint{{0, 2, 0}, {1, 0.7F, 0}, 0.5F},
                                          RibbonPoint{{0, 3, 0}, {1, 0, 0}, 0.25F}};
  const glm::vec4 color{0.1F, 0.2F, 0.3F, 0.4F};
  Primitive mesh;
  addRibbon(mesh, points, color);
  ASSERT_EQ(mesh.positions.size(), 6U);
  ASSERT_EQ(mesh.indices.size(), 12U);
  EXPECT_EQ(mesh.positions[0], glm::vec3(-0.5F, 0, 0));
  // The slanted side is straightened: (1, 0.7, 0) less its part along the path is x.
  EXPECT_EQ(mesh.positions[3], glm::vec3(0.5F, 2, 0));
  glm::vec3 doubledArea(0.0F);
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::vec3& a = mesh.positions[mesh.indices[i]];
    doubledArea += glm::cross(mesh.positions[mesh.indices[i + 1]] - a,
                              mesh.positions[mesh.indices[i + 2]] - a);
  }
  EXPECT_EQ(doubledArea, glm::vec3(0, 0, 2.0F * (2.0F + 0.75F)));
  // Rounded: the normals of both rims lean outwards by atan(0.5).
  EXPECT_NEAR(mesh.attributes[0].normal.x, -1.0 / std::sqrt(5.0), 1e-6);
  EXPECT_NEAR(mesh.attributes[1].normal.x, 1.0 / std::sqrt(5.0), 1e-6);
  EXPECT_NEAR(mesh.attributes[1].normal.z, 2.0 / std::sqrt(5.0), 1e-6);
  EXPECT_EQ(mesh.attributes[5].color, color);
}

struct DeepCase {
  const char* name;
  std::uint64_t seed;
  int depth;                   ///< promised at 1024 x 1024
  double leastMega, mostMega;  ///< millions of fragments at 1024 x 1024
  double leastCovered;         ///< share of the frame
};

class DeepScene : public testing::TestWithParam<DeepCase> {};

TEST_P(DeepScene, KeepsItsPromises) {
  const DeepCase& c = GetParam();
  const Scene scene = loadScene(c.name, c.seed);
  const Camera& camera = scene.cameras.at(0);
  const int least = static_cast<int>(std::ceil(0.9 * c.depth));
  const int most = static_cast<int>(std::floor(1.1 * c.depth));

  // Every sixteenth pixel gives the totals and shows where the scene is deepest.
  constexpr int kCoarse = 256;
  constexpr int kRatio = kPromisedSize / kCoarse;
  const plain::DepthCounts coarse = plain::countTransparent(scene, camera, kCoarse);
  EXPECT_LE(coarse.maximum, most);
  const double mega = 1e-6 * kRatio * kRatio * static_cast<double>(coarse.total);
  EXPECT_GE(mega, c.leastMega);
  EXPECT_LE(mega, c.mostMega);
  EXPECT_GE(static_cast<double>(coarse.covered), c.leastCovered * kCoarse * kCoarse);

  // There, the promise is counted at its own size.
  constexpr int kHalf = 32;  // pixels
  plain::PlainView window(camera, kPromisedSize, kPromisedSize);
  window.x0 = std::max(kRatio * coarse.deepestX - kHalf, 0);
  window.y0 = std::max(kRatio * coarse.deepestY - kHalf, 0);
  window.x1 = std::min(kRatio * coarse.deepestX + kHalf, kPromisedSize);
  window.y1 = std::min(kRatio * coarse.deepestY + kHalf, kPromisedSize);
  const plain::DepthCounts fine = plain::countTransparent(scene, window);
  EXPECT_GE(fine.maximum, least);
  EXPECT_LE(fine.maximum, most);
  RecordProperty("maximum", fine.maximum);
  RecordProperty("megafragments", std::to_string(mega));
}

INSTANTIATE_TEST_SUITE_P(Recipes, DeepScene,
                         testing::Values(DeepCase{"hair", 1, 92, 1.5, 2.5, 0.15},
                                         DeepCase{"hair", 99, 92, 1.5, 2.5, 0.15},
                                         DeepCase{"greenhouse", 1, 106, 7.0, 11.0, 0.6},
                                         DeepCase{"greenhouse", 99, 106, 7.0, 11.0, 0.6},
                                         DeepCase{"hairball", 1, 180, 10.0, 14.0, 0.35},
                                         DeepCase{"hairball", 99, 180, 10.0, 14.0, 0.35}),
                         [](const auto& tested) {
                           return std::string(tested.param.name) +
                                  std::to_string(tested.param.seed);
                         });

class DeepSceneMakeUp : public testing::TestWithParam<const char*> {};

TEST_P(DeepSceneMakeUp, IsLitDoubleSidedAndNotTooLarge) {
  const Scene scene = loadScene(GetParam(), 1);
  const SceneInfo info = describe(scene);
  EXPECT_GT(info.transparentTriangles, 100'000U);
  EXPECT_LE(info.triangles, 600'000U);
  const SceneFacts facts = factsOf(scene, false);
  EXPECT_TRUE(facts.litTransparent);
  EXPECT_TRUE(facts.litOpaque);
  EXPECT_TRUE(facts.shadowLight);
  EXPECT_EQ(scene.lights.size(), 4U);
  ASSERT_EQ(scene.cameras.size(), 2U);
  EXPECT_EQ(scene.cameras[1].name, "orbit");
  for (const Material& material : scene.materials) {
    EXPECT_TRUE(!material.isTransparent() || material.doubleSided) << material.name;
  }
}

INSTANTIATE_TEST_SUITE_P(All, DeepSceneMakeUp, testing::Values("hair", "greenhouse", "hairball"),
                         [](const auto& tested) { return std::string(tested.param); });

TEST(Greenhouse, IsDeepAndShallowInManyPlaces) {
  const Scene scene = loadScene("greenhouse", 1);
  // Tiles of 64 pixels a side at 256: the deepest and the shallowest of both sides of the aisle.
  int deepTiles = 0;
  int shallowTiles = 0;
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) {
      plain::PlainView tile(scene.cameras.at(0), 256, 256);
      tile.x0 = 64 * x;
      tile.y0 = 64 * y;
      tile.x1 = tile.x0 + 64;
      tile.y1 = tile.y0 + 64;
      const plain::DepthCounts counts = plain::countTransparent(scene, tile);
      deepTiles += counts.maximum >= 40 ? 1 : 0;
      shallowTiles += counts.total < 4U * 64U * 64U ? 1 : 0;
    }
  }
  EXPECT_GE(deepTiles, 4);
  EXPECT_GE(shallowTiles, 4);
}

}  // namespace
}  // namespace macula::scene
