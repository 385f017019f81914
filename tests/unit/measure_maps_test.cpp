// Errors weighted by the eye, flicker, and images of errors: all by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "engine/core/error.h"
#include "engine/measure/compare_files.h"
#include "engine/measure/error_maps.h"
#include "engine/measure/flicker.h"
#include "engine/measure/gaze_weight.h"
#include "temporary_path.h"

namespace macula::measure {
namespace {

using image::ImageF;

// MAR doubles at w0 / m degrees; at 1 degree it is 0.022 + 1/48 = 0.0428333.
TEST(GazeWeight, IsTheSquareOfTheShareOfAcuity) {
  EXPECT_EQ(acuityWeight(0.0), 1.0);
  EXPECT_NEAR(acuityWeight(kFovealMar / kMarSlope), 0.25, 1e-12);
  EXPECT_NEAR(acuityWeight(1.0), 0.236567, 1e-6);
}

TEST(GazeWeight, MeanCountsWhatIsLookedAt) {
  Plane map(2, 1);
  map.values = {1.0F, 0.0F};
  // The gaze on the first pixel, the second one degree away: 1 / 1.236567.
  EXPECT_NEAR(gazeWeightedMean(map, {0.25, 0.5}, 1.0), 0.808691, 1e-6);
  EXPECT_NEAR(gazeWeightedMean(map, {0.75, 0.5}, 1.0), 1.0 - 0.808691, 1e-6);
  EXPECT_NEAR(gazeWeightedMean(map, {0.5, 0.5}, 1.0), 0.5, 1e-12);
  EXPECT_NEAR(gazeWeightedMean(map, {0.25, 0.5}, 1e6), 0.5, 1e-6) << "both in the fovea";
}

TEST(GazeWeight, RowsCountFromTheTop) {
  Plane map(1, 4);
  map.values = {1.0F, 0.0F, 0.0F, 0.0F};
  EXPECT_GT(gazeWeightedMean(map, {0.5, 0.0}, 1.0), 0.5);
  EXPECT_LT(gazeWeightedMean(map, {0.5, 1.0}, 1.0), 0.1);
  map.values.assign(4, 0.3F);
  EXPECT_NEAR(gazeWeightedMean(map, {2.0, -1.0}, 5.0), 0.3, 1e-6) << "weights sum to 1";
}

TEST(GazeWeight, CompareGivesItWhereAsked) {
  ImageF reference{64, 1, 1, std::vector<float>(64, 0.5F)};
  ImageF test = reference;
  for (std::size_t i = 0; i < 8; ++i) test.pixels[i] = 0.8F;
  CompareOptions options;
  EXPECT_FALSE(compareImages(reference, test, options).flipGaze);
  options.gaze = {0.0, 0.5};
  options.pixelsPerDegree = 10.0;
  const ImageError near = compareImages(reference, test, options);
  options.gaze = {1.0, 0.5};
  const ImageError far = compareImages(reference, test, options);
  EXPECT_EQ(near.flip, far.flip);
  EXPECT_GT(near.flipGaze.value(), *near.flip);
  EXPECT_LT(far.flipGaze.value(), *far.flip);
}

ImageF pair(float a, float b) {
  return {2, 1, 1, {a, b}};
}

TEST(Flicker, IsChangeThatTheReferenceDoesNotHave) {
  FlickerMeter meter;
  EXPECT_FALSE(meter.next(pair(0.1F, 0.2F), pair(0.5F, 0.2F)));
  // Everything brightens by 0.25, and the error of the first pixel stays: no flicker.
  EXPECT_NEAR(meter.next(pair(0.35F, 0.45F), pair(0.75F, 0.45F)).value(), 0.0, 1e-6);
  // The reference stands; the first pixel falls by 0.4, the second rises by 0.1: mean 0.25.
  EXPECT_NEAR(meter.next(pair(0.35F, 0.45F), pair(0.35F, 0.55F)).value(), 0.25, 1e-6);
  // The reference moves and the test does not.
  EXPECT_NEAR(meter.next(pair(0.85F, 0.45F), pair(0.35F, 0.55F)).value(), 0.25, 1e-6);
}

TEST(Flicker, RefusesOtherSizes) {
  FlickerMeter meter;
  EXPECT_THROW((void)meter.next(pair(0, 0), ImageF{1, 1, 1, {0.0F}}), InputError);
  EXPECT_FALSE(meter.next(pair(0, 0), pair(0, 0)));
  const ImageF one{1, 1, 1, {0.0F}};
  EXPECT_THROW((void)meter.next(one, one), InputError);
}

TEST(ErrorMaps, DifferencesAreScaledByTheir99thPercentile) {
  // Six differences: the largest is at 99 %. 0.05 becomes a quarter of white.
  const DifferenceMap map = differenceMap(pair(0.5F, 0.5F), pair(0.3F, 0.55F));
  EXPECT_NEAR(map.white, 0.2, 1e-6);
  EXPECT_NEAR(map.scale, 5.0, 1e-4);
  EXPECT_EQ(map.image.pixels, (std::vector<std::uint8_t>{255, 255, 255, 64, 64, 64}));
  EXPECT_EQ(differenceMap(pair(0, 0), pair(3.0F, 0)).white, 3.0) << "linear values";
  EXPECT_EQ(differenceMap(pair(0, 0), pair(0.25F, 0.5F), 2.0).image.pixels[0], 128) << "fixed";
  // 1 to 100 hundredths in 100 pixels: the 99th is white, and so is the one beyond.
  ImageF reference{100, 1, 1, std::vector<float>(100, 0.0F)};
  ImageF test = reference;
  for (std::size_t i = 0; i < 100; ++i) test.pixels[i] = static_cast<float>(i + 1) / 100.0F;
  const DifferenceMap ramp = differenceMap(reference, test);
  EXPECT_NEAR(ramp.white, 0.99, 1e-6);
  EXPECT_EQ(ramp.image.pixels.back(), 255);
  EXPECT_EQ(ramp.image.pixels.front(), 3) << "0.01 / 0.99 of 255";
  // One wrong pixel of a thousand is seen.
  reference = ImageF{1000, 1, 1, std::vector<float>(1000, 0.5F)};
  test = reference;
  test.pixels[7] = 0.51F;
  EXPECT_EQ(differenceMap(reference, test).image.pixels[21], 255);
}

TEST(ErrorMaps, EqualImagesHaveNoScale) {
  for (const auto scale : {std::optional<double>(), std::optional<double>(8.0)}) {
    const DifferenceMap equal = differenceMap(pair(1, 1), pair(1, 1), scale);
    EXPECT_EQ(equal.white, 0.0);
    EXPECT_EQ(equal.scale, 1.0);
  }
  EXPECT_NE(colourBars(0.0, "linear").find("no difference"), std::string::npos);
  EXPECT_NE(colourBars(0.125, "linear").find("0.125 and more (linear)"), std::string::npos);
}

TEST(ErrorMaps, FlipIsShownInMagma) {
  Plane map(4, 1);
  map.values = {0.0F, 1.0F, 128.0F / 255.0F, 2.0F};
  const image::Image8 shown = flipImage(map);
  const std::vector<std::uint8_t> ends(shown.pixels.begin(), shown.pixels.begin() + 6);
  EXPECT_EQ(ends, (std::vector<std::uint8_t>{0, 0, 4, 252, 253, 191}));
  // Colour 128 of the published 256 is 183, 55, 121.
  EXPECT_NEAR(shown.pixels[6], 183, 3);
  EXPECT_NEAR(shown.pixels[7], 55, 3);
  EXPECT_NEAR(shown.pixels[8], 121, 3);
  EXPECT_EQ(shown.pixels[9], 252) << "clamped";
}

TEST(ErrorMaps, AreWrittenBesideTheNumbers) {
  const std::filesystem::path folder = std::filesystem::path(macula::test::temporaryPath("maps"));
  std::filesystem::create_directories(folder);
  const std::string a = (folder / "a.png").string();
  const std::string b = (folder / "b.png").string();
  image::writePng(a, {2, 1, 1, {0, 100}});
  image::writePng(b, {2, 1, 1, {51, 100}});
  const auto [error, maps] = compareFilesToMaps(a, b, (folder / "map").string());
  EXPECT_EQ(error.rmse, compareFiles(a, b).rmse);
  EXPECT_EQ(error.flip, compareFiles(a, b).flip);
  EXPECT_NEAR(maps.differenceWhite, 0.2, 1e-6);
  EXPECT_NEAR(maps.differenceScale, 5.0, 1e-4);
  EXPECT_TRUE(std::filesystem::exists(folder / "map_scale.svg"));
  const ImageF difference = image::readImage(folder / "map_difference.png");
  EXPECT_NEAR(difference.pixels[0], 1.0F, 1e-6);
  EXPECT_EQ(image::readImage(folder / "map_flip.png").width, 2);
  EXPECT_THROW((void)compareFilesToMaps(a, b, (folder / "none" / "map").string()), InputError);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace macula::measure
