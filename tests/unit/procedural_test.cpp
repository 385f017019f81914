#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <string>

#include "engine/core/error.h"
#include "engine/scene/load.h"
#include "engine/scene/procedural/circle.h"
#include "engine/scene/procedural/depth_counter.h"
#include "engine/scene/procedural/mesh_builder.h"
#include "engine/scene/procedural/recipes.h"
#include "engine/scene/procedural/textures.h"
#include "tests/unit/plain_raster.h"

namespace macula::scene {
namespace {

/// The volume of a closed mesh; negative where its triangles face inwards.
double volumeOf(const Primitive& mesh) {
  double sum = 0.0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::dvec3 a(mesh.positions[mesh.indices[i]]);
    const glm::dvec3 b(mesh.positions[mesh.indices[i + 1]]);
    const glm::dvec3 c(mesh.positions[mesh.indices[i + 2]]);
    sum += glm::dot(a, glm::cross(b, c));
  }
  return sum / 6.0;
}

/// Triangles that have an area and whose own normal points away from a vertex normal.
std::size_t trianglesAgainstNormals(const Primitive& mesh) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const std::uint32_t* t = &mesh.indices[i];
    const glm::dvec3 a(mesh.positions[t[0]]);
    const glm::dvec3 face =
        glm::cross(glm::dvec3(mesh.positions[t[1]]) - a, glm::dvec3(mesh.positions[t[2]]) - a);
    if (glm::length(face) < 1e-9) continue;
    const bool against = std::any_of(t, t + 3, [&](std::uint32_t index) {
      return glm::dot(face, glm::dvec3(mesh.attributes[index].normal)) <= 0.0;
    });
    count += against ? 1U : 0U;
  }
  return count;
}

bool sameBits(const Scene& a, const Scene& b) {
  if (a.primitives.size() != b.primitives.size() || a.instances.size() != b.instances.size() ||
      a.images.size() != b.images.size()) {
    return false;
  }
  const auto same = [](const auto& x, const auto& y) {
    return x.size() == y.size() &&
           (x.empty() || std::memcmp(x.data(), y.data(), x.size() * sizeof(x[0])) == 0);
  };
  for (std::size_t i = 0; i < a.primitives.size(); ++i) {
    if (!same(a.primitives[i].positions, b.primitives[i].positions) ||
        !same(a.primitives[i].attributes, b.primitives[i].attributes) ||
        !same(a.primitives[i].indices, b.primitives[i].indices)) {
      return false;
    }
  }
  for (std::size_t i = 0; i < a.images.size(); ++i) {
    if (!same(a.images[i].rgba, b.images[i].rgba)) return false;
  }
  return same(a.instances, b.instances);
}

TEST(Circle, HitsQuartersExactlyAndTheRestClosely) {
  EXPECT_EQ(onCircle(0.0), glm::vec2(1.0F, 0.0F));
  EXPECT_EQ(onCircle(0.25), glm::vec2(0.0F, 1.0F));
  EXPECT_EQ(onCircle(-0.5), glm::vec2(-1.0F, 0.0F));
  EXPECT_EQ(onCircle(7.75), glm::vec2(0.0F, -1.0F));
  for (int i = -100; i < 300; ++i) {
    const double angle = 2.0 * M_PI * i / 97.0;
    const glm::vec2 p = onCircle(i / 97.0);
    EXPECT_NEAR(p.x, std::cos(angle), 1e-7) << i;
    EXPECT_NEAR(p.y, std::sin(angle), 1e-7) << i;
  }
}

