// Image-based light from panoramas whose integrals are known.
#include "engine/scene/environment.h"

#include <gtest/gtest.h>

#include <cmath>

namespace macula::scene {
namespace {

Panorama constant(float radiance) {
  Panorama p{64, 32, {}};
  p.pixels.assign(64 * 32, glm::vec3(radiance));
  return p;
}

/// Irradiance over pi towards +y or -y, from the harmonics' l = 0, 1 and 2 terms in y.
float towardsY(const Environment& e, float y) {
  return e.irradiance[0].r * 0.282095F + e.irradiance[1].r * 0.488603F * y -
         e.irradiance[6].r * 0.315392F - e.irradiance[8].r * 0.546274F;
}

TEST(Panorama, DirectionsAndPlacesAgree) {
  EXPECT_NEAR(glm::distance(directionOf(0.5F, 0.5F), glm::vec3(0, 0, -1)), 0.0F, 1e-6F);
  EXPECT_NEAR(glm::distance(directionOf(0.75F, 0.5F), glm::vec3(1, 0, 0)), 0.0F, 1e-6F);
  EXPECT_NEAR(directionOf(0.3F, 0.0F).y, 1.0F, 1e-6F);
  for (const glm::vec2 uv : {glm::vec2(0.1F, 0.2F), glm::vec2(0.6F, 0.7F), glm::vec2(0.9F, 0.4F)}) {
    EXPECT_NEAR(glm::distance(panoramaUv(directionOf(uv.x, uv.y)), uv), 0.0F, 1e-5F);
  }
}

TEST(Environment, ConstantLightIsConstantEverywhere) {
  const Environment e = makeEnvironment(constant(2.0F));
  EXPECT_GT(e.levels.size(), 1U);
  for (const Panorama& level : e.levels) {
    for (const glm::vec3& p : level.pixels) EXPECT_NEAR(p.g, 2.0F, 1e-4F);
  }
  // A white surface reflects what comes in: irradiance over pi is the radiance itself.
  EXPECT_NEAR(towardsY(e, 1.0F), 2.0F, 0.01F);
  EXPECT_NEAR(towardsY(e, -1.0F), 2.0F, 0.01F);
}

TEST(Environment, ABrightSkyLightsWhatLooksUp) {
  Panorama p = constant(0.0F);
  for (std::size_t i = 0; i < p.pixels.size() / 2; ++i) p.pixels[i] = glm::vec3(1.0F);
  const Environment e = makeEnvironment(p);
  // A hemisphere of radiance 1: irradiance over pi is 1 facing it and 0 facing away; nine
  // harmonics come within some percent of that.
  EXPECT_NEAR(towardsY(e, 1.0F), 1.0F, 0.07F);
  EXPECT_NEAR(towardsY(e, -1.0F), 0.0F, 0.07F);
}

TEST(Environment, LevelsHalve) {
  const Environment e = makeEnvironment(constant(1.0F));
  for (std::size_t i = 1; i < e.levels.size(); ++i) {
    EXPECT_EQ(e.levels[i].width * 2, e.levels[i - 1].width);
  }
}

}  // namespace
}  // namespace macula::scene
