#include "engine/measure/hazards.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <stdexcept>

namespace macula::measure {
namespace {

image::Image8 pattern() {
  image::Image8 image{17, 11, 3, {}};
  for (int i = 0; i < 17 * 11 * 3; ++i) {
    image.pixels.push_back(static_cast<std::uint8_t>(i * 31 % 256));
  }
  return image;
}

TEST(UnlikePixels, EqualImagesHaveNone) {
  EXPECT_EQ(countUnlikePixels(pattern(), pattern()), 0U);
  EXPECT_EQ(countUnlikePixels({}, {}), 0U);
}

TEST(UnlikePixels, EveryCorruptedPixelCountsOnce) {
  std::mt19937 random(1);
  std::set<std::size_t> corrupted;
  image::Image8 damaged = pattern();
  for (int i = 0; i < 40; ++i) {
    const std::size_t pixel = random() % (17 * 11);
    if (!corrupted.insert(pixel).second) continue;
    // One step in one channel, or all three.
    damaged.pixels[3 * pixel + random() % 3] ^= 1U;
    if (random() % 2 == 0) {
      for (std::size_t c = 0; c < 3; ++c) damaged.pixels[3 * pixel + c] ^= 0x80U;
    }
    EXPECT_EQ(countUnlikePixels(pattern(), damaged), corrupted.size());
    EXPECT_EQ(countUnlikePixels(damaged, pattern()), corrupted.size());
  }
}

TEST(UnlikePixels, TheFirstAndTheLastCount) {
  image::Image8 damaged = pattern();
  damaged.pixels.front() ^= 1U;
  damaged.pixels.back() ^= 1U;
  EXPECT_EQ(countUnlikePixels(pattern(), damaged), 2U);
}

TEST(UnlikePixels, OtherSizesAreRefused) {
  image::Image8 turned = pattern();
  std::swap(turned.width, turned.height);
  EXPECT_THROW((void)countUnlikePixels(pattern(), turned), std::invalid_argument);
}

}  // namespace
}  // namespace macula::measure