TEST(MeshBuilder, ClosedShapesEncloseTheirVolume) {
  Primitive box;
  addBox(box, {0, 0, 0}, {2, 3, 4});
  EXPECT_NEAR(volumeOf(box), 24.0, 1e-6);

  // Cutting the 12 edges of a unit cube at b leaves 1 - 6 b^2 + (16/3) b^3: an edge loses the prism
  // b^2 / 2, and where three prisms meet the inclusion-exclusion adds (2/3) b^3 to each corner.
  Primitive bevelled;
  addBevelledBox(bevelled, glm::vec3(0.0F), glm::vec3(1.0F), 0.1F);
  EXPECT_NEAR(volumeOf(bevelled), 1.0 - 0.06 + 16.0 / 3.0 * 0.001, 1e-5);

  Primitive sphere;
  addSphere(sphere, {1, 2, 3}, 0.5F, 96);
  EXPECT_NEAR(volumeOf(sphere), 4.0 / 3.0 * M_PI * 0.125, 0.002);

  Primitive cylinder;
  addLathe(cylinder, std::vector<glm::vec2>{{0, 0}, {1, 0}, {1, 2}, {0, 2}}, 128);
  EXPECT_NEAR(volumeOf(cylinder), 2.0 * M_PI, 0.01);

  // A beaker: 2 pi, less a frustum of 1.8 between the radii 0.54 (0.6 of the inner wall's) and
  // 0.9, plus the cone of 0.08 that the bottom rises to.
  Primitive beaker;
  addVessel(beaker, std::vector<glm::vec2>{{0, 0}, {1, 0}, {1, 2}}, 0.1F, 0.2F, 128);
  EXPECT_NEAR(volumeOf(beaker), M_PI * (2.0 - 0.6 * (0.81 + 0.486 + 0.2916) + 0.2916 * 0.08 / 3.0),
              0.005);

  // Pappus: the cross-section times the length of the path.
  Primitive knot;
  addTorusKnot(knot, 1, 0, 1.0F, 0.1F, 256, 64);
  EXPECT_NEAR(volumeOf(knot), 0.01 * M_PI * 2.0 * M_PI * 1.4, 0.005);
}

TEST(MeshBuilder, TurnsCounterClockwiseSeenFromAbove) {
  const glm::vec4 p = place({1, 2, 3}, 0.25F, 2.0F) * glm::vec4(1, 1, 0, 1);
  EXPECT_FLOAT_EQ(p.x, 1.0F);
  EXPECT_FLOAT_EQ(p.y, 4.0F);
  EXPECT_FLOAT_EQ(p.z, 1.0F);  // +x turned to -z
}

TEST(DepthCounter, CountsBothSidesAndKeepsTheLimit) {
  Camera camera;
  camera.target = {0, 0, -1};
  Primitive square;
  addQuad(square, {-1, -1, -2}, {1, -1, -2}, {1, 1, -2}, {-1, 1, -2});
  Primitive back;
  addQuad(back, {1, -1, -3}, {-1, -1, -3}, {-1, 1, -3}, {1, 1, -3});
  DepthCounter counter(camera, 1.0F, 64);
  EXPECT_TRUE(counter.addWithin(square, glm::mat4(1.0F), 2));
  EXPECT_TRUE(counter.addWithin(back, glm::mat4(1.0F), 2));
  EXPECT_FALSE(counter.addWithin(square, glm::mat4(1.0F), 2));
  EXPECT_TRUE(counter.addWithin(square, glm::mat4(1.0F), 3));  // the refused one left no trace
  EXPECT_TRUE(counter.addWithin(square, place({0, 0, 5}), 1)) << "behind the camera";
}

TEST(DepthCounter, TellsHowMuchOfTheFrameIsCovered) {
  Camera camera;
  camera.target = {0, 0, -1};
  Primitive square;  // half of the frame's width and height, from its middle
  addQuad(square, {-1, -1, -2}, {1, -1, -2}, {1, 1, -2}, {-1, 1, -2});
  DepthCounter counter(camera, 1.0F, 64);
  EXPECT_EQ(counter.coverage(), 0.0F);
  EXPECT_TRUE(counter.addWithin(square, glm::mat4(1.0F), 2));
  EXPECT_EQ(counter.coverage(), 0.25F);
  EXPECT_TRUE(counter.addWithin(square, glm::mat4(1.0F), 2));
  EXPECT_EQ(counter.coverage(), 0.25F) << "twice over is covered once";
}

TEST(DepthCounter, LeavesOutWhatLiesBehindAnOccluder) {
  Camera camera;
  camera.target = {0, 0, -1};
  const auto square = [](float z) {
    Primitive mesh;
    addQuad(mesh, {-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z});
    return mesh;
  };
  DepthCounter counter(camera, 1.0F, 64);
  counter.occlude(square(-2.0F), glm::mat4(1.0F));
  EXPECT_TRUE(counter.addWithin(square(-2.1F), glm::mat4(1.0F), 0)) << "hidden";
  EXPECT_FALSE(counter.addWithin(square(-1.9F), glm::mat4(1.0F), 0)) << "in front";
  // At -4 the occluder hides all of the square; at its side, nothing.
  EXPECT_TRUE(counter.addWithin(square(-4.0F), glm::mat4(1.0F), 0));
  EXPECT_FALSE(counter.addWithin(square(-4.0F), place({2, 0, 0}), 0));
}

