#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <span>
#include <utility>
#include <vector>

#include "engine/core/random.h"
#include "engine/scene/procedural/depth_counter.h"
#include "engine/scene/procedural/mesh_builder.h"
#include "engine/scene/procedural/recipes.h"
#include "engine/scene/procedural/scene_builder.h"
#include "engine/scene/procedural/textures.h"

namespace macula::scene {
namespace {

constexpr int kDepthLimit = 22;  // maximum depth of the bottles scene of Vasilakis 2017, Table 2
constexpr int kCountingSize = 1024;  // pixels; the size at which the depth is promised
constexpr float kTanHalfFov = 0.3F;
constexpr int kRows = 7;
constexpr int kColumns = 9;
constexpr float kColumnStep = 0.125F;  // metres
constexpr float kRowStep = 0.13F;
constexpr float kFrontRow = 0.36F;
constexpr float kJitter = 0.018F;
constexpr int kSegments = 48;
constexpr float kWall = 0.0025F;
constexpr float kBottom = 0.0075F;
// Bottles stand this far above the table, so that their feet and the wood do not share a plane.
constexpr float kFootGap = 0.001F;

/// Outer wall from the middle of the foot to the lip, in metres.
using Profile = std::vector<glm::vec2>;

const std::array<Profile, 4>& outlines() {
  static const std::array<Profile, 4> kOutlines{// Wine: straight sides, high shoulders.
                                                Profile{{0.0F, 0.006F},
                                                        {0.030F, 0.0F},
                                                        {0.036F, 0.004F},
                                                        {0.038F, 0.012F},
                                                        {0.038F, 0.19F},
                                                        {0.036F, 0.205F},
                                                        {0.029F, 0.222F},
                                                        {0.019F, 0.236F},
                                                        {0.0145F, 0.25F},
                                                        {0.0135F, 0.295F},
                                                        {0.0155F, 0.297F},
                                                        {0.0155F, 0.308F},
                                                        {0.0135F, 0.311F}},
                                                // Flask: a round belly.
                                                Profile{{0.0F, 0.004F},
                                                        {0.024F, 0.0F},
                                                        {0.034F, 0.006F},
                                                        {0.047F, 0.032F},
                                                        {0.052F, 0.060F},
                                                        {0.048F, 0.088F},
                                                        {0.036F, 0.112F},
                                                        {0.021F, 0.130F},
                                                        {0.0150F, 0.146F},
                                                        {0.0145F, 0.190F},
                                                        {0.018F, 0.194F},
                                                        {0.018F, 0.202F},
                                                        {0.0155F, 0.205F}},
                                                // Carafe: wide foot, drawn-in waist.
                                                Profile{{0.0F, 0.005F},
                                                        {0.040F, 0.0F},
                                                        {0.048F, 0.006F},
                                                        {0.049F, 0.020F},
                                                        {0.045F, 0.065F},
                                                        {0.034F, 0.120F},
                                                        {0.022F, 0.170F},
                                                        {0.018F, 0.200F},
                                                        {0.020F, 0.225F},
                                                        {0.028F, 0.250F},
                                                        {0.0295F, 0.254F},
                                                        {0.028F, 0.256F}},
                                                // Jar: short and square-shouldered.
                                                Profile{{0.0F, 0.004F},
                                                        {0.036F, 0.0F},
                                                        {0.043F, 0.005F},
                                                        {0.045F, 0.014F},
                                                        {0.045F, 0.110F},
                                                        {0.041F, 0.122F},
                                                        {0.031F, 0.130F},
                                                        {0.029F, 0.140F},
                                                        {0.033F, 0.143F},
                                                        {0.033F, 0.152F},
                                                        {0.030F, 0.155F}}};
  return kOutlines;
}

void addTable(SceneBuilder& builder, std::uint64_t seed) {
  Material wood = plainMaterial("table", glm::vec4(1.0F), 0.45F);
  wood.baseColorTexture.image = builder.image(woodBoards(256, seed));
  Primitive table;
  addBevelledBox(table, {-0.85F, -0.05F, -0.85F}, {0.85F, 0.0F, 0.95F}, 0.008F, 1.5F);
  builder.addOnce(std::move(table), builder.material(wood));

  const std::int32_t wall =
      builder.material(plainMaterial("wall", {0.30F, 0.33F, 0.38F, 1.0F}, 0.9F));
  Primitive back;
  addQuad(back, {-2.5F, -0.8F, -1.0F}, {2.5F, -0.8F, -1.0F}, {2.5F, 2.0F, -1.0F},
          {-2.5F, 2.0F, -1.0F});
  builder.addOnce(std::move(back), wall);
}

std::vector<std::uint32_t> addBottleShapes(SceneBuilder& builder) {
  // Alphas between 0.15 and 0.5, the range of tinted glass in the papers' pictures.
  const std::array<glm::vec4, 6> tints{
      glm::vec4{0.10F, 0.42F, 0.16F, 0.34F}, glm::vec4{0.62F, 0.26F, 0.05F, 0.40F},
      glm::vec4{0.10F, 0.32F, 0.66F, 0.32F}, glm::vec4{0.80F, 0.88F, 0.90F, 0.15F},
      glm::vec4{0.66F, 0.10F, 0.16F, 0.36F}, glm::vec4{0.52F, 0.60F, 0.12F, 0.28F}};
  std::vector<std::uint32_t> shapes;
  for (std::size_t t = 0; t < tints.size(); ++t) {
    const std::int32_t glass =
        builder.material(glassMaterial("glass " + std::to_string(t + 1), tints[t]));
    for (const Profile& outline : outlines()) {
      Primitive mesh;
      addVessel(mesh, outline, kWall, kBottom, kSegments);
      shapes.push_back(builder.shape(std::move(mesh), glass));
    }
  }
  return shapes;
}

void placeBottles(SceneBuilder& builder, std::span<const std::uint32_t> shapes,
                  const Camera& camera, std::uint64_t seed) {
  DepthCounter counter(camera, kTanHalfFov, kCountingSize);
  Random random(seed, 2);
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const std::uint32_t shape = shapes[random.below(static_cast<std::uint32_t>(shapes.size()))];
      const float jitterX = random.range(-kJitter, kJitter);
      const float jitterZ = random.range(-kJitter, kJitter);
      // Every other row stands in the gaps of the one before it.
      const float offset = row % 2 == 0 ? 0.0F : 0.5F;
      const float middle = 0.5F * static_cast<float>(kColumns - 1);
      const float x = (static_cast<float>(column) + offset - middle - 0.25F) * kColumnStep;
      const float z = kFrontRow - static_cast<float>(row) * kRowStep;
      const glm::mat4 transform = place({x + jitterX, kFootGap, z + jitterZ}, random.unit());
      // From front to back: where the promised depth is used up, the table stays empty.
      if (counter.addWithin(builder.mesh(shape), transform, kDepthLimit)) {
        builder.add(shape, transform);
      }
    }
  }
}

}  // namespace

