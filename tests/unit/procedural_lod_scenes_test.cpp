// The scenes whose pixels are expensive: car, marble, chess; and the grids of points they are made
// of.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "engine/scene/camera_path.h"
#include "engine/scene/glb_writer.h"
#include "engine/scene/gltf_loader.h"
#include "engine/scene/load.h"
#include "engine/scene/procedural/patch.h"
#include "engine/scene/procedural/recipes.h"
#include "engine/scene/scene_facts.h"
#include "engine/scene/scene_info.h"
#include "tests/unit/plain_raster.h"

namespace macula::scene {
namespace {

TEST(Patch, FacesTheProductOfColumnsAndRows) {
  Patch patch(2, 2);
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      patch.at(i, j).position = {static_cast<float>(j), static_cast<float>(i), 0.0F};
    }
  }
  Primitive mesh;
  addPatch(mesh, patch);
  ASSERT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(mesh.positions[2], glm::vec3(1, 1, 0));
  for (const VertexAttributes& vertex : mesh.attributes) {
    EXPECT_EQ(vertex.normal, glm::vec3(0, 0, 1));
  }
}

TEST(Patch, LeavesOutWhatIsNotChosenOrHasNoArea) {
  // A fan of two cells: all points of the first row coincide.
  Patch patch(2, 3);
  for (int j = 0; j < 3; ++j) patch.at(1, j).position = {static_cast<float>(j), 1.0F, 0.0F};
  Primitive fan;
  addPatch(fan, patch);
  EXPECT_EQ(fan.indices.size(), 6U);
  Primitive half;
  addPatch(half, patch, [](int, int column) { return column == 1; });
  EXPECT_EQ(half.indices.size(), 3U);
  EXPECT_EQ(half.positions.size(), 3U) << "no vertices that nothing uses";
}

TEST(Patch, RingsAreSmoothAcrossTheirSeam) {
  // A square pipe along z: every corner's normal lies between both sides', the seam's too.
  const std::array<glm::vec2, 5> square{{{1, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
  Patch patch(2, 5);
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 5; ++j) {
      const glm::vec2 p = square[static_cast<std::size_t>(j)];
      patch.at(i, j).position = {p.x, p.y, static_cast<float>(i)};
    }
  }
  Primitive mesh;
  addPatch(mesh, patch);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::vec3& n = mesh.attributes[i].normal;
    const bool atSeam = mesh.positions[i].x == 1.0F && mesh.positions[i].y == -1.0F;
    if (!atSeam) continue;
    // Three triangles of one side and three of the other meet in each end's two seam points.
    EXPECT_GT(n.x, 0.4F);
    EXPECT_LT(n.y, -0.4F);
  }
}

TEST(Curves, GoThroughTheirKeysWithoutOvershooting) {
  const std::array<glm::vec2, 4> keys{{{0, 0}, {1, 1}, {2, 1}, {4, 0}}};
  EXPECT_EQ(curveAt(keys, -3.0F), 0.0F);
  EXPECT_EQ(curveAt(keys, 9.0F), 0.0F);
  for (const glm::vec2& key : keys) EXPECT_NEAR(curveAt(keys, key.x), key.y, 1e-6F);
  EXPECT_NEAR(curveAt(keys, 1.5F), 1.0F, 1e-6F);
  // By hand: slopes 1, 0, so tangents 1 at 0 and 0 at 1: at 1/2 (1/8) 1 + (1/2) 1 = 0.625.
  EXPECT_NEAR(curveAt(keys, 0.5F), 0.625F, 1e-6F);
  for (int i = 0; i <= 400; ++i) {
    const float y = curveAt(keys, 0.01F * static_cast<float>(i));
    EXPECT_GE(y, 0.0F);
    EXPECT_LE(y, 1.0F + 1e-6F);
  }
  const glm::vec3 middle = splineBetween({0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 1, 0}, 0.5F);
  EXPECT_EQ(middle, glm::vec3(1.5F, 0.5F, 0.0F));
  EXPECT_EQ(splineBetween({7, 7, 7}, {1, 2, 3}, {4, 5, 6}, {8, 8, 8}, 1.0F), glm::vec3(4, 5, 6));
}

class LodScene : public testing::TestWithParam<const char*> {
 protected:
  Scene scene_ = loadScene(GetParam(), 3);
};

