// sRGB, RMSE, PSNR and maximum, on images small enough to work out by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/core/error.h"
#include "engine/measure/compare_files.h"
#include "engine/measure/image_error.h"
#include "engine/measure/srgb.h"
#include "temporary_path.h"

namespace macula::measure {
namespace {

using image::ImageF;

/// 2 x 2 RGB, all components `value`.
ImageF flat(float value) {
  return {2, 2, 3, std::vector<float>(12, value)};
}

constexpr CompareOptions kNoFlip{.flip = false};

// IEC 61966-2-1: the straight part, the knee, and 0.5 -> 1.055 * 0.5^(1/2.4) - 0.055 = 0.735357.
TEST(Srgb, MatchesTheStandard) {
  EXPECT_EQ(encodeSrgb(0.0F), 0.0F);
  EXPECT_FLOAT_EQ(encodeSrgb(0.002F), 0.02584F);
  EXPECT_NEAR(encodeSrgb(0.0031308F), 0.040450F, 1e-6);
  EXPECT_NEAR(encodeSrgb(0.5F), 0.735357F, 1e-6);
  EXPECT_FLOAT_EQ(encodeSrgb(1.0F), 1.0F);
  EXPECT_NEAR(decodeSrgb(0.5F), 0.214041F, 1e-6);
  EXPECT_TRUE(std::isnan(encodeSrgb(std::numeric_limits<float>::quiet_NaN())));
}

TEST(Srgb, DecodingUndoesEncodingForAll8BitValues) {
  for (int i = 0; i < 256; ++i) {
    const float encoded = static_cast<float>(i) / 255.0F;
    EXPECT_EQ(std::lround(encodeSrgb(decodeSrgb(encoded)) * 255.0F), i);
  }
}

TEST(CompareImages, IdenticalHasNoPsnr) {
  const ImageError error = compareImages(flat(0.25F), flat(0.25F));
  EXPECT_EQ(error.rmse, 0.0);
  EXPECT_EQ(error.max, 0.0);
  EXPECT_FALSE(error.psnrDb);
  EXPECT_EQ(error.flip, 0.0);
}

TEST(CompareImages, OneChannelOfOnePixel) {
  // One of 12 values differs by 0.5: mean square 0.25 / 12, PSNR 10 log10(48) = 16.812412.
  ImageF test = flat(0.25F);
  test.pixels[4] = 0.75F;
  const ImageError error = compareImages(flat(0.25F), test, kNoFlip);
  EXPECT_DOUBLE_EQ(error.rmse, std::sqrt(0.25 / 12.0));
  EXPECT_NEAR(error.psnrDb.value(), 16.812412, 1e-6);
  EXPECT_DOUBLE_EQ(error.max, 0.5);
  EXPECT_FALSE(error.flip);
}

TEST(CompareImages, UniformDifference) {
  const ImageError error = compareImages(flat(0.5F), flat(0.25F), kNoFlip);
  EXPECT_DOUBLE_EQ(error.rmse, 0.25);
  EXPECT_NEAR(error.psnrDb.value(), 12.041200, 1e-6);  // 20 log10(4)
}

TEST(CompareImages, AlphaIsLeftOutAndGreyIsThreeChannels) {
  const ImageF rgba{1, 1, 4, {0.5F, 0.5F, 0.5F, 0.0F}};
  const ImageF grey{1, 1, 1, {0.5F}};
  const ImageF greyAlpha{1, 1, 2, {0.25F, 1.0F}};
  EXPECT_EQ(compareImages(rgba, grey, kNoFlip).rmse, 0.0);
  EXPECT_DOUBLE_EQ(compareImages(rgba, greyAlpha, kNoFlip).rmse, 0.25);
}

TEST(CompareImages, LinearKeepsPeakOne) {
  const ImageError error = compareImages(flat(10.0F), flat(12.0F), {.hdr = true});
  EXPECT_DOUBLE_EQ(error.rmse, 2.0);
  EXPECT_NEAR(error.psnrDb.value(), -6.0206, 1e-4);
  EXPECT_TRUE(error.flip.has_value());
}

TEST(CompareImages, RefusesOtherSizesAndValuesThatAreNotFinite) {
  const ImageF wide{4, 1, 3, std::vector<float>(12)};
  EXPECT_THROW((void)compareImages(flat(0.0F), wide), InputError);
  EXPECT_THROW((void)compareImages(ImageF{}, ImageF{}), InputError);
  ImageF broken = flat(0.5F);
  broken.pixels[10] = std::numeric_limits<float>::quiet_NaN();
  try {
    (void)compareImages(flat(0.5F), broken);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "the test image holds a value that is not finite at pixel 1,1; render it again");
  }
}

TEST(ToDisplay, ClampsAndEncodesButNotAlpha) {
  const ImageF linear{1, 1, 4, {-1.0F, 0.5F, 7.0F, 0.5F}, true};
  const ImageF display = toDisplay(linear);
  EXPECT_EQ(display.pixels[0], 0.0F);
  EXPECT_NEAR(display.pixels[1], 0.735357F, 1e-6);
  EXPECT_EQ(display.pixels[2], 1.0F);
  EXPECT_EQ(display.pixels[3], 0.5F);
  EXPECT_FALSE(display.linear);
}

TEST(ImageErrorJson, NullForWhatDoesNotApply) {
  EXPECT_EQ(toJson(ImageError{}).dump(), R"({"flip":null,"max":0.0,"psnr_db":null,"rmse":0.0})");
  EXPECT_EQ(toJson(ImageError{0.5, 6.0, 1.0, 0.25, {}}).dump(),
            R"({"flip":0.25,"max":1.0,"psnr_db":6.0,"rmse":0.5})");
  EXPECT_EQ(toJson(ImageError{0.5, 6.0, 1.0, 0.25, 0.125})["flip_gaze"], 0.125);
}

class CompareFilesTest : public testing::Test {
 protected:
  void TearDown() override {
    std::filesystem::remove(png_);
    std::filesystem::remove(exr_);
  }
  const std::string png_ = macula::test::temporaryPath("compare.png");
  const std::string exr_ = macula::test::temporaryPath("compare.exr");
};

TEST_F(CompareFilesTest, ExrIsEncodedAndPngIsNot) {
  if (!image::hasExr()) GTEST_SKIP() << "this build has no EXR (MACULA_IMAGE_IO=OFF)";
  // Linear 0.5 encodes to 0.735357; the PNG's 187 is 0.733333.
  image::writeExr(exr_, {1, 1, 3, {0.5F, 0.5F, 0.5F}, true});
  image::writePng(png_, {1, 1, 3, {187, 187, 187}});
  const ImageError error = compareFiles(exr_, png_);
  EXPECT_NEAR(error.max, 0.735357 - 187.0 / 255.0, 1e-6);
  EXPECT_TRUE(error.flip.has_value());
  EXPECT_EQ(compareFiles(exr_, exr_, {.hdr = true}).rmse, 0.0);
  EXPECT_THROW((void)compareFiles(exr_, png_, {.hdr = true}), InputError);
}

TEST_F(CompareFilesTest, ErrorsNameTheFiles) {
  image::writePng(png_, {1, 1, 3, {0, 0, 0}});
  EXPECT_THROW((void)compareFiles(png_, png_ + "x"), InputError);
  const std::string other = macula::test::temporaryPath("other.png");
  image::writePng(other, {2, 1, 3, {0, 0, 0, 0, 0, 0}});
  try {
    (void)compareFiles(png_, other);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), png_ + " and " + other +
                                ": the reference is 1 x 1 pixels and the test 2 x 1; compare "
                                "images of one size");
  }
  std::filesystem::remove(other);
}

}  // namespace
}  // namespace macula::measure
