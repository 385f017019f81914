// Which lights light a frame, where there are too many.
#include "engine/scene/light_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace macula::scene {
namespace {

Light lamp(const glm::vec3& position, float intensity = 10.0F, float range = 0.0F) {
  Light light;
  light.type = LightType::Point;
  light.position = position;
  light.intensity = intensity;
  light.range = range;
  return light;
}

Bounds boxOf(const glm::vec3& low, const glm::vec3& high) {
  Bounds bounds;
  bounds.add(low);
  bounds.add(high);
  return bounds;
}

/// Looks along +x or another direction from a place.
Camera cameraAt(const glm::vec3& position, const glm::vec3& direction) {
  Camera camera;
  camera.position = position;
  camera.target = position + direction;
  return camera;
}

std::vector<std::uint32_t> chosenOf(LightChoice& choice, const Camera& camera) {
  const auto chosen = choice.choose(camera, 1.5F);
  return {chosen.begin(), chosen.end()};
}

/// Two halls of 60 m behind each other along x, each with 40 lamps under its ceiling.
struct Halls {
  Halls() {
    for (int hall = 0; hall < 2; ++hall) {
      for (int i = 0; i < 40; ++i) {
        const auto x = static_cast<float>(60 * hall + 5 + 5 * (i / 4));
        const float z = 3.0F * static_cast<float>(i % 4) - 4.5F;
        lights.push_back(lamp({x, 4.0F, z}, 20.0F, 8.0F));
      }
    }
  }
  std::vector<Light> lights;
  Bounds bounds = boxOf({0, 0, -6}, {120, 5, 6});
};

TEST(LightChoice, TakesAllThatAFrameHasRoomFor) {
  const std::vector<Light> lights(kMostLights, lamp({0, 0, 0}));
  LightChoice choice(lights, boxOf({-1, -1, -1}, {1, 1, 1}));
  EXPECT_FALSE(choice.needed());
  EXPECT_EQ(chosenOf(choice, Camera{}).size(), static_cast<std::size_t>(kMostLights));
}

TEST(LightChoice, LeavesOutThoseThatAddNothing) {
  std::vector<Light> lights(kMostLights, lamp({0, 0, -4}, 0.0F));
  for (int i = 0; i < 8; ++i) lights.push_back(lamp({static_cast<float>(i) - 3.5F, 0, -4}, 2.0F));
  LightChoice choice(lights, boxOf({-4, -4, -5}, {4, 4, -5}));  // a wall has no depth
  const std::vector<std::uint32_t> chosen = chosenOf(choice, Camera{});
  ASSERT_EQ(chosen.size(), static_cast<std::size_t>(kMostLights));
  for (std::uint32_t i = kMostLights; i < lights.size(); ++i) {
    EXPECT_TRUE(std::binary_search(chosen.begin(), chosen.end(), i)) << i;
  }
  EXPECT_EQ(chosen.front(), 0U) << "equal ones in the scene's order";
}

TEST(LightChoice, FollowsTheView) {
  Halls halls;
  LightChoice choice(halls.lights, halls.bounds);
  const std::vector<std::uint32_t> ahead = chosenOf(choice, cameraAt({62, 2, 0}, {1, 0, 0}));
  const std::vector<std::uint32_t> back = chosenOf(choice, cameraAt({55, 2, 0}, {-1, 0, 0}));
  EXPECT_EQ(std::count_if(ahead.begin(), ahead.end(), [](auto i) { return i >= 40; }), kMostLights)
      << "lamps behind the camera reach nothing that is seen";
  EXPECT_EQ(std::count_if(back.begin(), back.end(), [](auto i) { return i < 40; }), kMostLights);
  EXPECT_EQ(chosenOf(choice, cameraAt({62, 2, 0}, {1, 0, 0})), ahead) << "whatever came before";
}

TEST(LightChoice, OnlySwapsLightsThatAddAboutAsMuch) {
  // Along a walk from one hall to the other, what a step of 5 cm takes away is hardly more than
  // what it gives: a light comes or goes where it is worth least.
  Halls halls;
  LightChoice choice(halls.lights, halls.bounds);
  double worst = 0.0;
  std::vector<std::uint32_t> before;
  for (float x = 20.0F; x < 50.0F; x += 0.05F) {
    const Camera camera = cameraAt({x, 1.7F, 0.3F}, {1, 0, 0.1F});
    const std::vector<std::uint32_t> now = chosenOf(choice, camera);
    double all = 0.0;
    for (const Light& light : halls.lights) all += choice.share(light, camera, 1.5F);
    for (const std::uint32_t i : before) {
      if (std::binary_search(now.begin(), now.end(), i)) continue;
      worst = std::max(worst, choice.share(halls.lights[i], camera, 1.5F) / all);
    }
    before = now;
  }
  EXPECT_GT(worst, 0.0) << "lights were swapped";
  EXPECT_LT(worst, 0.01) << "of all light in view";
}

TEST(LightChoice, ConsidersRangesConesAndSuns) {
  const Bounds bounds = boxOf({-5, -5, -15}, {5, 5, -5});
  const LightChoice choice({}, bounds);
  const Camera camera;
  const auto share = [&](const Light& light) { return choice.share(light, camera, 1.0F); };
  const double near = share(lamp({0, 0, -10}));
  EXPECT_GT(near, 0.0);
  EXPECT_NEAR(share(lamp({0, 0, -10}, 30.0F)), 3.0 * near, 1e-6 * near);
  EXPECT_LT(share(lamp({0, 40, -10})), 0.05 * near);
  EXPECT_EQ(share(lamp({0, 40, -10}, 10.0F, 20.0F)), 0.0) << "its range ends before";
  EXPECT_EQ(share(lamp({0, 0, 10}, 10.0F, 9.0F)), 0.0) << "behind the camera";
  const double small = share(lamp({2, 1, -10}, 10.0F, 0.3F));
  EXPECT_GT(small, 0.0) << "small lights do not fall between the lines of sight";
  EXPECT_LT(small, near);

  Light spot = lamp({0, 4, -10});
  spot.type = LightType::Spot;
  spot.outerConeAngle = 0.4F;
  spot.innerConeAngle = 0.2F;
  spot.direction = {0, -1, 0};
  const double down = share(spot);
  spot.direction = {0, 1, 0};
  EXPECT_GT(down, 0.0);
  EXPECT_LT(share(spot), 0.1 * down) << "it lights only what is above it";
  EXPECT_LT(down, share(lamp({0, 4, -10})));

  Light sun;
  sun.intensity = 2.0F;
  EXPECT_NEAR(share(sun), 2.0, 1e-6) << "2 lux wherever something is";
}

TEST(LightChoice, DoesNotDependOnTheUnitOfLength) {
  Halls halls;
  LightChoice metres(halls.lights, halls.bounds);
  constexpr float kScale = 1024.0F;
  std::vector<Light> larger = halls.lights;
  for (Light& light : larger) {
    light.position *= kScale;
    light.range *= kScale;
  }
  LightChoice others(larger, boxOf(kScale * halls.bounds.min, kScale * halls.bounds.max));
  const glm::vec3 eye(20, 2, 1);
  EXPECT_EQ(chosenOf(metres, cameraAt(eye, {1, 0, 0})),
            chosenOf(others, cameraAt(kScale * eye, {1, 0, 0})));
}

TEST(LightChoice, SaysWhatIsLeftOut) {
  Scene scene;
  EXPECT_EQ(lightsLeftOut(scene, Camera{}, 1.0F, "here"), "");
  scene.lights.assign(kMostLights, lamp({0, 0, -4}, 5.0F));
  scene.lights.push_back(lamp({0, 0, -4}, 1.0F));
  scene.lights.back().name = "candle";
  scene.primitives.resize(1);
  scene.primitives[0].positions = {{-1, -1, -5}, {1, -1, -5}, {0, 1, -5}};
  scene.instances.push_back({0, glm::mat4(1.0F)});
  EXPECT_EQ(
      lightsLeftOut(scene, Camera{}, 1.0F, "here"),
      "33 lights, and a frame is lit by 32: those that add most to what is in view; from here "
      "without candle; remove or merge lights that add little");
}

}  // namespace
}  // namespace macula::scene
