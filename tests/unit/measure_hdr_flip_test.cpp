// HDR-FLIP: its curve and exposures by hand, its map by what must hold.
#include "engine/measure/hdr_flip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/core/error.h"
#include "engine/measure/image_error.h"

namespace macula::measure {
namespace {

using image::ImageF;

/// One row of linear greys.
ImageF greys(std::vector<float> values) {
  return {static_cast<int>(values.size()), 1, 1, std::move(values), true};
}

ImageF noise(std::uint32_t seed, float scale) {
  std::mt19937 random(seed);
  ImageF image{24, 16, 3, {}, true};
  for (int i = 0; i < 24 * 16 * 3; ++i) {
    const float unit = static_cast<float>(random() >> 8) / 16777216.0F;
    image.pixels.push_back(scale * std::exp2(10.0F * unit - 5.0F));
  }
  return image;
}

// The positive root of 0.16002 x^2 - 0.2829 x - 0.119 = 0.
constexpr double kAtTarget = 2.118872;

// 1: (0.9036 + 0.018) / (0.8748 + 0.354 + 0.14) = 0.673290.
TEST(HdrFlip, CurveOfAces) {
  EXPECT_EQ(toneMapAces(0.0F), 0.0F);
  EXPECT_EQ(toneMapAces(-3.0F), 0.0F);
  EXPECT_NEAR(toneMapAces(1.0F), 0.673290, 1e-6);
  EXPECT_NEAR(toneMapAces(static_cast<float>(kAtTarget)), 0.85, 1e-5);
  EXPECT_EQ(toneMapAces(1e9F), 1.0F);
}

TEST(HdrFlip, ExposuresBringMaximumAndMedianToTheTarget) {
  const Exposures exposures = exposuresOf(greys({8.0F, 1.0F, 1.0F, 0.5F}));
  EXPECT_NEAR(exposures.start, std::log2(kAtTarget / 8.0), 1e-5);
  EXPECT_NEAR(exposures.stop, std::log2(kAtTarget), 1e-5);
  EXPECT_EQ(exposures.count, 3) << "three stops";
  EXPECT_NEAR(exposuresOf(greys({4.0F, 1.0F, 3.0F, 0.5F})).stop, std::log2(kAtTarget / 2.0), 1e-5)
      << "the mean of the middle two";
}

TEST(HdrFlip, LuminanceIsThatOfSrgb) {
  const ImageF green{1, 1, 3, {-5.0F, 1.0F, 0.0F}, true};
  EXPECT_NEAR(exposuresOf(green).start, std::log2(kAtTarget / 0.7152), 1e-5);
}

TEST(HdrFlip, ExposuresWhereThePaperLeavesThemOpen) {
  EXPECT_EQ(exposuresOf(greys({2.0F, 2.0F})).count, 1) << "the median is the maximum";
  EXPECT_EQ(exposuresOf(greys({0.0F, 0.0F})).count, 1);
  EXPECT_EQ(exposuresOf(greys({0.0F, 0.0F})).start, 0.0);
  // Mostly black: the median of 1 and 4.
  const Exposures sparse = exposuresOf(greys({0.0F, 4.0F, 0.0F, 0.0F, 1.0F}));
  EXPECT_NEAR(sparse.stop, std::log2(kAtTarget / 2.5), 1e-5);
  EXPECT_LE(exposuresOf(greys({1e30F, 1e-30F, 1e-30F})).count, 24);
}

// One exposure, at which the reference stands at 0.85 and the test at the curve's 2 x 2.118872:
// (0.9036 x^2 + 0.018 x) / (0.8748 x^2 + 0.354 x + 0.14) = 16.3036 / 17.3502 at x = 4.237744.
TEST(HdrFlip, FlatImagesAreComparedAtTheTarget) {
  const ImageF reference = greys({1.0F, 1.0F});
  const Plane map = hdrFlipMap(reference, greys({2.0F, 2.0F}));
  const Plane expected = flipMap(greys({0.85F, 0.85F}), greys({0.9396736F, 0.9396736F}));
  EXPECT_NEAR(map.values[0], expected.values[0], 1e-4);
  EXPECT_GT(map.values[0], 0.01F);
  EXPECT_EQ(meanOf(hdrFlipMap(reference, reference)), 0.0);
}

TEST(HdrFlip, DoesNotDependOnTheUnitOfRadiance) {
  const Plane one = hdrFlipMap(noise(1, 1.0F), noise(2, 1.0F));
  const Plane thousandth = hdrFlipMap(noise(1, 1.0F / 1024.0F), noise(2, 1.0F / 1024.0F));
  for (std::size_t i = 0; i < one.values.size(); ++i) {
    ASSERT_NEAR(one.values[i], thousandth.values[i], 1e-4) << i;
  }
}

TEST(HdrFlip, ShowsWhatOneExposureHides) {
  // Both are white where everything above 1 is cut off.
  ImageF reference = greys(std::vector<float>(64, 8.0F));
  ImageF test = greys(std::vector<float>(64, 16.0F));
  EXPECT_EQ(compareImages(toDisplay(reference), toDisplay(test)).flip, 0.0);
  EXPECT_GT(compareImages(reference, test, {.hdr = true}).flip.value(), 0.01);
}

TEST(HdrFlip, LinearFlipIsFlipOfTheEncodedImage) {
  ImageF a = noise(3, 0.02F);
  ImageF b = noise(4, 0.02F);
  EXPECT_NEAR(flipMean(a, b), flipMean(toDisplay(a), toDisplay(b)), 1e-5);
}

TEST(HdrFlip, RefusesWhatIsNotDefined) {
  EXPECT_THROW((void)hdrFlipMap(greys({1.0F}), greys({1.0F, 2.0F})), InputError);
  EXPECT_THROW((void)hdrFlipMap(greys({1.0F}), greys({1.0F}), 0.0), InputError);
}

}  // namespace
}  // namespace macula::measure