TEST(DepthCounter, OccludersHideByTheDepthOfEachPixel) {
  Camera camera;
  camera.target = {0, 0, -1};
  // The floor of a corridor: 1 m below the eye, from 1.1 to 10 m ahead.
  Primitive floor;
  addQuad(floor, {-20, -1, -1.1F}, {20, -1, -1.1F}, {20, -1, -10}, {-20, -1, -10});
  Primitive below;  // upright, its top 1 cm under the floor
  addQuad(below, {-1, -1.5F, -5}, {1, -1.5F, -5}, {1, -1.01F, -5}, {-1, -1.01F, -5});
  Primitive above;
  addQuad(above, {-1, -0.99F, -5}, {1, -0.99F, -5}, {1, -0.5F, -5}, {-1, -0.5F, -5});
  DepthCounter counter(camera, 1.0F, 256);
  counter.occlude(floor, glm::mat4(1.0F));
  EXPECT_TRUE(counter.addWithin(below, glm::mat4(1.0F), 0));
  EXPECT_FALSE(counter.addWithin(above, glm::mat4(1.0F), 0));
}

TEST(Layers, ColourAndAlphaFollowTheFormula) {
  EXPECT_FLOAT_EQ(layerColor(1, 5).r, 0.37F);
  EXPECT_FLOAT_EQ(layerColor(1, 5).g, 53.0F / 102.0F);
  EXPECT_FLOAT_EQ(layerColor(1, 5).b, 71.0F / 106.0F);
  EXPECT_FLOAT_EQ(layerColor(3, 5).r, 0.10F);  // 111 mod 101
  EXPECT_FLOAT_EQ(layerAlpha(1, 4), 0.25F);
  EXPECT_FLOAT_EQ(layerAlpha(4, 4), 1.0F);
  EXPECT_FLOAT_EQ(layersComposite(2).r, 0.5F * (0.37F + 0.74F));
}

TEST(Layers, BlendedInOrderGiveTheMeanColour) {
  for (const int n : {1, 2, 7, 128, kMaxLayers}) {
    const Scene scene = makeLayers(n, 9);
    const Primitive& quads = scene.primitives.at(0);
    ASSERT_EQ(quads.indices.size(), static_cast<std::size_t>(n) * 6);
    std::map<float, glm::vec4> fromBack;  // z is negative: the farthest comes first
    for (std::size_t i = 0; i < quads.positions.size(); i += 4) {
      fromBack[quads.positions[i].z] = quads.attributes[i].color;
    }
    ASSERT_EQ(fromBack.size(), static_cast<std::size_t>(n));
    glm::dvec3 color(123.0);  // the background does not count
    for (const auto& [z, c] : fromBack) {
      color = glm::mix(color, glm::dvec3(c), static_cast<double>(c.a));
    }
    const glm::vec3 expected = layersComposite(n);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(color[c], expected[c], 2e-5) << n;
  }
}

TEST(Layers, FillFramesOfEveryAspect) {
  const Scene scene = makeLayers(3, 1);
  const Camera& camera = scene.cameras.at(0);
  for (const auto& [w, h] : {std::pair{64, 16}, {16, 64}, {32, 32}}) {
    const plain::PlainView view(camera, w, h);
    std::vector<int> counts(static_cast<std::size_t>(w * h));
    plain::drawScene(
        scene, view, [](const Material&) { return true; },
        [&, width = w](const Instance&, std::size_t, const plain::Hit& hit) {
          ++counts[static_cast<std::size_t>(hit.y * width + hit.x)];
        });
    // At least: a centre on the diagonal of a quad counts for both of its triangles here.
    for (const int count : counts) EXPECT_GE(count, 3) << w << "x" << h;
  }
}

TEST(Layers, AreShuffledBySeed) {
  EXPECT_FALSE(sameBits(makeLayers(16, 1), makeLayers(16, 2)));
  EXPECT_TRUE(sameBits(makeLayers(16, 1), makeLayers(16, 1)));
}