Scene makeBottles(std::uint64_t seed) {
  SceneBuilder builder("bottles");
  Camera camera;
  camera.name = "scene";
  camera.position = {0.25F, 0.46F, 1.65F};
  camera.target = {0.0F, 0.12F, 0.0F};
  camera.verticalFov = 2.0F * std::atan(kTanHalfFov);
  camera.nearPlane = 0.05F;
  camera.farPlane = 12.0F;
  builder.camera(camera);
  // The wall behind the table is one-sided: an orbit passes through it and sees the bottles still.
  camera.name = "orbit";
  builder.camera(camera);

  addTable(builder, seed);
  placeBottles(builder, addBottleShapes(builder), camera, seed);

  builder.light(sun({-0.6F, -0.75F, -0.45F}, {1.0F, 0.95F, 0.86F}, 2.6F));
  builder.light(pointLight({-0.9F, 0.7F, 0.6F}, {0.55F, 0.72F, 1.0F}, 1.0F, 6.0F));
  builder.light(pointLight({0.8F, 0.5F, -0.7F}, {1.0F, 0.62F, 0.32F}, 0.9F, 6.0F));
  builder.light(
      spotLight({0.0F, 1.6F, -0.4F}, {0.0F, 0.0F, 0.0F}, {1.0F, 0.97F, 0.92F}, 2.5F, 0.6F));
  builder.ambient({0.16F, 0.17F, 0.19F});
  return std::move(builder).finish();
}

}  // namespace macula::scene
