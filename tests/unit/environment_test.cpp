// Image-based light from panoramas whose integrals are known.
#include "engine/scene/environment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

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

/// All black but for one texel.
Panorama sun(int width, int height, int x, int y, float radiance) {
  Panorama p{width, height, {}};
  p.pixels.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                  glm::vec3(0.0F));
  p.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x)] = glm::vec3(radiance);
  return p;
}

/// Radiance over the sphere.
double lightOf(const Panorama& p) {
  double sum = 0.0;
  for (int y = 0; y < p.height; ++y) {
    const double band =
        std::cos(std::numbers::pi * y / p.height) - std::cos(std::numbers::pi * (y + 1) / p.height);
    for (int x = 0; x < p.width; ++x) {
      sum += static_cast<double>(p.at(x, y).g) * band * 2.0 * std::numbers::pi / p.width;
    }
  }
  return sum;
}

float largest(const Panorama& p) {
  float most = 0.0F;
  for (const glm::vec3& c : p.pixels) most = std::max(most, c.g);
  return most;
}

TEST(Environment, IrradianceFollowsASunHoweverBrightItIs) {
  for (const float radiance : {6e3F, 6e4F, 3e5F, 1e9F}) {
    const Panorama p = sun(64, 32, 32, 5, radiance);
    const double flux = lightOf(p);
    const auto cosine = static_cast<double>(directionOf(32.5F / 64.0F, 5.5F / 32.0F).y);
    // The first nine harmonics of the clamped cosine, over pi (Ramamoorthi and Hanrahan 2001).
    const double wanted = flux / (4.0 * std::numbers::pi) *
                          (1.0 + 2.0 * cosine + 1.25 * 0.5 * (3.0 * cosine * cosine - 1.0));
    EXPECT_NEAR(static_cast<double>(towardsY(makeEnvironment(p), 1.0F)), wanted, 0.002 * wanted)
        << radiance;
  }
}

TEST(Environment, LightThatIsTooBrightToReflectIsSpreadAndSaid) {
  EXPECT_TRUE(makeEnvironment(sun(64, 32, 32, 5, 6e4F)).warnings.empty());
  const Panorama p = sun(64, 32, 32, 5, 3e5F);
  const Environment e = makeEnvironment(p);
  EXPECT_EQ(largest(e.levels.front()), kMostStored);
  EXPECT_NEAR(lightOf(e.levels.front()) / lightOf(p), 1.0, 0.02);
  ASSERT_EQ(e.warnings.size(), 1U);
  EXPECT_EQ(e.warnings.front().find("1 of 2048 texels is brighter than 65504"), 0U)
      << e.warnings.front();
  EXPECT_NE(e.warnings.front().find("3e+05 in column 32, row 5 from the top"), std::string::npos)
      << e.warnings.front();
  EXPECT_NE(e.warnings.front().find("--exposure 3"), std::string::npos) << e.warnings.front();
  EXPECT_EQ(e.warnings.front().find('\n'), std::string::npos);
}

TEST(Environment, BlurredLevelsKeepTheLightOfASun) {
  // At the zenith too, where texels are small, and in a last column that has no partner.
  for (const Panorama& p : {sun(64, 32, 32, 5, 3e5F), sun(64, 32, 10, 15, 6e4F),
                            sun(64, 32, 3, 0, 6e4F), sun(135, 67, 134, 30, 6e4F)}) {
    const Environment e = makeEnvironment(p);
    ASSERT_GE(e.levels.size(), 3U);
    for (std::size_t i = 1; i < e.levels.size(); ++i) {
      EXPECT_NEAR(lightOf(e.levels[i]) / lightOf(p), 1.0, 0.15) << i << " of " << p.width;
    }
  }
}

TEST(Environment, ARoughReflectionOfASunIsSmooth) {
  // Under the roughest lobe, GGX with a = 1, a mirror shows the clamped cosine over pi; in texels
  // of 22 degrees within 12 % of its peak.
  const Panorama p = sun(512, 256, 256, 100, 6e4F);
  const glm::vec3 towards = directionOf(256.5F / 512.0F, 100.5F / 256.0F);
  const Panorama rough = makeEnvironment(p).levels.back();
  const double scale = lightOf(p) / std::numbers::pi;
  for (int y = 0; y < rough.height; ++y) {
    for (int x = 0; x < rough.width; ++x) {
      const glm::vec3 n = directionOf((static_cast<float>(x) + 0.5F) / 16.0F,
                                      (static_cast<float>(y) + 0.5F) / 8.0F);
      const double wanted = std::max(0.0, static_cast<double>(glm::dot(n, towards)));
      EXPECT_NEAR(static_cast<double>(rough.at(x, y).g) / scale, wanted, 0.12) << x << "," << y;
    }
  }
}

TEST(Environment, ValuesThatAreNoRadianceAreReplacedAndSaid) {
  Panorama p = constant(1.0F);
  p.pixels[0].r = std::numeric_limits<float>::quiet_NaN();
  p.pixels[70].g = std::numeric_limits<float>::infinity();
  p.pixels[71].b = 1.7e38F;
  p.pixels[130].b = -0.5F;
  const Environment e = makeEnvironment(p);
  for (const Panorama& level : e.levels) {
    for (const glm::vec3& c : level.pixels) {
      EXPECT_TRUE(glm::all(glm::greaterThanEqual(c, glm::vec3(0.0F))) &&
                  glm::all(glm::lessThanEqual(c, glm::vec3(kMostStored))));
    }
  }
  for (const glm::vec3& c : e.irradiance) {
    EXPECT_TRUE(std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b));
  }
  ASSERT_EQ(e.warnings.size(), 1U);
  EXPECT_EQ(e.warnings.front(),
            "1 texel is not a number and black (the first in column 0, row 0 from the top); "
            "2 texels are infinite and 65504 (the first in column 6, row 1 from the top); "
            "1 texel is negative and black (the first in column 2, row 2 from the top); "
            "write the picture again without them");
}

}  // namespace
}  // namespace macula::scene