struct DepthCase {
  const char* name;
  std::uint64_t seed;
  int least, most;
  std::uint64_t leastTotal, mostTotal;
};

class DepthOf : public testing::TestWithParam<DepthCase> {};

TEST_P(DepthOf, SceneIsWithinTenPercentAndItsTotalIsLarge) {
  const DepthCase& c = GetParam();
  const Scene scene = loadScene(c.name, c.seed);
  const plain::DepthCounts counts = plain::countTransparent(scene, scene.cameras.at(0), 1024);
  EXPECT_GE(counts.maximum, c.least);
  EXPECT_LE(counts.maximum, c.most);
  EXPECT_GE(counts.total, c.leastTotal);
  EXPECT_LE(counts.total, c.mostTotal);
  const double mean = static_cast<double>(counts.total) / static_cast<double>(counts.covered);
  RecordProperty("maximum", counts.maximum);
  RecordProperty("mean", std::to_string(mean));
  EXPECT_GT(mean, 5.0);
  EXPECT_LT(mean, 10.0);
}

INSTANTIATE_TEST_SUITE_P(Recipes, DepthOf,
                         testing::Values(DepthCase{"smoke", 0, 15, 17, 1'000'000, 2'500'000},
                                         DepthCase{"smoke", 1, 15, 17, 1'000'000, 2'500'000},
                                         DepthCase{"smoke", 99, 15, 17, 1'000'000, 2'500'000},
                                         DepthCase{"bottles", 0, 20, 24, 1'500'000, 4'000'000},
                                         DepthCase{"bottles", 1, 20, 24, 1'500'000, 4'000'000},
                                         DepthCase{"bottles", 99, 20, 24, 1'500'000, 4'000'000}),
                         [](const auto& tested) {
                           return std::string(tested.param.name) +
                                  std::to_string(tested.param.seed);
                         });

class Recipe : public testing::TestWithParam<const char*> {};

TEST_P(Recipe, IsSoundAndRepeatable) {
  const Scene scene = loadScene(GetParam(), 5);
  EXPECT_TRUE(sameBits(scene, loadScene(GetParam(), 5)));
  ASSERT_FALSE(scene.cameras.empty());
  EXPECT_EQ(scene.cameras[0].name, "scene");
  for (const Instance& instance : scene.instances) {
    ASSERT_LT(instance.primitive, scene.primitives.size());
    EXPECT_GT(glm::determinant(glm::mat3(instance.transform)), 0.0F);
  }
  for (std::size_t i = 0; i < scene.primitives.size(); ++i) {
    const Primitive& mesh = scene.primitives[i];
    const std::string& name = scene.materialOf(mesh).name;
    ASSERT_EQ(mesh.attributes.size(), mesh.positions.size());
    ASSERT_EQ(mesh.indices.size() % 3, 0U);
    for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.positions.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      ASSERT_TRUE(glm::all(glm::lessThan(glm::abs(mesh.positions[v]), glm::vec3(1e3F)))) << name;
      // The range that glTF allows.
      ASSERT_EQ(mesh.attributes[v].color, glm::clamp(mesh.attributes[v].color, 0.0F, 1.0F)) << name;
      ASSERT_NEAR(glm::length(mesh.attributes[v].normal), 1.0F, 1e-4F) << name;
    }
    EXPECT_EQ(trianglesAgainstNormals(mesh), 0U) << "primitive " << i << ", " << name;
  }
  for (const Material& material : scene.materials) {
    EXPECT_LT(material.baseColorTexture.image, static_cast<int>(scene.images.size()));
  }
  const auto casts = [](const Light& light) { return light.castsShadow; };
  EXPECT_LE(std::count_if(scene.lights.begin(), scene.lights.end(), casts), 1);
}