TEST_P(LodScene, IsOpaqueLitAndHasFewTriangles) {
  const SceneInfo info = describe(scene_);
  EXPECT_GT(info.triangles, 20'000U);
  EXPECT_LE(info.triangles, 40'000U);
  EXPECT_EQ(info.transparentTriangles, 0U);
  EXPECT_EQ(info.maskTriangles, 0U);
  const SceneFacts facts = factsOf(scene_, false);
  EXPECT_TRUE(facts.litOpaque);
  EXPECT_FALSE(facts.unlitOpaque);
  EXPECT_TRUE(facts.shadowLight);
}

TEST_P(LodScene, FillsTheViewFromBothItsCameras) {
  ASSERT_EQ(scene_.cameras.size(), 2U);
  EXPECT_EQ(scene_.cameras[0].name, "scene");
  EXPECT_EQ(scene_.cameras[1].name, "orbit");
  constexpr int kSize = 128;
  for (const Camera& camera : {scene_.cameras[0], autoOrbit(scene_).at(0.0)}) {
    const plain::PlainView view(camera, kSize, kSize);
    std::vector<double> depth(static_cast<std::size_t>(kSize) * kSize, 0.0);
    plain::drawScene(
        scene_, view, [](const Material&) { return true; },
        [&](const Instance&, std::size_t, const plain::Hit& hit) {
          depth[static_cast<std::size_t>(hit.y * kSize + hit.x)] = hit.depth;
          EXPECT_LT(hit.depth, static_cast<double>(camera.farPlane));
        });
    const auto empty = std::count(depth.begin(), depth.end(), 0.0);
    EXPECT_LT(static_cast<double>(empty), 0.01 * kSize * kSize);
    RecordProperty("empty", static_cast<int>(empty));
  }
}

TEST_P(LodScene, KeepsWhatItAsksForInAFile) {
  const std::string bytes = glbBytes(scene_);
  const Scene back = loadGltfFromMemory(std::as_bytes(std::span(bytes)), {}, "back");
  EXPECT_TRUE(back.warnings.empty());
  const SceneFacts before = factsOf(scene_, false);
  const SceneFacts after = factsOf(back, false);
  EXPECT_EQ(after.opaqueTriangles, before.opaqueTriangles);
  EXPECT_EQ(after.shadowTaps, before.shadowTaps);
  EXPECT_EQ(after.veins, before.veins);
  EXPECT_EQ(after.occlusion.radius, before.occlusion.radius);
  EXPECT_EQ(after.occlusion.samples, before.occlusion.samples);
}

TEST_P(LodScene, DiffersWithTheSeed) {
  const Scene other = loadScene(GetParam(), 4);
  EXPECT_NE(glbBytes(scene_), glbBytes(other));
  EXPECT_LE(describe(other).triangles, 40'000U);
}

INSTANTIATE_TEST_SUITE_P(All, LodScene, testing::Values("car", "marble", "chess"),
                         [](const auto& tested) { return std::string(tested.param); });

int veinedMaterials(const Scene& scene) {
  return static_cast<int>(std::count_if(scene.materials.begin(), scene.materials.end(),
                                        [](const Material& m) { return m.veins.any(); }));
}

TEST(Car, HasWideShadowsAndNothingElseThatIsDear) {
  const Scene scene = makeCar(1);
  const SceneFacts facts = factsOf(scene, false);
  EXPECT_EQ(facts.shadowTaps, 9);
  EXPECT_EQ(veinedMaterials(scene), 0);
  EXPECT_FALSE(facts.occlusion.any());
  // The livery tells one side from the other: its halves are not mirror images.
  const auto& images = scene.images;
  const auto livery = std::find_if(images.begin(), images.end(),
                                   [](const Image& image) { return image.name == "livery"; });
  ASSERT_NE(livery, images.end());
  const auto row = [&](int y) {
    return std::span(livery->rgba)
        .subspan(static_cast<std::size_t>(y * livery->width) * 4,
                 static_cast<std::size_t>(livery->width) * 4);
  };
  const int y = livery->height / 10;  // on the doors
  EXPECT_FALSE(std::ranges::equal(row(y), row(livery->height - 1 - y)));
}

TEST(Marble, HasVeinsUnderAGlossAndUsualShadows) {
  const Scene scene = makeMarble(1);
  EXPECT_EQ(factsOf(scene, false).shadowTaps, kUsualShadowTaps);
  EXPECT_FALSE(scene.occlusion.any());
  EXPECT_GE(veinedMaterials(scene), 4);
  EXPECT_LE(veinedMaterials(scene), kMostVeins);
  // From its camera most pixels are veined stone, and much of it is the polished dragon.
  constexpr int kSize = 128;
  const plain::PlainView view(scene.cameras.at(0), kSize, kSize);
  struct Nearest {
    double depth = 1e9;
    const Material* material = nullptr;
  };
  std::vector<Nearest> nearest(static_cast<std::size_t>(kSize) * kSize);
  plain::drawScene(
      scene, view, [](const Material&) { return true; },
      [&](const Instance& instance, std::size_t, const plain::Hit& hit) {
        Nearest& pixel = nearest[static_cast<std::size_t>(hit.y * kSize + hit.x)];
        if (hit.depth >= pixel.depth) return;
        pixel = {hit.depth, &scene.materialOf(scene.primitives[instance.primitive])};
      });
  int veined = 0;
  int dragon = 0;
  for (const Nearest& pixel : nearest) {
    if (pixel.material == nullptr) continue;
    veined += pixel.material->veins.any() ? 1 : 0;
    const bool isDragon = pixel.material->name == "dragon" || pixel.material->name == "wings";
    dragon += isDragon ? 1 : 0;
    if (!isDragon) continue;
    EXPECT_GE(pixel.material->roughness, 0.25F);
    EXPECT_LE(pixel.material->roughness, 0.35F);
  }
  EXPECT_GT(veined, 9 * kSize * kSize / 10);
  EXPECT_GT(dragon, kSize * kSize / 5);
}

TEST(Chess, HasOcclusionUnderStrongAmbientLight) {
  const Scene scene = makeChess(1);
  EXPECT_EQ(scene.occlusion.samples, 96);
  EXPECT_GT(scene.occlusion.radius, 0.01F);
  EXPECT_LT(scene.occlusion.radius, 0.055F) << "less than a square of the board";
  EXPECT_GT(scene.ambient.g, 0.4F);
  EXPECT_EQ(factsOf(scene, false).shadowTaps, kUsualShadowTaps);
  EXPECT_EQ(veinedMaterials(scene), 0);
  // 32 pieces, on the board or taken.
  const auto pieces =
      std::count_if(scene.instances.begin(), scene.instances.end(), [&](const Instance& instance) {
        const std::string& name = scene.materialOf(scene.primitives[instance.primitive]).name;
        return name == "ivory" || name == "ebony";
      });
  EXPECT_EQ(pieces, 32);
}

}  // namespace
}  // namespace macula::scene
