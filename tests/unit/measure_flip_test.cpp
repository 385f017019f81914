// FLIP and its parts: filters and colour spaces by hand, means against the reference's.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/measure/colour_space.h"
#include "engine/measure/filter.h"
#include "engine/measure/flip.h"

namespace macula::measure {
namespace {

using image::ImageF;

TEST(Filter, CorrelatesWithTheBorderRepeated) {
  Plane plane(3, 1);
  plane.values = {1.0F, 2.0F, 4.0F};
  const std::vector<float> weights = {1.0F, 10.0F, 100.0F};
  EXPECT_EQ(filterRows(plane, weights).values, (std::vector<float>{211.0F, 421.0F, 442.0F}));
  Plane column(1, 3);
  column.values = plane.values;
  EXPECT_EQ(filterColumns(column, weights).values, (std::vector<float>{211.0F, 421.0F, 442.0F}));
}

TEST(Filter, BothWays) {
  Plane plane(3, 3);
  plane.values[4] = 1.0F;
  const std::vector<float> across = {1.0F, 2.0F, 3.0F};
  const std::vector<float> down = {1.0F, 10.0F, 100.0F};
  // Correlation mirrors the kernel around the one lit pixel.
  EXPECT_EQ(filterSeparable(plane, across, down).values,
            (std::vector<float>{300.0F, 200.0F, 100.0F, 30.0F, 20.0F, 10.0F, 3.0F, 2.0F, 1.0F}));
}

TEST(Filter, KernelWiderThanTheImage) {
  Plane plane(1, 1);
  plane.values = {2.0F};
  const std::vector<float> ones(9, 1.0F);
  EXPECT_EQ(filterSeparable(plane, ones, ones).values[0], 162.0F);
}

void expectNear(const Triple& got, const Triple& wanted, float tolerance) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(got[i], wanted[i], tolerance) << i;
}

// Lindbloom's tables for sRGB primaries under D65, and CIE L*a*b* of sRGB's green.
TEST(ColourSpace, KnownColours) {
  expectNear(rgbToXyz({1.0F, 1.0F, 1.0F}), {0.950456F, 1.0F, 1.089058F}, 2e-4F);
  expectNear(rgbToXyz({0.0F, 1.0F, 0.0F}), {0.357576F, 0.715152F, 0.119192F}, 1e-4F);
  expectNear(xyzToLab(rgbToXyz({1.0F, 1.0F, 1.0F})), {100.0F, 0.0F, 0.0F}, 1e-3F);
  expectNear(xyzToLab(rgbToXyz({0.0F, 1.0F, 0.0F})), {87.735F, -86.183F, 83.18F}, 2e-2F);
  expectNear(xyzToLab({0.0F, 0.0F, 0.0F}), {0.0F, 0.0F, 0.0F}, 1e-4F);
  expectNear(xyzToYcxcz(rgbToXyz({1.0F, 1.0F, 1.0F})), {100.0F, 0.0F, 0.0F}, 1e-3F);
}

TEST(ColourSpace, InversesUndo) {
  const Triple rgb = {0.1F, 0.7F, 0.3F};
  expectNear(xyzToRgb(ycxczToXyz(xyzToYcxcz(rgbToXyz(rgb)))), rgb, 1e-5F);
}

ImageF flat(int width, int height, float r, float g, float b) {
  ImageF image{width, height, 3, {}};
  for (int i = 0; i < width * height; ++i) image.pixels.insert(image.pixels.end(), {r, g, b});
  return image;
}

// The farthest pair of colours is 1 by construction; black and white have a city-block distance of
// 100 and the mean that the reference gives.
TEST(Flip, FlatImages) {
  const ImageF black = flat(8, 4, 0.0F, 0.0F, 0.0F);
  EXPECT_EQ(flipMean(black, black), 0.0);
  EXPECT_NEAR(flipMean(flat(8, 4, 0, 1, 0), flat(8, 4, 0, 0, 1)), 1.0, 1e-5);
  EXPECT_NEAR(flipMean(black, flat(8, 4, 1, 1, 1)), 0.967388, 5e-5);
  EXPECT_NEAR(flipMean(black, flat(8, 4, 7, 7, 7)), 0.967388, 5e-5);  // clamped to 1
}

TEST(Flip, AnEdgeThatMovesCountsMoreThanItsColourAlone) {
  ImageF a = flat(32, 32, 0.4F, 0.4F, 0.4F);
  ImageF b = a;
  for (std::size_t i = 16 * 3; i < 17 * 3; ++i) {
    for (std::size_t row = 0; row < 32; ++row) b.pixels[row * 96 + i] = 0.8F;
  }
  const Plane map = flipMap(a, b);
  EXPECT_GT(map.values[16 * 32 + 16], map.values[16 * 32 + 24]);
  EXPECT_NEAR(map.values[16 * 32 + 31], 0.0F, 1e-3F);
}

TEST(Flip, RefusesWhatIsNotDefined) {
  const ImageF image = flat(2, 2, 0, 0, 0);
  EXPECT_THROW((void)flipMean(image, flat(2, 1, 0, 0, 0)), InputError);
  EXPECT_THROW((void)flipMean(image, image, 0.0), InputError);
  EXPECT_THROW((void)flipMean(image, image, 1e9), InputError);
  EXPECT_EQ(flipMean(image, image, 1.0), 0.0);
  EXPECT_EQ(flipMean(image, image, 1000.0), 0.0);
}

struct Pair {
  const char* reference;
  const char* test;
  double pixelsPerDegree;
  double mean;
};

class FlipReference : public testing::TestWithParam<Pair> {};

TEST_P(FlipReference, MeanIsThatOfTheReferenceImplementation) {
  const std::filesystem::path folder = MACULA_SOURCE_DIR "/../shared/data/flip";
  if (!std::filesystem::is_directory(folder)) {
    GTEST_SKIP() << "the FLIP image pairs are not at " << folder;
  }
  const auto& [reference, test, ppd, mean] = GetParam();
  const ImageF a = image::readImage(folder / (std::string(reference) + ".png"));
  const ImageF b = image::readImage(folder / (std::string(test) + ".png"));
  EXPECT_NEAR(flipMean(a, b, ppd), mean, 5e-5);
}

// Means by the authors' implementation, version 1.6.
INSTANTIATE_TEST_SUITE_P(
    AllPairs, FlipReference,
    testing::Values(Pair{"ref", "noise05", kDefaultPixelsPerDegree, 0.093994},
                    Pair{"ref", "blur9", kDefaultPixelsPerDegree, 0.116613},
                    Pair{"ref", "half_box", kDefaultPixelsPerDegree, 0.042227},
                    Pair{"c_black", "c_white", kDefaultPixelsPerDegree, 0.967388},
                    Pair{"c_red", "c_green", kDefaultPixelsPerDegree, 0.986665},
                    Pair{"c_green", "c_blue", kDefaultPixelsPerDegree, 1.000000},
                    Pair{"ref", "noise05", 30.0, 0.168432},
                    Pair{"ref", "noise05", 20.0, 0.216458}));

}  // namespace
}  // namespace macula::measure