INSTANTIATE_TEST_SUITE_P(All, Recipe,
                         testing::Values("layers-5", "medley-3", "smoke", "bottles", "hair",
                                         "greenhouse", "hairball", "spheres", "gallery", "car",
                                         "marble", "chess"),
                         [](const auto& tested) {
                           std::string name = tested.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(Gallery, HoldsWhatItPromises) {
  const Scene scene = makeGallery(1);
  std::size_t triangles = 0;
  std::size_t blended = 0;
  std::size_t masked = 0;
  for (const Instance& instance : scene.instances) {
    const Primitive& mesh = scene.primitives[instance.primitive];
    const Material& material = scene.materialOf(mesh);
    triangles += mesh.indices.size() / 3;
    if (material.isTransparent()) blended += mesh.indices.size() / 3;
    if (material.alphaMode == AlphaMode::Mask) masked += mesh.indices.size() / 3;
  }
  EXPECT_GE(triangles, 300'000U);
  EXPECT_LE(triangles, 600'000U);
  EXPECT_GT(blended, 50'000U);
  EXPECT_GT(masked, 1'000U);
  EXPECT_GE(scene.lights.size(), 4U);
  EXPECT_TRUE(std::any_of(scene.lights.begin(), scene.lights.end(),
                          [](const Light& light) { return light.castsShadow; }));
  EXPECT_TRUE(std::any_of(scene.cameras.begin(), scene.cameras.end(),
                          [](const Camera& camera) { return camera.name == "orbit"; }));
  const plain::DepthCounts counts = plain::countTransparent(scene, scene.cameras[0], 256);
  EXPECT_GT(counts.covered, 256U * 256U / 10U) << "a tenth of the first view lies behind glass";
}

TEST(Bottles, HaveOneSunAndThreeLamps) {
  const Scene scene = makeBottles(1);
  ASSERT_EQ(scene.lights.size(), 4U);
  EXPECT_TRUE(scene.lights[0].castsShadow);
  EXPECT_EQ(scene.lights[0].type, LightType::Directional);
}

TEST(Textures, FrondIsCutOutAndTheRestIsOpaque) {
  const auto alphas = [](const Image& image) {
    std::pair<int, int> clearAndSolid;
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
      ++(image.rgba[i] == 0 ? clearAndSolid.first : clearAndSolid.second);
      EXPECT_TRUE(image.rgba[i] == 0 || image.rgba[i] == 255);
    }
    return clearAndSolid;
  };
  const auto [clear, solid] = alphas(frond(64, 1));
  EXPECT_GT(clear, 64 * 64 / 4);
  EXPECT_GT(solid, 64 * 64 / 8);
  EXPECT_EQ(alphas(marbleTiles(64, 1)).first, 0);
  EXPECT_EQ(alphas(carpet(32, 128, 1)).first, 0);
}

std::string messageOf(const std::string& name) {
  try {
    (void)loadScene(name, 0);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(LoadScene, ExplainsWrongNames) {
  EXPECT_EQ(messageOf("galery"),
            "galery: no such scene; the nearest is 'gallery' of gallery, smoke, bottles, hair, "
            "greenhouse, hairball, spheres, car, marble, chess, layers-N, medley-N; or name a "
            ".gltf or .glb "
            "file");
  EXPECT_NE(messageOf("Layer-64").find("nearest is 'layers-N'"), std::string::npos);
  for (const char* path : {"nowhere/smoke", "./smoke", "house.obj", "../house.gltf"}) {
    EXPECT_EQ(messageOf(path), std::string(path) + ": no such file; check the path");
  }
  for (const char* name : {"layers-0", "layers--1", "layers-", "layers-4097", "layers-4x",
                           "layers-99999999999999999999"}) {
    EXPECT_NE(messageOf(name).find("choose 1 to 4096"), std::string::npos) << messageOf(name);
  }
  EXPECT_NE(messageOf("").find("empty"), std::string::npos);
  EXPECT_NE(messageOf("/").find("is a folder"), std::string::npos);
  EXPECT_NE(messageOf(MACULA_SOURCE_DIR "/CMakeLists.txt").find(".gltf or .glb"),
            std::string::npos);
  EXPECT_NE(messageOf("/nowhere/scene.GLB").find("no such file"), std::string::npos);
}

TEST(LoadScene, ListsItsRecipes) {
  for (const RecipeInfo& recipe : recipes()) {
    EXPECT_FALSE(recipe.description.empty());
    std::string name = recipe.name;
    if (name.ends_with("-N")) name.back() = '2';
    EXPECT_FALSE(loadScene(name, 0).instances.empty()) << name;
  }
}

}  // namespace
}  // namespace macula::scene
